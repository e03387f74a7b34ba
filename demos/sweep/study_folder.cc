#include "sweep/study_folder.h"

#include <cstdio>
#include <set>
#include <stdexcept>

#include "report/output_folder.h"
#include "report/whole_file.h"
#include "scene/world_hash.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

// The study, what its worlds were when it began, and the precisions, which may be those of the program.
json IdentityOf(const Study& study) {
  json worlds = json::object();
  std::set<std::string> precisions;
  for (const RunSpec& run : study.runs) {
    if (!worlds.contains(run.world)) worlds[run.world] = HashOfWorld(run.file);
    precisions.insert(run.precision);
  }
  return {{"study", study.document}, {"worlds", worlds}, {"precisions", precisions}, {"runs", study.runs.size()}};
}

}  // namespace

StudyFolder::StudyFolder(const std::filesystem::path& folder, const Study& study) : folder_(folder) {
  MakeOutputFolder(folder_ / "runs");
  const std::filesystem::path file = folder_ / "study.json";
  const json identity = IdentityOf(study);
  if (!std::filesystem::exists(file)) {
    const auto is_there = [&](const char* name) {
      return std::filesystem::exists(std::filesystem::symlink_status(folder_ / name));
    };
    if (is_there("runs.csv") || is_there("tables.txt") || !std::filesystem::is_empty(folder_ / "runs")) {
      throw std::runtime_error(folder_.string() + ": has results, and no study.json; choose another folder");
    }
    WriteWholeFile(file, identity.dump(2) + "\n");
    return;
  }
  const json there = json::parse(ReadWholeFile(file), nullptr, /*allow_exceptions=*/false);
  if (there == identity) return;
  const bool same_study = there.is_object() && there.value("study", json()) == study.document;
  throw std::runtime_error(
      folder_.string() + ": has runs of " +
      (same_study ? "this study in another precision, or with worlds that have changed since" : "another study") +
      "; choose another folder, or remove this one");
}

std::filesystem::path StudyFolder::FileOf(int number) const {
  char name[32];
  std::snprintf(name, sizeof name, "%06d.json", number);
  return folder_ / "runs" / name;
}

std::map<int, RunRecord> StudyFolder::ReadRecords() const {
  std::map<int, RunRecord> records;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "runs")) {
    if (entry.path().extension() != ".json") continue;  // Left by a process that died while it wrote.
    try {
      const RunRecord record = ParseRunRecord(ReadWholeFile(entry.path()));
      if (entry.path() != FileOf(record.number)) throw std::runtime_error("is of another run");
      records.emplace(record.number, record);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(entry.path().string() + ": is damaged; remove it, and its run is done again (" +
                               error.what() + ")");
    }
  }
  return records;
}

void StudyFolder::Write(const RunRecord& record) const { WriteWholeFile(FileOf(record.number), ToLine(record) + "\n"); }

void StudyFolder::TakeFrom(const StudyFolder& other) const {
  for (const auto& [number, record] : other.ReadRecords()) Write(record);
}

}  // namespace dgd_demos
