#include "report/csv_file.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace dgd_demos {

// Not by a stream, which takes several times as long.
std::string TextOf(double number) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.begin(), digits.end(), number).ptr};
}

CsvFile::CsvFile(const std::filesystem::path& file, OpenMode mode) : file_(file) {
  if (mode == OpenMode::kContinue && !std::filesystem::exists(file)) {  // Else it would be made.
    throw std::runtime_error(file.string() + ": cannot be continued: it does not exist");
  }
  stream_.open(file, mode == OpenMode::kCreate ? std::ios::out : std::ios::out | std::ios::app);
  CheckWritten();
}

void CsvFile::Flush() {
  stream_.flush();
  CheckWritten();
}

void CsvFile::Serialize(StateArchive& archive) {
  Flush();
  SerializeContinuedFile(archive, file_);
}

void CsvFile::CheckWritten() const {
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace dgd_demos
