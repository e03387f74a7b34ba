#include "sweep/sweep_command.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "report/progress_bar.h"
#include "report/whole_file.h"
#include "scene/scene_error.h"
#include "simulation/narrowphase.h"
#include "stop_signals.h"
#include "sweep/local_workers.h"
#include "sweep/study.h"
#include "sweep/study_folder.h"
#include "sweep/study_report.h"
#ifdef DGD_DEMOS_MPI
#include "sweep/mpi_workers.h"
#endif

namespace dgd_demos {
namespace {

// The runs of the study that this process carries out.
std::vector<RunSpec> PendingRuns(const Study& study, const std::map<int, RunRecord>& records,
                                 const SweepOptions& options) {
  std::vector<RunSpec> pending;
  for (const RunSpec& run : study.runs) {
    if (run.number % options.shards != options.shard) continue;
    const auto record = records.find(run.number);
    const bool is_done =
        record != records.end() && !(options.retry_failed && record->second.status == RunRecord::Status::kFailed);
    if (!is_done) pending.push_back(run);
  }
  return pending;
}

// Carries out the runs, and writes each record as soon as its run ends.
void CarryOut(const std::vector<RunSpec>& runs, Workers& workers, const StudyFolder& folder) {
  // Short: when a sweep is stopped, mpirun leaves it one second to write its results.
  constexpr std::chrono::milliseconds kPatience(100);
  ProgressBar progress(std::to_string(runs.size()) + " runs", static_cast<double>(runs.size()));
  std::size_t started = 0, done = 0;
  while (done < runs.size() && !IsStopRequested()) {
    while (started < runs.size() && workers.idle() > 0) workers.Start(runs[started++]);
    const std::optional<RunRecord> record = workers.Wait(kPatience);
    if (record && !IsStopRequested()) {
      folder.Write(*record);
      ++done;
    }
    progress.Update(static_cast<double>(done));
  }
}

ExitStatus Report(const Study& study, const StudyFolder& folder, const SweepOptions& options) {
  const std::map<int, RunRecord> records = folder.ReadRecords();
  WriteWholeFile(folder.path() / "runs.csv", StudyCsv(study, records));
  const std::string tables = StudyTables(study, records);
  WriteWholeFile(folder.path() / "tables.txt", tables);

  constexpr std::ptrdiff_t kMostLines = 400;  // The most that people read on a terminal.
  if (std::ranges::count(tables, '\n') <= kMostLines) {
    std::printf("%s", tables.c_str());
  } else {
    std::printf("The tables are in %s\n", (folder.path() / "tables.txt").c_str());
  }
  std::printf("%zu of %zu runs are done; a row each is in %s\n", records.size(), study.runs.size(),
              (folder.path() / "runs.csv").c_str());
  const bool is_complete = std::ranges::all_of(study.runs, [&](const RunSpec& run) {
    return (options.merge.empty() && run.number % options.shards != options.shard) || records.contains(run.number);
  });
  if (!is_complete) return kInterrupted;
  const bool all_well =
      std::ranges::all_of(records, [](const auto& entry) { return entry.second.status == RunRecord::Status::kDone; });
  return all_well ? kSuccess : kLostBody;
}

// Options of the plugin cannot be checked without Bullet, and LoadStudy() has none.
void CheckNarrowphases(const Study& study) {
  for (std::size_t i = 0; i < study.narrowphases.size(); ++i) {
    try {
      NarrowphaseChoice::Named(study.narrowphases[i]);
    } catch (const std::invalid_argument& error) {
      throw SceneError(study.file + ": /narrowphases/" + std::to_string(i) + ": " + error.what());
    }
  }
}

ExitStatus SweepWith(Workers& workers, const SweepOptions& options) {
  const Study study = LoadStudy(options.study, BulletPrecision());
  CheckNarrowphases(study);
  const StudyFolder folder(options.out, study);
  for (const std::string& other : options.merge) {
    if (!std::filesystem::exists(std::filesystem::path(other) / "runs")) {
      throw std::runtime_error("--merge: " + other + " has no results of a study");
    }
    folder.TakeFrom(StudyFolder(other, study));
  }
  const StopSignals stop_signals;
  if (options.merge.empty()) {
    CarryOut(PendingRuns(study, folder.ReadRecords(), options), workers, folder);
  }
  return Report(study, folder, options);
}

}  // namespace

ExitStatus Sweep(const SweepOptions& options) {
#ifdef DGD_DEMOS_MPI
  if (options.merge.empty() && IsStartedByMpi()) {
    const MpiSession session;
    if (session.rank() != 0) {
      ServeRuns();
      return kSuccess;
    }
    const std::unique_ptr<Workers> workers = MakeMpiWorkers(session);
    return SweepWith(*workers, options);
  }
#endif
  LocalWorkers workers(options.jobs);
  return SweepWith(workers, options);
}

}  // namespace dgd_demos
