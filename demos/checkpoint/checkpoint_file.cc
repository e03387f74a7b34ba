#include "checkpoint/checkpoint_file.h"

#include <stdexcept>
#include <string>
#include <string_view>

#include "report/whole_file.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

// The file: this line, the hash of what follows, a line of JSON, the state's bytes.
const std::string kMagic = "dgd-bullet checkpoint 2\n";

constexpr const char* kStartsOver = "; without --resume, the run starts from the beginning";

std::string HashLine(std::string_view content) { return HashOf(content) + "\n"; }

[[noreturn]] void Fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

void CheckIsOf(const json& run, const json& written, const std::filesystem::path& file) {
  for (const auto& [name, value] : run.items()) {
    const json other = written.is_object() ? written.value(name, json()) : json();
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
  const std::string bytes = ReadWholeFile(file);
  if (!bytes.starts_with(kMagic)) Fail(file, std::string("is damaged, or of another version") + kStartsOver);
  const std::size_t content = kMagic.size() + HashLine("").size();
  if (bytes.size() < content ||
      bytes.substr(kMagic.size(), content - kMagic.size()) != HashLine(bytes.substr(content))) {
    Fail(file, std::string("is damaged") + kStartsOver);
  }
  const std::size_t end_of_run = bytes.find('\n', content);
  CheckIsOf(run, json::parse(bytes.substr(content, end_of_run - content)), file);
  return StateArchive(bytes.substr(end_of_run + 1), file.string());
}

}  // namespace dgd_demos
