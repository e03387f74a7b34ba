#include "checkpoint/checkpoint_file.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "report/whole_file.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kGreatestCheckpoint = std::uintmax_t(4) << 30;  // Bytes.

// The file: this line, the hash of what follows, a line of JSON, the state's bytes.
const std::string kMagic = "dgd-bullet checkpoint 3\n";

constexpr const char* kStartsOver = "; without --resume, the run starts from the beginning";

std::string HashLine(std::string_view content) { return HashOf(content) + "\n"; }

[[noreturn]] void Fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

void CheckIsOf(const json& run, const json& written, const std::filesystem::path& file) {
  for (const auto& [name, value] : run.items()) {
    const json other = written.value(name, json());
    if (other != value) {
      Fail(file, "is of a run with " + name + " " + other.dump() + ", not " + value.dump() + kStartsOver);
    }
  }
}

}  // namespace

void WriteCheckpoint(const std::filesystem::path& file, const json& run, const StateArchive& state) {
  const std::string content = run.dump() + "\n" + state.bytes();
  WriteWholeFile(file, kMagic + HashLine(content) + content);
}

std::optional<StateArchive> ReadCheckpoint(const std::filesystem::path& file, const json& run) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  if (!std::filesystem::is_directory(file) && !std::filesystem::is_regular_file(file)) {
    Fail(file, "is no regular file");
  }
  if (std::filesystem::is_regular_file(file) && std::filesystem::file_size(file) > kGreatestCheckpoint) {
    Fail(file, "is larger than " + std::to_string(kGreatestCheckpoint) + " bytes");
  }
  const std::string bytes = ReadWholeFile(file);
  if (!bytes.starts_with(kMagic)) Fail(file, std::string("is damaged, or of another version") + kStartsOver);
  const std::size_t content = kMagic.size() + HashLine("").size();
  if (bytes.size() < content ||
      bytes.substr(kMagic.size(), content - kMagic.size()) != HashLine(bytes.substr(content))) {
    Fail(file, std::string("is damaged") + kStartsOver);
  }
  const std::size_t end_of_run = bytes.find('\n', content);
  // Values of a run are no lists, and not as deep as what overflows the stack.
  const auto is_flat = [](int depth, json::parse_event_t, json&) { return depth <= 1; };
  const json written = json::parse(bytes.substr(content, end_of_run - content), is_flat, /*allow_exceptions=*/false);
  if (end_of_run == std::string::npos || !written.is_object()) Fail(file, std::string("is damaged") + kStartsOver);
  CheckIsOf(run, written, file);
  return StateArchive(bytes.substr(end_of_run + 1), file.string());
}

}  // namespace dgd_demos
