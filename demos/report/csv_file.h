// A file of numbers that read back to the bit, and whose rows survive a crash.
#pragma once

#include <concepts>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "checkpoint/continued_file.h"

namespace dgd_demos {

/// The fewest digits that read back to the number's bits.
std::string TextOf(double number);

class CsvFile {
 public:
  /// @throws std::runtime_error with the reason if it cannot be written.
  explicit CsvFile(const std::filesystem::path& file, OpenMode mode = OpenMode::kCreate);

  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  CsvFile& operator<<(double number) { return *this << TextOf(number); }
  template <std::integral Integer>
  CsvFile& operator<<(Integer number) {
    return *this << std::to_string(number);
  }
  CsvFile& operator<<(char letter) { return *this << std::string_view(&letter, 1); }
  /// Adds text as it is.
  CsvFile& operator<<(std::string_view text);

  /// Hands what was written to the operating system.
  /// @throws std::runtime_error if that fails, as on a full disk.
  void Flush();

  void Serialize(StateArchive& archive);

 private:
  [[noreturn]] void Fail(const char* action) const;

  std::filesystem::path file_;
  std::FILE* stream_;
};

}  // namespace dgd_demos
