#include "run/world_source.h"

#include <sstream>

#include "scene/scene_error.h"
#include "scene_options.h"
#include "simulation/world.h"
#include "world_file/is_world_file.h"
#ifdef DGD_DEMOS_WORLD_FILES
#include "world_file/imported_world.h"
#endif

namespace dgd_demos {
namespace {

constexpr double kLongestTimeStep = 0.1;  // s

void CheckTimeStep(double time_step) {
  if (time_step > 0 && time_step <= kLongestTimeStep) return;  // False for NaN.
  std::ostringstream complaint;
  complaint << "--time-step: must be above 0, up to " << kLongestTimeStep << " s, not " << time_step;
  throw SceneError(complaint.str());
}

#ifdef DGD_DEMOS_WORLD_FILES
std::unique_ptr<ImportedWorld> Import(const WorldRequest& request, const NarrowphaseChoice& narrowphase) {
  return std::make_unique<ImportedWorld>(LoadWorldFile(request.file), narrowphase, request.time_step);
}
#else
std::unique_ptr<SimulatedWorld> Import(const WorldRequest& request, const NarrowphaseChoice&) {
  throw SceneError(request.file.string() +
                   ": this program is built without Bullet's reader of world files (Debian's package is "
                   "libbullet-extras-dev)");
}
#endif

}  // namespace

WorldSource::WorldSource(const WorldRequest& request) : request_(request) {
  if (request.time_step) CheckTimeStep(*request.time_step);
  if (IsWorldFile(request.file)) {
    const double time_step = Import(request, Narrowphase::kBuiltin)->time_step();
    if (request.duration) duration_ = *request.duration;
    CheckDuration(duration_, time_step);
    return;
  }
  scene_ = LoadScene(request.file, request.changes);
  if (request.time_step) scene_->time_step = *request.time_step;
  SetDuration(*scene_, request.duration);
  duration_ = scene_->duration;
  bodies_ = MakeBodies(*scene_, request.seed);
}

std::unique_ptr<SimulatedWorld> WorldSource::Make(const NarrowphaseChoice& narrowphase) const {
  if (scene_) return std::make_unique<World>(*scene_, bodies_, narrowphase);
  return Import(request_, narrowphase);
}

std::vector<std::string> WorldSource::Remarks() const {
#ifdef DGD_DEMOS_WORLD_FILES
  if (!scene_) return Import(request_, Narrowphase::kBuiltin)->Remarks();
#endif
  return {};
}

}  // namespace dgd_demos
