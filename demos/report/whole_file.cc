#include "report/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace dgd_demos {
namespace {

constexpr const char* kPartExtension = ".part";

}  // namespace

std::FILE* CreateFile(const std::filesystem::path& file) {
  using Type = std::filesystem::file_type;
  const Type there = std::filesystem::symlink_status(file).type();
  if (there == Type::directory) {
    errno = EISDIR;
    return nullptr;
  }
  if (there != Type::not_found && there != Type::regular) {
    throw std::runtime_error(file.string() + ": is a link, a pipe or a device, which is not written to");
  }
  if (there == Type::regular && unlink(file.c_str()) != 0) return nullptr;
  constexpr mode_t kAsTheUserWants = 0666;  // Less the umask.
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kAsTheUserWants);
  return descriptor < 0 ? nullptr : fdopen(descriptor, "w+b");
}

void WriteWholeFile(const std::filesystem::path& file, std::string_view content) {
  // Processes of several machines may write the same file at once.
  char host[256] = {};
  gethostname(host, sizeof host - 1);
  const std::string part = file.string() + "." + host + "." + std::to_string(getpid()) + kPartExtension;
  const auto fail = [&] {
    const std::string reason = std::strerror(errno);
    std::remove(part.c_str());
    throw std::runtime_error(file.string() + ": cannot be written: " + reason);
  };
  std::FILE* stream = CreateFile(part);
  if (stream == nullptr) fail();
  const bool is_written = std::fwrite(content.data(), 1, content.size(), stream) == content.size() &&
                          std::fflush(stream) == 0 && fsync(fileno(stream)) == 0;
  const bool is_closed = std::fclose(stream) == 0;
  if (!is_written || !is_closed || std::rename(part.c_str(), file.c_str()) != 0) fail();
}

void RemoveParts(const std::filesystem::path& file) {
  std::error_code error;  // What cannot be removed is in nobody's way.
  for (std::filesystem::directory_iterator entry(file.parent_path(), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    std::error_code ignored;
    if (path.extension() == kPartExtension && path.filename().string().starts_with(file.filename().string() + ".")) {
      std::filesystem::remove(path, ignored);
    }
  }
}

std::string ReadWholeFile(const std::filesystem::path& file) {
  // A stream opens a folder, and fails with a message that does not name it.
  if (std::filesystem::is_directory(file)) throw std::runtime_error(file.string() + ": is a folder");
  std::ifstream stream(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  return content;
}

std::string HashOf(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string HashOfSizeAndEnd(const std::filesystem::path& file) {
  constexpr std::uintmax_t kMost = 1 << 16;  // Bytes.
  const std::uintmax_t size = std::filesystem::file_size(file);
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(size - std::min(size, kMost)));
  const std::string end{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  return std::to_string(size) + " bytes " + HashOf(end);
}

}  // namespace dgd_demos
