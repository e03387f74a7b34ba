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

CsvFile::CsvFile(const std::filesystem::path& file, OpenMode mode) : file_(file), stream_(OpenFile(file, mode)) {
  if (stream_ == nullptr) Fail(mode == OpenMode::kCreate ? "written" : "continued");
  if (std::fseek(stream_, 0, SEEK_END) != 0) Fail("written");
}

CsvFile::~CsvFile() { std::fclose(stream_); }

CsvFile& CsvFile::operator<<(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stream_);  // Flush() tells whether it could.
  return *this;
}

void CsvFile::Flush() {
  if (std::fflush(stream_) != 0 || std::ferror(stream_) != 0) Fail("written");
}

void CsvFile::Serialize(StateArchive& archive) {
  Flush();
  SerializeContinuedFile(archive, file_);
  if (std::fseek(stream_, 0, SEEK_END) != 0) Fail("continued");
}

void CsvFile::Fail(const char* action) const {
  throw std::runtime_error(file_.string() + ": cannot be " + action + ": " + std::strerror(errno));
}

}  // namespace dgd_demos
