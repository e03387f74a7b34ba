// polytope_drop: a scene in Bullet, on one narrowphase or the other or both, measured and drawn. See --help.
#include <dgd_bullet/recorder.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "program_main.h"
#include "report/comparison_table.h"
#include "report/pictures.h"
#include "report/progress_bar.h"
#include "report/step_csv.h"
#include "scene/bodies.h"
#include "scene_options.h"
#include "simulation/drop_run.h"

namespace dgd_demos {
namespace {

DropRun RunAndRecord(const Scene& scene, const std::vector<Body>& bodies, Narrowphase narrowphase,
                     const Options& options) {
  const std::string name(NameOf(narrowphase));
  StepCsv csv(options.out / (name + ".csv"), {scene.file, options.seed, name, BulletPrecision(), DGD_DEMOS_BUILD_TYPE});
  ProgressBar progress(name + std::string(8 - std::min<std::size_t>(name.size(), 8), ' '), scene.duration);
  std::optional<dgd_bullet::Recorder> recorder;
  if (options.record) recorder.emplace((options.out / (name + ".rec")).string());
  const auto on_step = [&](const StepRecord& step) {
    csv.Write(step);
    progress.Update(step.time);
  };
  DropRun run = RunDrop(scene, bodies, narrowphase, options.oracle_every, on_step, recorder ? &*recorder : nullptr);
  if (recorder) recorder->Close();
  return run;
}

ExitStatus Run(const Options& options) {
  const Scene scene = LoadSceneFor(options.scene, options.duration);
  const std::vector<Body> bodies = MakeBodies(scene, options.seed);
  std::filesystem::create_directories(options.out);

  std::vector<NamedRun> runs;
  std::vector<TableColumn> columns;
  for (const Narrowphase narrowphase : options.narrowphases) {
    runs.push_back({narrowphase, RunAndRecord(scene, bodies, narrowphase, options)});
    columns.push_back({std::string(NameOf(narrowphase)), {FiguresOf(runs.back().run.summary)}});
  }
  if (options.draw_snapshots) WritePictures(scene, bodies, options.seed, runs, options.out);

  WriteTableCsv(options.out / "summary.csv", columns);
  std::printf("%s, seed %llu, Bullet in %s precision\n\n%s\nResults are in %s\n", scene.file.c_str(),
              static_cast<unsigned long long>(options.seed), BulletPrecision(), FormatTable(columns).c_str(),
              options.out.c_str());

  ExitStatus status = kSuccess;
  for (const NamedRun& run : runs) {
    if (!run.run.failure) continue;
    std::fprintf(stderr, "%s: %s\n", std::string(NameOf(run.narrowphase)).c_str(), run.run.failure->c_str());
    status = kLostBody;
  }
  return status;
}

}  // namespace
}  // namespace dgd_demos

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_demos::ParseCommandLine(argc, argv), dgd_demos::Run);
}
