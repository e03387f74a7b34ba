#include "sweep/run_one.h"

#include <exception>
#include <memory>

#include "error_message.h"
#include "run/world_source.h"
#include "simulation/drop_run.h"

namespace dgd_demos {

RunRecord RunOne(const RunSpec& spec) try {
  const WorldSource source({spec.file, spec.seed, spec.duration, spec.time_step, spec.changes});
  const std::unique_ptr<SimulatedWorld> world = source.Make(NarrowphaseChoice::Named(spec.narrowphase));
  const DropRun run = RunWorld(*world, {source.duration(), spec.oracle_every}, [](const StepRecord&) {});
  return {spec.number, run.failure ? RunRecord::Status::kLost : RunRecord::Status::kDone, run.failure.value_or(""),
          DGD_DEMOS_BUILD_TYPE, FiguresOf(run.summary)};
} catch (const std::exception& error) {
  return {spec.number, RunRecord::Status::kFailed, MessageOf(error), DGD_DEMOS_BUILD_TYPE, {}};
}

}  // namespace dgd_demos
