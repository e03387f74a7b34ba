#include "report/csv_file.h"

#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace dgd_demos {

CsvFile::CsvFile(const std::filesystem::path& file) : file_(file), stream_(file) {
  CheckWritten();
  stream_.precision(std::numeric_limits<double>::max_digits10);
}

void CsvFile::Flush() {
  stream_.flush();
  CheckWritten();
}

void CsvFile::CheckWritten() const {
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written: " + std::strerror(errno));
}

}  // namespace dgd_demos
