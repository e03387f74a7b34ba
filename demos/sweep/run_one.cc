#include "sweep/run_one.h"

#include <exception>

#include "scene/bodies.h"
#include "scene_options.h"
#include "simulation/drop_run.h"

namespace dgd_demos {

RunRecord RunOne(const RunSpec& spec) try {
  const Scene scene = LoadSceneFor(spec.file, spec.duration, spec.changes);
  const DropRun run = RunDrop(scene, MakeBodies(scene, spec.seed), NarrowphaseChoice::Named(spec.narrowphase),
                              spec.oracle_every, [](const StepRecord&) {});
  return {spec.number, run.failure ? RunRecord::Status::kLost : RunRecord::Status::kDone, run.failure.value_or(""),
          DGD_DEMOS_BUILD_TYPE, FiguresOf(run.summary)};
} catch (const std::exception& error) {
  return {spec.number, RunRecord::Status::kFailed, error.what(), DGD_DEMOS_BUILD_TYPE, {}};
}

}  // namespace dgd_demos
