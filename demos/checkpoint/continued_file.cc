#include "checkpoint/continued_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace dgd_demos {

std::uint64_t SerializeFileSize(StateArchive& archive, const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) archive.Fail(file.string() + " cannot be continued: " + std::strerror(errno));
  const auto size_there = static_cast<std::uint64_t>(lseek(descriptor, 0, SEEK_END));
  std::uint64_t size = size_there;
  archive.Serialize(size);
  const bool is_long_enough = size <= size_there;
  const bool is_done = is_long_enough && (archive.is_reading() ? ftruncate(descriptor, static_cast<off_t>(size))
                                                               : fsync(descriptor)) == 0;
  const std::string reason = is_long_enough ? std::strerror(errno) : "it is shorter than it was at the checkpoint";
  close(descriptor);
  if (!is_done) archive.Fail(file.string() + " cannot be continued: " + reason);
  return size;
}

}  // namespace dgd_demos
