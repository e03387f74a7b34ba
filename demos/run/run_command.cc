#include "run/run_command.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/off_screen.h"
#include "report/comparison_table.h"
#include "report/output_folder.h"
#include "report/pictures.h"
#include "run/recorded_run.h"
#include "run/world_source.h"
#include "scene/world_hash.h"
#include "simulation/drop_run.h"
#include "stop_signals.h"

namespace dgd_demos {
namespace {

// A stopped run has no table: its figures would not be those of a run to the end.
void PrintStop(const RecordedRun& run, const RunOptions& options) {
  std::fprintf(stderr, "Stopped at %g s of the simulation. %s\n", run.time(),
               options.checkpoint_interval
                   ? "The same command with --resume continues the run."
                   : "Files are complete up to there; only runs with --checkpoint can be continued.");
}

bool IsFileOfRun(const std::string& name) {
  if (name == "summary.csv" || name == "bodies.csv" || name == "end_state.png") return true;
  for (const Narrowphase narrowphase : {Narrowphase::kBuiltin, Narrowphase::kDgd}) {
    const std::string_view begin = NameOf(narrowphase);
    if (!name.starts_with(begin)) continue;
    const std::string end = name.substr(begin.size());
    if (end.starts_with("_") && IsPictureName(end.substr(1))) return true;
    const auto ends = {".csv", ".rec", ".checkpoint", "_trajectory.npy", "_contacts.npy"};
    return std::ranges::find(ends, end) != ends.end();
  }
  return false;
}

Results ResultsOf(const RunOptions& options, const WorldSource& source) {
  const nlohmann::json time_step = options.time_step ? nlohmann::json(*options.time_step) : nlohmann::json();
  return {options.out,
          "run.json",
          {{"world", options.world.filename().string() + " " + HashOfWorld(options.world)},
           {"narrowphases", options.narrowphases},
           {"precision", BulletPrecision()},
           {"duration", source.duration()},
           {"--time-step", time_step},
           {"--seed", options.seed},
           {"--oracle-every", options.oracle_every},
           {"--sample-every", options.sample_interval}},
          IsFileOfRun};
}

void Draw(const WorldSource& source, const std::vector<NamedRun>& runs, const RunOptions& options) {
  const WorldView view = source.View();
  if (view.bodies.empty()) return;
  WritePictures(view, source.scene() ? std::optional(options.seed) : std::nullopt, runs, options.out);
}

}  // namespace

ExitStatus Run(const RunOptions& options) {
  const WorldSource source({options.world, options.seed, options.duration, options.time_step});
  const StopSignals stop_signals;  // What reads a world ends as any program does.
  for (const std::string& remark : source.remarks()) std::fprintf(stderr, "%s\n", remark.c_str());
  std::vector<NarrowphaseChoice> narrowphases;
  for (const std::string& name : options.narrowphases) narrowphases.push_back(NarrowphaseChoice::Named(name));
  if (options.draw_snapshots) LoadOsMesa();  // A program that cannot draw says so before it has run for hours.
  MakeOutputFolder(options.out);
  const FolderLock lock(options.out);
  ClaimFolder(ResultsOf(options, source), options.overwrite);

  std::vector<NamedRun> runs;
  std::vector<TableColumn> columns;
  for (const NarrowphaseChoice& narrowphase : narrowphases) {
    RecordedRun run(source, narrowphase, options);
    run.Run();
    if (!run.IsDone()) {
      PrintStop(run, options);
      return kInterrupted;
    }
    runs.push_back({narrowphase.kind, run.Result()});
    columns.push_back({std::string(NameOf(narrowphase.kind)), {FiguresOf(runs.back().run.summary)}});
  }

  WriteTableCsv(options.out / "summary.csv", columns);
  std::printf("%s, seed %llu, Bullet in %s precision\n\n%s\n", options.world.c_str(),
              static_cast<unsigned long long>(options.seed), BulletPrecision(), FormatTable(columns).c_str());
  std::fflush(stdout);  // Before the pictures, which take their time.
  if (options.draw_snapshots) Draw(source, runs, options);
  if (IsStopRequested()) {
    std::fprintf(stderr, "Stopped while pictures were drawn; figures are complete.\n");
    return kInterrupted;
  }
  std::printf("Results are in %s\n", options.out.c_str());

  ExitStatus status = kSuccess;
  for (const NamedRun& run : runs) {
    if (!run.run.failure) continue;
    std::fprintf(stderr, "%s: %s\n", std::string(NameOf(run.narrowphase)).c_str(), run.run.failure->c_str());
    status = kLostBody;
  }
  return status;
}

}  // namespace dgd_demos
