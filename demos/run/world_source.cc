#include "run/world_source.h"

#include <sstream>

#include "scene/scene_error.h"
#include "scene_options.h"
#include "simulation/world.h"
#include "world_file/bullet_file.h"
#ifdef DGD_DEMOS_WORLD_FILES
#include "world_file/imported_world.h"
#endif

namespace dgd_demos {
namespace {

void CheckTimeStep(double time_step) {
  if (time_step > 0 && time_step <= kMaxTimeStep) return;  // False for NaN.
  std::ostringstream complaint;
  complaint << "--time-step: must be above 0, up to " << kMaxTimeStep << " s, not " << time_step;
  throw SceneError(complaint.str());
}

#ifndef DGD_DEMOS_WORLD_FILES
// Stands in for Bullet's reader of world files.
CheckedWorld LoadWorldFile(const std::filesystem::path& file) {
  throw SceneError(file.string() +
                   ": this program is built without Bullet's reader of world files (Debian's package is "
                   "libbullet-extras-dev)");
}
#endif

}  // namespace

WorldSource::WorldSource(const WorldRequest& request) : time_step_(request.time_step) {
  if (time_step_) CheckTimeStep(*time_step_);
  if (IsWorldFile(request.file)) {
    world_file_ = LoadWorldFile(request.file);
    if (request.duration) duration_ = *request.duration;
#ifdef DGD_DEMOS_WORLD_FILES
    const ImportedWorld world(*world_file_, Narrowphase::kBuiltin, time_step_);
    CheckDuration(duration_, world.time_step());
    remarks_ = world.Remarks();
#endif
    return;
  }
  if (IsSceneName(request.file) && !std::filesystem::exists(request.file)) {
    throw SceneError(request.file.string() + ": " + kNoSuchScene);
  }
  scene_ = LoadScene(request.file, request.changes);
  if (time_step_) scene_->time_step = *time_step_;
  SetDuration(*scene_, request.duration);
  duration_ = scene_->duration;
  bodies_ = MakeBodies(*scene_, request.seed);
}

std::unique_ptr<SimulatedWorld> WorldSource::Make(const NarrowphaseChoice& narrowphase) const {
#ifdef DGD_DEMOS_WORLD_FILES
  if (world_file_) return std::make_unique<ImportedWorld>(*world_file_, narrowphase, time_step_);
#endif
  return std::make_unique<World>(*scene_, bodies_, narrowphase);
}

std::vector<double> WorldSource::snapshots() const {
  return scene_ ? scene_->snapshots : std::vector<double>{0, duration_ / 2, duration_};
}

WorldView WorldSource::View() const { return scene_ ? ViewOf(*scene_, bodies_) : ViewOf(*Make(Narrowphase::kBuiltin)); }

}  // namespace dgd_demos
