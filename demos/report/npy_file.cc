#include "report/npy_file.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace dgd_demos {
namespace {

static_assert(std::endian::native == std::endian::little, "the head says so");

constexpr std::size_t kNumberSize = 8;   // Bytes.
constexpr std::size_t kHeadSize = 1024;  // Bytes: room for any count, and a multiple of 64, as NumPy wants it.

}  // namespace

NpyFile::NpyFile(const std::filesystem::path& file, std::vector<Column> columns, std::size_t rows_of_a_record,
                 OpenMode mode)
    : file_(file), columns_(std::move(columns)), rows_of_a_record_(rows_of_a_record) {
  for (const Column& column : columns_) row_size_ += kNumberSize * static_cast<std::size_t>(column.size);
  stream_ = OpenFile(file, mode);
  if (stream_ == nullptr) Fail(mode == OpenMode::kCreate ? "written" : "continued");
  if (mode == OpenMode::kCreate) Flush();
}

NpyFile::~NpyFile() {
  if (stream_ != nullptr) std::fclose(stream_);
}

void NpyFile::Add(double number) {
  const char* const bytes = reinterpret_cast<const char*>(&number);
  buffer_.insert(buffer_.end(), bytes, bytes + kNumberSize);
}

void NpyFile::AddInteger(std::int64_t number) {
  const char* const bytes = reinterpret_cast<const char*>(&number);
  buffer_.insert(buffer_.end(), bytes, bytes + kNumberSize);
}

void NpyFile::Add(std::initializer_list<double> numbers) {
  for (const double number : numbers) Add(number);
}

std::string NpyFile::Description(const std::vector<Column>& columns) {
  std::string types;
  for (const Column& column : columns) {
    types += std::string("('") + column.name + "', '" + (column.is_integer ? "<i8" : "<f8") + "'";
    if (column.size > 1) types += ", (" + std::to_string(column.size) + ",)";
    types += "), ";
  }
  return "[" + types + "]";
}

// Version 1.0 of the format: a magic number, the length of what follows, and a dictionary of Python's.
std::string NpyFile::Head() const {
  const std::size_t rows = written_ / row_size_;
  const std::string shape = rows_of_a_record_ == 0
                                ? std::to_string(rows) + ","
                                : std::to_string(rows / rows_of_a_record_) + ", " + std::to_string(rows_of_a_record_);
  const std::string dictionary =
      "{'descr': " + Description(columns_) + ", 'fortran_order': False, 'shape': (" + shape + "), }";
  constexpr std::size_t kPrefix = 10;
  constexpr std::size_t kLength = kHeadSize - kPrefix;
  std::string head("\x93NUMPY\x01\x00", 8);
  head += static_cast<char>(kLength & 0xff);
  head += static_cast<char>(kLength >> 8);
  head += dictionary;
  head.resize(kHeadSize - 1, ' ');
  return head + '\n';
}

void NpyFile::Flush() {
  const long end = static_cast<long>(kHeadSize + written_);
  const bool is_added = std::fseek(stream_, end, SEEK_SET) == 0 &&
                        std::fwrite(buffer_.data(), 1, buffer_.size(), stream_) == buffer_.size() &&
                        std::fflush(stream_) == 0;
  if (!is_added) Fail();
  written_ += buffer_.size();
  buffer_.clear();
  const std::string head = Head();
  const bool is_counted = std::fseek(stream_, 0, SEEK_SET) == 0 &&
                          std::fwrite(head.data(), 1, head.size(), stream_) == head.size() && std::fflush(stream_) == 0;
  if (!is_counted) Fail();
}

void NpyFile::Serialize(StateArchive& archive) {
  if (!archive.is_reading()) Flush();
  written_ = SerializeContinuedFile(archive, file_, kHeadSize) - kHeadSize;
  const std::size_t record = row_size_ * std::max<std::size_t>(rows_of_a_record_, 1);
  archive.Require(written_ % record == 0, "a file ended within a record");
  Flush();
}

void NpyFile::Fail(const char* action) const {
  throw std::runtime_error(file_.string() + ": cannot be " + action + ": " + std::strerror(errno));
}

}  // namespace dgd_demos
