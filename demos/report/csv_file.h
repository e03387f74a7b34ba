// A file of numbers that read back to the bit, and whose rows survive a crash.
#pragma once

#include <concepts>
#include <filesystem>
#include <fstream>
#include <string>

#include "checkpoint/continued_file.h"

namespace dgd_demos {

/// The fewest digits that read back to the number's bits.
std::string TextOf(double number);

class CsvFile {
 public:
  /// @throws std::runtime_error with the reason if it cannot be written.
  explicit CsvFile(const std::filesystem::path& file, OpenMode mode = OpenMode::kCreate);

  CsvFile& operator<<(double number) { return *this << TextOf(number); }
  /// Adds anything else, text as it is.
  template <class Text>
  requires(!std::floating_point<Text>) CsvFile& operator<<(const Text& text) {
    stream_ << text;
    return *this;
  }

  /// Hands what was written to the operating system.
  /// @throws std::runtime_error if that fails, as on a full disk.
  void Flush();

  void Serialize(StateArchive& archive);

 private:
  void CheckWritten() const;

  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace dgd_demos
