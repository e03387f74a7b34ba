#include "report/output_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "report/whole_file.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

// Files and links in the folder with names that the results may have.
std::vector<std::filesystem::path> OwnFilesIn(const Results& results) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(results.folder)) {
    const bool is_folder = std::filesystem::is_directory(entry.symlink_status());
    if (!is_folder && results.is_own(entry.path().filename().string())) files.push_back(entry.path());
  }
  return files;
}

// "the results of another run, with --seed 1, not 2".
std::string DifferenceTo(const json& identity, const json& other) {
  for (const auto& [name, value] : identity.items()) {
    const json there = other.value(name, json());
    if (there != value)
      return "the results of another run, with " + name + " " + there.dump() + ", not " + value.dump();
  }
  return "the results of a run of another program";
}

// What is there that is not of these results; empty if nothing is.
std::string OthersIn(const Results& results, const std::vector<std::filesystem::path>& own_files) {
  const std::filesystem::path label = results.folder / results.label;
  if (!std::filesystem::is_regular_file(label)) {
    return own_files.empty() ? "" : own_files.front().filename().string() + ", and no " + results.label;
  }
  const auto is_flat = [](int depth, json::parse_event_t, json&) { return depth <= 2; };
  const json there = json::parse(ReadWholeFile(label), is_flat, /*allow_exceptions=*/false);
  if (!there.is_object()) return "a " + results.label + " that is damaged";
  return there == results.identity ? "" : DifferenceTo(results.identity, there);
}

}  // namespace

void ClaimFolder(const Results& results, bool replaces_others) {
  MakeOutputFolder(results.folder);
  const std::vector<std::filesystem::path> own_files = OwnFilesIn(results);
  const std::string others = OthersIn(results, own_files);
  if (!others.empty() && !replaces_others) {
    throw std::runtime_error(results.folder.string() + ": has " + others +
                             "; choose another folder with --out, or replace what is there with --overwrite");
  }
  if (!others.empty()) {
    std::cerr << results.folder.string() << ": had " << others << "; replaced\n";
    for (const std::filesystem::path& file : own_files) std::filesystem::remove(file);
  }
  WriteWholeFile(results.folder / results.label, results.identity.dump(2) + "\n");
}

void MakeOutputFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": the folder cannot be made: " + error.message());
}

// A file system without locks grants it.
FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw std::runtime_error(folder.string() + ": another process writes its results there");
}

FolderLock::~FolderLock() { close(descriptor_); }

}  // namespace dgd_demos
