// Whole runs at small size, with each narrowphase, in this executable's precision of Bullet.
#include "simulation/drop_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "report/step_csv.h"
#include "scene/bodies.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

void IgnoreStep(const StepRecord&) {}

// A CSV without its measured column.
std::string WithoutTimes(const std::string& csv) {
  constexpr int kNarrowphaseUs = 5;  // Column, from 0.
  std::string kept;
  int column = 0;
  for (const char c : csv) {
    if (c == '\n') column = 0;
    if (c == ',') ++column;
    if (column != kNarrowphaseUs) kept += c;
  }
  return kept;
}

class DropRunTest : public testing::TestWithParam<Narrowphase> {};

TEST_P(DropRunTest, SmallDrop_ComesToRest) {
  const Scene scene = SmallDropScene();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const DropRun run = RunDrop(scene, MakeBodies(scene, seed), GetParam(), 1, IgnoreStep);
    EXPECT_EQ(run.failure.value_or(""), "");
    EXPECT_EQ(run.summary.steps, StepCount(scene));
    EXPECT_LT(run.summary.kinetic_energy_end, 0.01) << "seed " << seed;
    EXPECT_GT(run.summary.dissipated_share, 0.8) << "seed " << seed;
    EXPECT_LT(run.summary.dissipated_share, 1.0) << "seed " << seed;
    // On the ground with its margin, and not in it.
    for (std::size_t i = kGroundIndex + 1; i < run.end_state.poses.size(); ++i) {
      EXPECT_GT(run.end_state.poses[i].position.z(), 0.15);
      EXPECT_LT(run.end_state.poses[i].position.z(), 2);
    }
  }
}

TEST_P(DropRunTest, SameSeedTwice_SameCsvButForTheTimes) {
  const TestFolder folder;
  Scene scene = SmallDropScene();
  scene.duration = 3;
  const auto csv_of_run = [&](const char* name) {
    StepCsv csv(folder.path() / name, {"scene", 4, "narrowphase", "precision", "type"});
    RunDrop(scene, MakeBodies(scene, 4), GetParam(), 4, [&](const StepRecord& step) { csv.Write(step); });
    csv.Flush();
    return ReadFile(folder.path() / name);
  };
  const std::string first = csv_of_run("first.csv");
  EXPECT_EQ(WithoutTimes(first), WithoutTimes(csv_of_run("second.csv")));
  EXPECT_EQ(std::ranges::count(first, '\n'), StepCount(scene) + 7);
}

TEST_P(DropRunTest, Oracle_IsAskedAtEverySoManyThStepAndChangesNothing) {
  Scene scene = SmallDropScene();
  scene.duration = 2;
  std::vector<double> energies, energies_without;
  int asked = 0;
  RunDrop(scene, MakeBodies(scene, 1), GetParam(), 4, [&](const StepRecord& step) {
    energies.push_back(step.energy.kinetic);
    asked += step.true_penetration.has_value();
  });
  RunDrop(scene, MakeBodies(scene, 1), GetParam(), 1'000'000,
          [&](const StepRecord& step) { energies_without.push_back(step.energy.kinetic); });
  EXPECT_EQ(asked, StepCount(scene) / 4);
  EXPECT_EQ(energies, energies_without);
}

TEST_P(DropRunTest, FreeFall_FollowsTheParabolaUntilContact) {
  Scene scene = SmallDropScene();
  scene.duration = 0.2;
  const std::vector<Body> bodies = MakeBodies(scene, 1);
  const double mass = static_cast<double>(bodies.size()) - 1;
  int steps = 0;
  RunDrop(scene, bodies, GetParam(), 1, [&](const StepRecord& step) {
    ++steps;
    const double speed = 9.81 * step.time;
    EXPECT_NEAR(step.energy.kinetic, mass * speed * speed / 2, 1e-3);
    EXPECT_NEAR(step.time, steps * scene.time_step, 1e-15);
    EXPECT_EQ(step.true_penetration, 0);
  });
  EXPECT_EQ(steps, 48);
}

TEST_P(DropRunTest, Snapshots_AreTakenAtTheScenesTimes) {
  const Scene scene = SmallDropScene();
  const std::vector<Body> bodies = MakeBodies(scene, 1);
  const DropRun run = RunDrop(scene, bodies, GetParam(), 1'000'000, IgnoreStep);
  ASSERT_EQ(run.snapshots.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(run.snapshots[i].time, scene.snapshots[i]);
  EXPECT_LT((run.snapshots[0].poses[1].position - bodies[1].pose.position).norm(), 1e-6);
  EXPECT_EQ(run.snapshots[0].speeds[1], 0);
  EXPECT_EQ(run.snapshots[2].poses[1].position, run.end_state.poses[1].position);
}

TEST_P(DropRunTest, BodyOffTheGround_EndsTheRunWithItsNameAndTime) {
  const Scene scene = LeavingTheWorldScene();
  const DropRun run = RunDrop(scene, MakeBodies(scene, 1), GetParam(), 1, IgnoreStep);
  ASSERT_TRUE(run.failure.has_value());
  EXPECT_NE(run.failure->find("box at /bodies/0 left the world at ("), std::string::npos) << *run.failure;
  EXPECT_LT(run.summary.steps, StepCount(scene));
  EXPECT_EQ(run.end_state.time, run.summary.steps * scene.time_step);
}

// However it came about: a body that is nowhere must not pass silently.
TEST_P(DropRunTest, ValueNotFinite_EndsTheRunWithItsName) {
  Scene scene = SmallDropScene();
  std::vector<Body> bodies = MakeBodies(scene, 1);
  bodies[3].pose.position.x() = std::nan("");
  const DropRun run = RunDrop(scene, bodies, GetParam(), 1'000'000, IgnoreStep);
  ASSERT_TRUE(run.failure.has_value());
  EXPECT_NE(run.failure->find("polytope 2 of /bodies/0 has a pose or a velocity that is not finite at 0.00416667 s"),
            std::string::npos)
      << *run.failure;
}

// A gross error of a narrowphase shows here: bodies that sink, or queries that fail.
TEST_P(DropRunTest, SmallDrop_NothingSinksAndNothingFails) {
  const Scene scene = SmallDropScene();
  const RunSummary summary = RunDrop(scene, MakeBodies(scene, 2), GetParam(), 1, IgnoreStep).summary;
  EXPECT_LT(summary.deepest_true, 0.05);
  EXPECT_LT(summary.deepest_reported, 0.05);
  EXPECT_GT(summary.queries, 0u);
  EXPECT_LE(summary.queries, summary.pairs);
  EXPECT_GT(summary.contacts, 0u);
  EXPECT_EQ(summary.fallbacks, 0u);
}

INSTANTIATE_TEST_SUITE_P(Narrowphases, DropRunTest, testing::Values(Narrowphase::kBuiltin, Narrowphase::kDgd),
                         [](const auto& which) { return std::string(NameOf(which.param)); });

}  // namespace
}  // namespace dgd_demos
