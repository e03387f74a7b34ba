// A file of numbers that read back to the bit, and whose rows survive a crash.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

#include "checkpoint/continued_file.h"

namespace dgd_demos {

class CsvFile {
 public:
  /// @throws std::runtime_error with the reason if it cannot be written.
  explicit CsvFile(const std::filesystem::path& file, OpenMode mode = OpenMode::kCreate);

  /// Writes numbers with 17 significant digits.
  std::ostream& stream() { return stream_; }

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
