#include "simulation/drop_run.h"

#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "simulation/penetration_oracle.h"
#include "simulation/tally.h"
#include "simulation/world.h"

namespace dgd_demos {
namespace {

using Clock = std::chrono::steady_clock;

// Takes a step, and has the oracle judge what the step's collision detection was given.
class Stepper {
 public:
  Stepper(SimulatedWorld& world, int oracle_every)
      : world_(world), oracle_(world.OracleBodies()), oracle_every_(oracle_every) {}

  double wall_time() const { return wall_time_.count(); }

  /// @param number  counts from 1.
  StepRecord Step(int number) {
    const bool ask_oracle = number % oracle_every_ == 0;
    std::vector<Pose> poses_before = ask_oracle ? world_.Poses() : std::vector<Pose>{};

    const Clock::time_point start = Clock::now();
    const CollisionReport collision = world_.Step();
    wall_time_ += Clock::now() - start;

    StepRecord step{number * world_.time_step(), world_.TotalEnergy(), collision, std::nullopt};
    if (ask_oracle) {
      const CollisionInput input{std::move(poses_before), world_.OverlappingPairs()};
      step.true_penetration = oracle_.DeepestPenetration(input);
      step.unjudged_pairs = oracle_.CountUnjudged(input);
    }
    return step;
  }

 private:
  SimulatedWorld& world_;
  PenetrationOracle oracle_;
  int oracle_every_;
  std::chrono::duration<double> wall_time_{};
};

int StepCount(double duration, double time_step) { return static_cast<int>(std::lround(duration / time_step)); }

}  // namespace

int StepCount(const Scene& scene) { return StepCount(scene.duration, scene.time_step); }

DropRun RunDrop(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase,
                int oracle_every, const std::function<void(const StepRecord&)>& on_step,
                dgd_bullet::Recorder* recorder) {
  World world(scene, bodies, narrowphase);
  return RunWorld(world, {scene.duration, oracle_every, scene.snapshots}, on_step, recorder);
}

DropRun RunWorld(SimulatedWorld& world, const RunSettings& settings,
                 const std::function<void(const StepRecord&)>& on_step, dgd_bullet::Recorder* recorder) {
  Stepper stepper(world, settings.oracle_every);
  if (recorder != nullptr) world.RecordInto(*recorder);
  DropRun run;

  auto next_picture = settings.snapshots.begin();
  const auto take_due_pictures = [&](double time) {
    for (; next_picture != settings.snapshots.end() && *next_picture <= time; ++next_picture) {
      run.snapshots.push_back({*next_picture, world.Poses(), world.Speeds()});
    }
  };
  take_due_pictures(0);

  const double time_step = world.time_step();
  Tally tally(settings.duration, time_step, world.Bodies(), world.TotalEnergy());
  const int step_count = StepCount(settings.duration, time_step);
  for (int number = 1; number <= step_count && !run.failure; ++number) {
    const StepRecord step = stepper.Step(number);
    tally.Add(step, world.Speeds());
    on_step(step);
    // Half a step early rather than a whole one late, should the product of number and step round down.
    take_due_pictures(step.time + time_step / 2);
    if (const auto lost = world.FindLostBody()) {
      std::ostringstream sentence;
      sentence << *lost << " at " << step.time << " s";
      run.failure = sentence.str();
    }
  }
  run.end_state = {tally.steps() * time_step, world.Poses(), world.Speeds()};
  run.summary = tally.Summary(run.end_state.poses, stepper.wall_time());
  run.summary.lost_bodies = run.failure ? 1 : 0;
  return run;
}

}  // namespace dgd_demos
