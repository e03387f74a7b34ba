#include "report/pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "render/camera.h"
#include "render/image.h"
#include "render/png_file.h"
#include "render/scene_renderer.h"
#include "report/progress_bar.h"
#include "stop_signals.h"

namespace dgd_demos {
namespace {

constexpr int kHalfWidth = 960;  // Of one of two end states side by side, pixels.

std::string TitleOf(Narrowphase narrowphase) {
  return narrowphase == Narrowphase::kBuiltin ? "Bullet on its own GJK/EPA" : "Bullet on the growth distance";
}

bool IsDrawable(const Snapshot& state) {
  return std::ranges::all_of(state.poses,
                             [](const Pose& pose) { return pose.position.allFinite() && pose.rotation.allFinite(); });
}

double FastestIn(const Snapshot& state) {
  double fastest = 0;
  for (const double speed : state.speeds) {
    if (std::isfinite(speed)) fastest = std::max(fastest, speed);
  }
  return fastest;
}

double FastestIn(const std::vector<NamedRun>& runs) {
  double fastest = 0;
  for (const NamedRun& run : runs) {
    fastest = std::max(fastest, FastestIn(run.run.end_state));
    for (const Snapshot& state : run.run.snapshots) fastest = std::max(fastest, FastestIn(state));
  }
  return fastest;
}

// The same moment of all runs, in the view; none for a run that did not get there, or has a body that is nowhere.
using Moment = std::vector<std::optional<Snapshot>>;

class PictureWriter {
 public:
  PictureWriter(const WorldView& view, std::optional<std::uint64_t> seed, const std::vector<NamedRun>& runs,
                const std::filesystem::path& folder)
      : scale_(ScaleFor(view, FastestIn(runs))), view_(view), seed_(seed), runs_(runs), folder_(folder) {}

  void Write() {
    const std::vector<Snapshot>& most = std::ranges::max_element(runs_, {}, [](const NamedRun& run) {
                                          return run.run.snapshots.size();
                                        })->run.snapshots;
    std::vector<double> times;
    for (const Snapshot& state : most) times.push_back(state.time);
    const std::vector<std::string> names = PictureNames(times);
    ProgressBar progress("pictures", static_cast<double>(names.size() + 1));
    SceneRenderer renderer(view_.bodies, scale_, kPictureWidth, kPictureHeight);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (IsStopRequested()) return;
      progress.Update(static_cast<double>(i));
      WriteMoment(i, names[i], renderer);
    }
    if (IsStopRequested()) return;
    progress.Update(static_cast<double>(names.size()));
    WriteEndState();
  }

 private:
  // One picture a run, all from the same place.
  void WriteMoment(std::size_t index, const std::string& name, SceneRenderer& renderer) const {
    Moment moment;
    for (const NamedRun& run : runs_) {
      moment.push_back(index < run.run.snapshots.size() ? Drawable(run.run.snapshots[index]) : std::nullopt);
    }
    const std::optional<Camera> camera = CameraFor(moment, renderer.aspect());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (!moment[r]) continue;
      const std::string file = std::string(NameOf(runs_[r].narrowphase)) + "_" + name;
      WritePng(folder_ / file, Draw(runs_[r].narrowphase, *moment[r], *camera, renderer));
    }
  }

  void WriteEndState() const {
    Moment moment;
    for (const NamedRun& run : runs_) moment.push_back(Drawable(run.run.end_state));
    SceneRenderer renderer(view_.bodies, scale_, runs_.size() == 2 ? kHalfWidth : kPictureWidth, kPictureHeight);
    const std::optional<Camera> camera = CameraFor(moment, renderer.aspect());
    std::vector<Image> images;
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (moment[r]) images.push_back(Draw(runs_[r].narrowphase, *moment[r], *camera, renderer));
    }
    if (images.empty()) return;
    WritePng(folder_ / "end_state.png", images.size() == 2 ? SideBySide(images[0], images[1]) : images[0]);
  }

  std::optional<Snapshot> Drawable(const Snapshot& state) const {
    if (!IsDrawable(state)) return std::nullopt;
    return InView(view_, state);
  }

  // None if there is nothing to see.
  std::optional<Camera> CameraFor(const Moment& moment, double aspect) const {
    std::vector<Ball> balls;
    const Snapshot* any = nullptr;
    for (const std::optional<Snapshot>& state : moment) {
      if (!state) continue;
      any = &*state;
      const std::vector<Ball> more = BallsAround(view_.bodies, *state);
      balls.insert(balls.end(), more.begin(), more.end());
    }
    if (any == nullptr) return std::nullopt;
    return FrameAll(WithSurroundings(std::move(balls), view_.bodies, *any), aspect);
  }

  Image Draw(Narrowphase narrowphase, const Snapshot& state, const Camera& camera, SceneRenderer& renderer) const {
    const std::string seed = seed_ ? "seed " + std::to_string(*seed_) + ",  " : "";
    const std::string subtitle = TimeText(state.time) + ",  " + seed + BulletPrecision() + " precision";
    return renderer.Render({state, camera, TitleOf(narrowphase), subtitle});
  }

  SpeedScale scale_;
  const WorldView& view_;
  std::optional<std::uint64_t> seed_;
  const std::vector<NamedRun>& runs_;
  const std::filesystem::path& folder_;
};

}  // namespace

void WritePictures(const WorldView& view, std::optional<std::uint64_t> seed, const std::vector<NamedRun>& runs,
                   const std::filesystem::path& folder) {
  PictureWriter(view, seed, runs, folder).Write();
}

std::vector<std::string> PictureNames(const std::vector<double>& times) {
  constexpr int kLeastDecimals = 2, kMostDecimals = 9;
  std::vector<std::string> names;
  for (int decimals = kLeastDecimals; decimals <= kMostDecimals; ++decimals) {
    names.clear();
    for (const double time : times) {
      std::array<char, 64> name;
      std::snprintf(name.data(), name.size(), "t%0*.*fs.png", decimals + 3, decimals, time);
      names.emplace_back(name.data());
    }
    if (std::set(names.begin(), names.end()).size() == names.size()) break;
  }
  return names;
}

bool IsPictureName(std::string_view name) {
  return name.starts_with('t') && name.ends_with("s.png") &&
         name.find_first_not_of("0123456789.", 1) == name.size() - std::string_view("s.png").size();
}

std::string TimeText(double time) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "t = %.2f s", time);
  return text.data();
}

}  // namespace dgd_demos
