// Contract of a planned motion: it is free of collisions by an oracle that shares no code with the core, the same seed
// gives the same path, and what fails says why.
#include "motion/plan_run.h"

#include <gtest/gtest.h>

#include "motion/check_comparison.h"
#include "motion/motion_checks.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

MotionScene SmallMotionScene(const std::string& text = SmallMotionSceneText()) {
  const TestFolder folder;
  return LoadMotionScene(folder.Write("arm.json", text));
}

void ExpectFreeByOracle(const CollisionModel& model, const JointPath& path, double step) {
  const MotionOracle oracle(model);
  for (const Configuration& state : Subdivide(path, step)) {
    EXPECT_GT(oracle.LeastDistance(state), 0) << state.transpose();
  }
}

TEST(PlanRunTest, ShippedScene_IsPlannedAndFreeByTheOracle) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  ASSERT_EQ(FindCollisionAtEnds(scene, model), std::nullopt);
  const PlanRun run = PlanMotion(scene, model, {.time_limit = 60, .seed = 1});
  ASSERT_EQ(run.failure.value_or(""), "");
  for (const JointPath* path : {&run.simplified, &run.smoothed}) {
    EXPECT_EQ(path->front(), scene.start);
    EXPECT_EQ(path->back(), scene.goal);
    ExpectFreeByOracle(model, *path, 0.03);
    for (const Configuration& state : *path) EXPECT_EQ(FindJointBeyondLimits(model.arm(), state), std::nullopt);
  }
  EXPECT_GT(run.after.signed_distance.value, run.before.signed_distance.value);
  EXPECT_LE(Length(run.smoothed), 1.1 * Length(run.simplified) * (1 + 1e-12));
  EXPECT_LE(Length(run.simplified), Length(run.found));
  EXPECT_GT(run.counts.states, 100);
  EXPECT_GT(run.rechecked_states, 100);
}

class SmallPlanTest : public testing::TestWithParam<PlannerKind> {};

TEST_P(SmallPlanTest, SameSeed_SamePath) {
  const MotionScene scene = SmallMotionScene();
  const CollisionModel model(scene);
  const PlanSettings settings{.planner = GetParam(), .time_limit = 60, .seed = 7, .keeps_visited = true};
  const PlanRun run = PlanMotion(scene, model, settings), again = PlanMotion(scene, model, settings);
  ASSERT_EQ(run.failure.value_or(""), "");
  EXPECT_EQ(run.found, again.found);
  EXPECT_EQ(run.smoothed, again.smoothed);
  EXPECT_EQ(run.visited, again.visited);
  EXPECT_EQ(run.counts.states, static_cast<std::int64_t>(run.visited.size()));
  PlanSettings other = settings;
  other.seed = 8;
  EXPECT_NE(PlanMotion(scene, model, other).found, run.found);
  ExpectFreeByOracle(model, run.smoothed, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Both, SmallPlanTest, testing::Values(PlannerKind::kRrt, PlannerKind::kRrtConnect));

// The elbow may not fold, so the post is in the way.
TEST(PlanRunTest, UnreachableGoal_FailureSaysHowFarTheSearchCame) {
  const MotionScene scene =
      SmallMotionScene(With(SmallMotionSceneText(), R"("plan": {)", R"("plan": { "search": { "elbow": [0, 0.2] },)"));
  const CollisionModel model(scene);
  const PlanRun run = PlanMotion(scene, model, {.time_limit = 0.2});
  ASSERT_TRUE(run.failure.has_value());
  EXPECT_NE(run.failure->find("seed 1: no path from start to goal within 0.2 s, nearest branch ends"),
            std::string::npos)
      << *run.failure;
  EXPECT_FALSE(run.found.empty());
  EXPECT_TRUE(run.simplified.empty());
  EXPECT_TRUE(run.smoothed.empty());
}

TEST(PlanRunTest, CollisionAtEitherEnd_IsNamed) {
  for (const auto& [old_part, new_part, complaint] :
       {std::tuple(R"("start": { "shoulder": -0.5)", R"("start": { "shoulder": 0.52)",
                   "the start is in collision: lower and post overlap"),
        std::tuple(R"("goal": { "shoulder": 1.5)", R"("goal": { "shoulder": 0.5)",
                   "the goal is in collision: lower and post overlap")}) {
    const MotionScene scene = SmallMotionScene(With(SmallMotionSceneText(), old_part, new_part));
    EXPECT_EQ(FindCollisionAtEnds(scene, CollisionModel(scene)).value_or(""), complaint);
  }
}

// On states half of which collide: the core in three ways, and two other libraries.
TEST(CheckComparisonTest, RandomStates_AnswersAgreeBeyondTheBand) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  Random random(5, 0);
  std::vector<Configuration> states;
  for (int i = 0; i < 300; ++i) states.push_back(RandomState(model.arm(), random));
  const std::vector<CheckTimes> times = CompareChecks(model, states);
  ASSERT_EQ(times.size(), 5u);
  for (const CheckTimes& row : times) {
    EXPECT_EQ(row.pairs, times[0].pairs) << row.name;
    EXPECT_GT(row.pairs, 300) << row.name;
    EXPECT_GT(row.seconds, 0) << row.name;
    EXPECT_EQ(row.beyond_band, 0) << row.name;
  }
}

}  // namespace
}  // namespace dgd_demos
