// Contract: each figure is that of the steps it names, by hand-made steps of one moving body.
#include "simulation/tally.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "scene/bodies.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

// Four steps of a second. Body 0 is the ground.
class TallyTest : public testing::Test {
 protected:
  TallyTest() {
    scene_.time_step = 1;
    scene_.duration = 4;
  }

  static StepRecord Step(double time, double kinetic, double potential, std::optional<double> penetration) {
    return {time, {kinetic, potential}, {}, penetration};
  }
  std::vector<SimulatedBody> SimulatedBodies() const {
    return {SimulatedBodyOf(bodies_[0]), SimulatedBodyOf(bodies_[1])};
  }
  std::vector<Pose> PosesAfterAMoveOf(double distance) const {
    std::vector<Pose> poses = {bodies_[0].pose, bodies_[1].pose};
    poses[1].position.x() += distance;
    return poses;
  }

  Scene scene_ = LeavingTheWorldScene();
  std::vector<Body> bodies_ = MakeBodies(scene_, 1);
};

TEST_F(TallyTest, FullRun_HasAllFigures) {
  Tally tally(scene_.duration, scene_.time_step, SimulatedBodies(), {0, 10});
  tally.Add(Step(1, 3, 5, 0.3), {9, 7});
  tally.Add(Step(2, 2, 7, 0.1), {9, 7});        // Rises by 1.
  tally.Add(Step(3, 0.02, 7.98, 0.2), {9, 3});  // "At rest" begins after this one, the last half before it.
  tally.Add(Step(4, 0, 8.5, 0.05), {9, 1});     // Rises by 0.5, to 0.5 above its least.
  const RunSummary summary = tally.Summary(PosesAfterAMoveOf(0.1), 1.5);
  EXPECT_EQ(summary.steps, 4);
  EXPECT_EQ(summary.deepest_true, 0.3);
  EXPECT_EQ(summary.deepest_at_rest, 0.05);
  EXPECT_EQ(summary.time_to_rest, 3);
  EXPECT_DOUBLE_EQ(summary.energy_rise_step, 1);
  EXPECT_DOUBLE_EQ(summary.energy_rise, 1);
  EXPECT_DOUBLE_EQ(summary.dissipated_share, 0.15);
  EXPECT_DOUBLE_EQ(summary.rms_speed, std::sqrt((3.0 * 3 + 1) / 2)) << "the ground's speed does not count";
  EXPECT_DOUBLE_EQ(summary.displacement, 0.1);
  EXPECT_EQ(summary.out_of_place, 0);
}

TEST_F(TallyTest, EnergyThatRisesStepByStep_IsSummedAboveItsLeast) {
  Tally tally(scene_.duration, scene_.time_step, SimulatedBodies(), {0, 10});
  tally.Add(Step(1, 0, 4, std::nullopt), {0, 0});
  tally.Add(Step(2, 0, 6, std::nullopt), {0, 0});
  tally.Add(Step(3, 0, 9, std::nullopt), {0, 0});
  const RunSummary summary = tally.Summary(PosesAfterAMoveOf(0), 0);
  EXPECT_DOUBLE_EQ(summary.energy_rise_step, 3);
  EXPECT_DOUBLE_EQ(summary.energy_rise, 5);
}

TEST_F(TallyTest, RunThatEndsEarly_NeverComesToRest) {
  Tally tally(scene_.duration, scene_.time_step, SimulatedBodies(), {0, 10});
  tally.Add(Step(1, 0, 10, 0.1), {0, 0});
  const RunSummary summary = tally.Summary(PosesAfterAMoveOf(5), 0);
  EXPECT_EQ(summary.time_to_rest, kNever);
  EXPECT_TRUE(std::isnan(summary.deepest_at_rest));
  EXPECT_TRUE(std::isnan(summary.rms_speed));
  EXPECT_EQ(summary.out_of_place, 1);
}

TEST_F(TallyTest, StillMovingAtTheEnd_NeverComesToRest) {
  Tally tally(scene_.duration, scene_.time_step, SimulatedBodies(), {0, 10});
  for (int i = 1; i <= 4; ++i) tally.Add(Step(i, 1, 9, std::nullopt), {0, 0});
  const RunSummary summary = tally.Summary(PosesAfterAMoveOf(std::nan("")), 0);
  EXPECT_EQ(summary.time_to_rest, kNever);
  EXPECT_TRUE(std::isnan(summary.deepest_at_rest)) << "the oracle was never asked";
  EXPECT_EQ(summary.out_of_place, 1) << "what is nowhere is not in its place";
}

}  // namespace
}  // namespace dgd_demos
