#include "run/render_command.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/png_file.h"
#include "render/scene_renderer.h"
#include "report/output_folder.h"
#include "report/pictures.h"
#include "report/progress_bar.h"
#include "report/whole_file.h"
#include "run/trajectory_reader.h"
#include "run/world_source.h"
#include "scene/scene_error.h"
#include "scene/world_hash.h"

namespace dgd_demos {
namespace {

struct Picture {
  std::string name;    // Name of its file.
  std::size_t sample;  // Number of the sample in the trajectory.
};

// A trajectory of other bodies would be drawn without a sign of it. Every run's begins where the world does.
void CheckMatch(const RenderOptions& options, const WorldSource& source, TrajectoryReader& trajectory) {
  const std::vector<Pose> poses = source.Make(Narrowphase::kBuiltin)->Poses();
  std::ostringstream complaint;
  complaint << options.trajectory.string() << ": ";
  if (trajectory.bodies() != poses.size()) {
    complaint << "has " << trajectory.bodies() << " bodies, and " << options.world.string() << " has " << poses.size();
    throw SceneError(complaint.str());
  }
  if (trajectory.times().front() != 0) return;
  constexpr double kSame = 1e-4;  // In m, and of the distance from the origin: Bullet in float against double.
  const Eigen::IOFormat in_brackets(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
  const Snapshot begin = trajectory.At(0);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3d &there = begin.poses[i].position, &here = poses[i].position;
    if ((there - here).norm() <= kSame * (1 + here.norm())) continue;
    complaint << "body " << i << " begins at " << there.format(in_brackets) << " m, and in " << options.world.string()
              << " at " << here.format(in_brackets) << " m; is it of another world, or of another --seed?";
    throw SceneError(complaint.str());
  }
}

std::vector<double> DefaultTimes(const WorldSource& source, const TrajectoryReader& trajectory) {
  const double begin = trajectory.times().front(), end = trajectory.times().back();
  std::vector<double> times = source.scene() ? source.snapshots() : std::vector<double>{};
  std::erase_if(times, [&](double time) { return time < begin || time > end; });
  return times.empty() ? std::vector<double>{begin, (begin + end) / 2, end} : times;
}

// Pictures of a few moments, each once.
std::vector<Picture> MomentsAt(const std::vector<double>& times, const TrajectoryReader& trajectory) {
  std::vector<std::size_t> samples;
  for (const double time : times) samples.push_back(trajectory.NearestSample(time));
  std::ranges::sort(samples);
  const auto repeated = std::ranges::unique(samples);
  samples.erase(repeated.begin(), repeated.end());

  std::vector<double> sample_times;
  for (const std::size_t sample : samples) sample_times.push_back(trajectory.times()[sample]);
  const std::vector<std::string> names = PictureNames(sample_times);
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < samples.size(); ++i) pictures.push_back({names[i], samples[i]});
  return pictures;
}

std::vector<Picture> FramesEvery(double interval, const TrajectoryReader& trajectory) {
  constexpr double kMostFrames = 100'000;  // As the names have five digits.
  const double begin = trajectory.times().front(), length = trajectory.times().back() - begin;
  const double count = std::floor(length / interval + 1e-6) + 1;
  if (count > kMostFrames) {
    std::ostringstream complaint;
    complaint << "--every: " << interval << " s makes " << count << " frames of " << length << " s, and at most "
              << kMostFrames << " are drawn";
    throw SceneError(complaint.str());
  }
  std::vector<Picture> frames;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    std::array<char, 32> name;
    std::snprintf(name.data(), name.size(), "frame_%05d.png", i);
    frames.push_back({name.data(), trajectory.NearestSample(begin + i * interval)});
  }
  return frames;
}

// What all pictures have in common.
struct Frame {
  Camera camera;
  double fastest;  // m/s
};

// Reads all samples once: there may be more of them than fit into memory.
Frame FrameOf(const std::vector<Picture>& pictures, const WorldView& view, TrajectoryReader& trajectory,
              double aspect) {
  constexpr double kMoved = 0.01;  // In radii; a body that has moved less is framed as it was.
  double fastest = 0;
  std::vector<Ball> balls, last;
  Snapshot state;
  for (const Picture& picture : pictures) {
    state = InView(view, trajectory.At(picture.sample));
    fastest = std::max(fastest, *std::ranges::max_element(state.speeds));
    const std::vector<Ball> now = BallsAround(view.bodies, state);
    if (last.empty()) balls = last = now;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if ((now[i].centre - last[i].centre).norm() <= kMoved * now[i].radius) continue;
      balls.push_back(now[i]);
      last[i] = now[i];
    }
  }
  return {FrameAll(WithSurroundings(std::move(balls), view.bodies, state), aspect), fastest};
}

bool IsFileOfRender(const std::string& name) {
  return IsPictureName(name) || (name.starts_with("frame_") && name.ends_with(".png"));
}

Results ResultsOf(const RenderOptions& options) {
  return {options.out,
          "render.json",
          {{"world", options.world.filename().string() + " " + HashOfWorld(options.world)},
           {"trajectory", options.trajectory.filename().string() + " " + HashOfSizeAndEnd(options.trajectory)},
           {"--seed", options.seed}},
          IsFileOfRender};
}

}  // namespace

ExitStatus Render(const RenderOptions& options) {
  const WorldSource source({options.world, options.seed, std::nullopt, std::nullopt});
  TrajectoryReader trajectory(options.trajectory);
  CheckMatch(options, source, trajectory);
  const std::vector<double> times = options.times.empty() ? DefaultTimes(source, trajectory) : options.times;
  const std::vector<Picture> pictures =
      options.every ? FramesEvery(*options.every, trajectory) : MomentsAt(times, trajectory);
  ClaimFolder(ResultsOf(options), options.overwrite);

  const WorldView view = source.View();
  const Frame frame = FrameOf(pictures, view, trajectory, static_cast<double>(options.width) / options.height);
  SceneRenderer renderer(view.bodies, ScaleFor(view, frame.fastest), options.width, options.height);
  {
    ProgressBar progress("pictures", static_cast<double>(pictures.size()));
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      progress.Update(static_cast<double>(i));
      const Snapshot state = InView(view, trajectory.At(pictures[i].sample));
      const std::string subtitle = TimeText(state.time) + ",  " + options.trajectory.stem().string();
      const Image image = renderer.Render({state, frame.camera, options.world.stem().string(), subtitle});
      WritePng(options.out / pictures[i].name, image);
    }
  }
  std::printf("Pictures: %zu, in %s\n", pictures.size(), options.out.c_str());
  return kSuccess;
}

}  // namespace dgd_demos
