#include "report/csv_file.h"

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace dgd_demos {

CsvFile::CsvFile(const std::filesystem::path& file, OpenMode mode)
    : file_(file), stream_(file, mode == OpenMode::kCreate ? std::ios::out : std::ios::out | std::ios::app) {
  CheckWritten();
  stream_.precision(std::numeric_limits<double>::max_digits10);
}

void CsvFile::Flush() {
  stream_.flush();
  CheckWritten();
}

void CsvFile::Serialize(StateArchive& archive) {
  Flush();
  SerializeFileSize(archive, file_);
}

void CsvFile::CheckWritten() const {
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace dgd_demos
