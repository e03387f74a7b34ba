#include "report/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace dgd_demos {
namespace {

constexpr const char* kPartExtension = ".part";

}  // namespace

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
  std::FILE* stream = std::fopen(part.c_str(), "wb");
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

}  // namespace dgd_demos
