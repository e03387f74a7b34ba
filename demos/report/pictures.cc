#include "report/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "render/camera.h"
#include "render/image.h"
#include "render/png_file.h"
#include "render/scene_renderer.h"
#include "report/progress_bar.h"

namespace dgd_demos {
namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr int kHalfWidth = 960;  // Of one of two end states side by side.

std::string Format(const char* format, double number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

// The colour scale ends at the speed of a free fall from the highest start to the ground.
SpeedScale ScaleFor(const Scene& scene, const std::vector<Body>& bodies) {
  double highest = 0;
  for (const Body& body : bodies) highest = std::max(highest, body.pose.position.z());
  constexpr double kLeast = 1;  // m/s, for scenes that start on the ground or have no gravity.
  return SpeedScale(std::max(kLeast, std::ceil(std::sqrt(2 * scene.gravity.norm() * highest))));
}

bool IsDrawable(const Snapshot& state) {
  return std::ranges::all_of(state.poses,
                             [](const Pose& pose) { return pose.position.allFinite() && pose.rotation.allFinite(); });
}

std::string TitleOf(Narrowphase narrowphase) {
  return narrowphase == Narrowphase::kBuiltin ? "Bullet on its own GJK/EPA" : "Bullet on the growth distance";
}

class PictureWriter {
 public:
  PictureWriter(const Scene& scene, const std::vector<Body>& bodies, std::uint64_t seed,
                const std::vector<NamedRun>& runs, const std::filesystem::path& folder)
      : scale_(ScaleFor(scene, bodies)), bodies_(bodies), seed_(seed), runs_(runs), folder_(folder) {}

  void Write() {
    std::size_t moments = 0;
    for (const NamedRun& run : runs_) moments = std::max(moments, run.run.snapshots.size());
    ProgressBar progress("pictures", static_cast<double>(moments + 1));
    SceneRenderer renderer(bodies_, scale_, kWidth, kHeight);
    for (std::size_t i = 0; i < moments; ++i) {
      progress.Update(static_cast<double>(i));
      WriteMoment(i, renderer);
    }
    progress.Update(static_cast<double>(moments));
    WriteEndState();
  }

 private:
  // One picture a run, all from the same place.
  void WriteMoment(std::size_t index, SceneRenderer& renderer) const {
    std::vector<const Snapshot*> states;
    for (const NamedRun& run : runs_) {
      states.push_back(index < run.run.snapshots.size() ? &run.run.snapshots[index] : nullptr);
    }
    const std::optional<Camera> camera = CameraFor(states, renderer.aspect());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (states[r] == nullptr || !IsDrawable(*states[r])) continue;
      const std::string name = std::string(NameOf(runs_[r].narrowphase)) + Format("_t%05.2fs.png", states[r]->time);
      WritePng(folder_ / name, Draw(runs_[r].narrowphase, *states[r], *camera, renderer));
    }
  }

  void WriteEndState() const {
    std::vector<const Snapshot*> states;
    for (const NamedRun& run : runs_) states.push_back(&run.run.end_state);
    SceneRenderer renderer(bodies_, scale_, runs_.size() == 2 ? kHalfWidth : kWidth, kHeight);
    const std::optional<Camera> camera = CameraFor(states, renderer.aspect());
    std::vector<Image> images;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (IsDrawable(*states[r])) images.push_back(Draw(runs_[r].narrowphase, *states[r], *camera, renderer));
    }
    if (images.empty()) return;
    WritePng(folder_ / "end_state.png", images.size() == 2 ? SideBySide(images[0], images[1]) : images[0]);
  }

  // None if there is nothing to see.
  std::optional<Camera> CameraFor(const std::vector<const Snapshot*>& states, double aspect) const {
    std::vector<Ball> balls;
    for (const Snapshot* state : states) {
      if (state == nullptr || !IsDrawable(*state)) continue;
      const std::vector<Ball> more = BallsAround(bodies_, *state);
      balls.insert(balls.end(), more.begin(), more.end());
    }
    if (balls.empty()) return std::nullopt;
    return FrameAll(balls, aspect);
  }

  Image Draw(Narrowphase narrowphase, const Snapshot& state, const Camera& camera, SceneRenderer& renderer) const {
    const std::string subtitle = "t = " + Format("%.2f", state.time) + " s,  seed " + std::to_string(seed_) + ",  " +
                                 BulletPrecision() + " precision";
    return renderer.Render({state, camera, TitleOf(narrowphase), subtitle});
  }

  SpeedScale scale_;
  const std::vector<Body>& bodies_;
  std::uint64_t seed_;
  const std::vector<NamedRun>& runs_;
  const std::filesystem::path& folder_;
};

}  // namespace

void WritePictures(const Scene& scene, const std::vector<Body>& bodies, std::uint64_t seed,
                   const std::vector<NamedRun>& runs, const std::filesystem::path& folder) {
  PictureWriter(scene, bodies, seed, runs, folder).Write();
}

}  // namespace dgd_demos
