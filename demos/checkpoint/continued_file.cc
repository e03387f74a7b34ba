#include "checkpoint/continued_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "report/whole_file.h"

namespace dgd_demos {
namespace {

// Enough to tell another run's file, and soon read of a file of any size.
constexpr std::uint64_t kHashedEnd = 1 << 16;  // Bytes.

// A regular file that is no link; below 0 if there is none.
int OpenToContinue(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  struct stat status = {};
  if (descriptor < 0 || (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))) return descriptor;
  close(descriptor);
  errno = EINVAL;
  return -1;
}

// Of the bytes before `size`, without those of the head; empty if they cannot be read.
std::string HashOfEnd(int descriptor, std::uint64_t size, std::uint64_t head) {
  const std::uint64_t begin = std::max(head, size - std::min(size, kHashedEnd));
  std::string end(size - std::min(size, begin), '\0');
  const ssize_t count = pread(descriptor, end.data(), end.size(), static_cast<off_t>(begin));
  return count == static_cast<ssize_t>(end.size()) ? HashOf(end) : "";
}

}  // namespace

std::FILE* OpenFile(const std::filesystem::path& file, OpenMode mode) {
  if (mode == OpenMode::kCreate) return CreateFile(file);
  const int descriptor = OpenToContinue(file);
  return descriptor < 0 ? nullptr : fdopen(descriptor, "r+b");
}

std::uint64_t SerializeContinuedFile(StateArchive& archive, const std::filesystem::path& file, std::uint64_t head) {
  const int descriptor = OpenToContinue(file);
  const auto fail = [&](const std::string& reason) {
    if (descriptor >= 0) close(descriptor);
    archive.Fail(file.string() + " cannot be continued: " + reason);
  };
  if (descriptor < 0) fail(std::strerror(errno));
  const auto size_there = static_cast<std::uint64_t>(lseek(descriptor, 0, SEEK_END));
  std::uint64_t size = size_there;
  archive.Serialize(size);
  if (size < head) fail("it was shorter than its head at the checkpoint");
  if (size > size_there) fail("it is shorter than it was at the checkpoint");
  const std::string hash_there = HashOfEnd(descriptor, size, head);
  std::string hash = hash_there;
  archive.Serialize(hash);
  if (hash_there.empty()) fail("its end cannot be read");
  if (hash != hash_there) fail("it is not what it was at the checkpoint");
  const int error = archive.is_reading() ? ftruncate(descriptor, static_cast<off_t>(size)) : fsync(descriptor);
  if (error != 0) fail(std::strerror(errno));
  close(descriptor);
  return size;
}

}  // namespace dgd_demos
