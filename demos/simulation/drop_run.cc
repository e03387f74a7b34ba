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

int StepCount(double duration, double time_step) { return static_cast<int>(std::lround(duration / time_step)); }

}  // namespace

int StepCount(const Scene& scene) { return StepCount(scene.duration, scene.time_step); }

DropRun RunDrop(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase,
                int oracle_every, const std::function<void(const StepRecord&)>& on_step,
                dgd_bullet::PairObserver* observer) {
  World world(scene, bodies, narrowphase);
  return RunWorld(world, {scene.duration, oracle_every, scene.snapshots}, on_step, observer);
}

DropRun RunWorld(SimulatedWorld& world, const RunSettings& settings,
                 const std::function<void(const StepRecord&)>& on_step, dgd_bullet::PairObserver* observer) {
  WorldRun run(world, settings, observer);
  while (!run.IsDone()) on_step(run.Step());
  return run.Result();
}

WorldRun::WorldRun(SimulatedWorld& world, RunSettings settings, dgd_bullet::PairObserver* observer)
    : world_(world),
      settings_(std::move(settings)),
      step_count_(StepCount(settings_.duration, world.time_step())),
      oracle_(world.OracleBodies()),
      tally_(settings_.duration, world.time_step(), world.Bodies(), world.TotalEnergy()) {
  if (observer != nullptr) world_.ShowQueriesTo(*observer);
  TakeDueSnapshots(0);
}

bool WorldRun::IsDone() const { return tally_.steps() >= step_count_ || failure_; }

// The oracle judges the poses and the pairs that the step's collision detection gets.
StepRecord WorldRun::Step() {
  using Clock = std::chrono::steady_clock;
  const int number = tally_.steps() + 1;
  const bool is_judged = number % settings_.oracle_every == 0;
  std::vector<Pose> poses_before = is_judged ? world_.Poses() : std::vector<Pose>{};

  const Clock::time_point start = Clock::now();
  const CollisionReport collision = world_.Step();
  wall_time_ += std::chrono::duration<double>(Clock::now() - start).count();

  StepRecord step{number * world_.time_step(), world_.TotalEnergy(), collision, std::nullopt};
  if (is_judged) {
    const CollisionInput input{std::move(poses_before), world_.OverlappingPairs()};
    step.true_penetration = oracle_.DeepestPenetration(input);
    step.unjudged_pairs = oracle_.CountUnjudged(input);
  }
  const std::vector<Motion> motions = world_.Motions();
  tally_.Add(step, SpeedsOf(motions));
  // Half a step early rather than a whole one late, should the product of number and step round down.
  TakeDueSnapshots(step.time + world_.time_step() / 2);
  if (const auto lost = world_.FindLostBody(motions)) {
    std::ostringstream sentence;
    sentence << *lost << " at " << step.time << " s";
    failure_ = sentence.str();
  }
  return step;
}

void WorldRun::TakeDueSnapshots(double time) {
  while (snapshots_.size() < settings_.snapshots.size() && settings_.snapshots[snapshots_.size()] <= time) {
    snapshots_.push_back({settings_.snapshots[snapshots_.size()], world_.Poses(), SpeedsOf(world_.Motions())});
  }
}

DropRun WorldRun::Result() const {
  DropRun run;
  run.snapshots = snapshots_;
  run.failure = failure_;
  run.end_state = {time(), world_.Poses(), SpeedsOf(world_.Motions())};
  run.summary = tally_.Summary(run.end_state.poses, wall_time_);
  run.summary.lost_bodies = failure_ ? 1 : 0;
  return run;
}

void WorldRun::Serialize(StateArchive& archive) {
  tally_.Serialize(archive);
  archive.Require(0 <= tally_.steps() && tally_.steps() <= step_count_, "the number of steps is out of range");
  oracle_.Serialize(archive);
  archive.Serialize(wall_time_);
  archive.Serialize(snapshots_, [&](Snapshot& snapshot) {
    archive.Serialize(snapshot.time);
    archive.Serialize(snapshot.poses, [&](Pose& pose) {
      archive.Serialize(pose.rotation);
      archive.Serialize(pose.position);
    });
    archive.Serialize(snapshot.speeds, [&](double& speed) { archive.Serialize(speed); });
    const std::size_t bodies = world_.Bodies().size();
    archive.Require(snapshot.poses.size() == bodies && snapshot.speeds.size() == bodies,
                    "a picture has not one pose and one speed for each body");
  });
  archive.Require(snapshots_.size() <= settings_.snapshots.size(), "it has too many pictures");
  std::string failure = failure_.value_or("");
  archive.Serialize(failure);
  if (!failure.empty()) failure_ = failure;
}

}  // namespace dgd_demos
