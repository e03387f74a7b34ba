// Contract of the clearance and its certificates along a path, and of the gradients by the joints.
#include "motion/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/joint_gradient.h"
#include "motion/motion_checks.h"

namespace dgd_demos {
namespace {

TEST(JointPathTest, Subdivide_KeepsCornersAndLength) {
  const JointPath path = {Configuration::Zero(2), Configuration::Unit(2, 0), Configuration::Ones(2)};
  const JointPath fine = Subdivide(path, 0.3);
  ASSERT_EQ(fine.size(), 9u);
  EXPECT_EQ(fine[4], path[1]);
  EXPECT_EQ(fine.back(), path[2]);
  EXPECT_NEAR(Length(fine), 2, 1e-15);
  for (std::size_t i = 1; i < fine.size(); ++i) EXPECT_LE((fine[i] - fine[i - 1]).norm(), 0.3);
}

TEST(ClearanceTest, LeastSignedDistance_IsTheOracles) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  const MotionOracle oracle(model);
  Random random(3, 0);
  for (int i = 0; i < 5; ++i) {
    const JointPath path = {RandomState(model.arm(), random), RandomState(model.arm(), random)};
    const double step = Length(path) / 20;
    const Clearance clearance = MeasureClearance(model, path, step);
    double expected = std::numeric_limits<double>::infinity();
    for (const Configuration& state : Subdivide(path, step)) {
      expected = std::min(expected, oracle.LeastDistance(state));
    }
    EXPECT_NEAR(clearance.signed_distance.value, expected, kOracleError) << i;
    EXPECT_EQ(clearance.growth_distance.value > 1, clearance.signed_distance.value > 0);

    // What it says of the place is so: there, that pair is that far apart.
    CollisionModel::Poses poses;
    model.ComputePoses(clearance.signed_distance.state, poses);
    const CheckedPair pair = model.pairs()[clearance.signed_distance.pair];
    EXPECT_NEAR(oracle.Distance(pair, poses), expected, kOracleError);
    const Configuration at = path[0] + (path[1] - path[0]) * (clearance.signed_distance.place / Length(path));
    EXPECT_LE((at - clearance.signed_distance.state).norm(), 1e-9);
  }
}

TEST(ClearanceTest, UnprovenState_IsTheFirstCollisionOfAPath) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  const MotionOracle oracle(model);
  const JointPath free = {scene.start, scene.start + Configuration::Constant(6, 0.02)};
  EXPECT_FALSE(FindUnprovenState(model, free, 0.003).has_value());

  // Stretched out and turned downwards, the arm goes through the table.
  Configuration down = scene.start;
  down[1] = 1;
  const auto unproven = FindUnprovenState(model, {scene.start, down}, 0.01);
  ASSERT_TRUE(unproven.has_value());
  EXPECT_NEAR(oracle.LeastDistance(unproven->state), 0, 0.02);
  EXPECT_LT(oracle.LeastDistance(unproven->state), kOracleError);
}

// Central differences of the growth distance, where the core says that it has a derivative.
TEST(JointGradientTest, CentralDifferences_Agree) {
  const CollisionModel model(ShippedMotionScene());
  Random random(4, 0);
  constexpr double kStep = 1e-5;  // rad
  const auto growth = [&](const Configuration& state, const CheckedPair& pair, CollisionModel::Poses& poses) {
    model.ComputePoses(state, poses);
    return dgd::GrowthDistance(model.parts()[pair.first].body.set(), poses[pair.first],
                               model.parts()[pair.second].body.set(), poses[pair.second],
                               {.relative_tolerance = 1e-13});
  };
  int compared = 0;
  for (int i = 0; i < 20; ++i) {
    const Configuration state = RandomState(model.arm(), random);
    for (const CheckedPair& pair : model.pairs()) {
      CollisionModel::Poses poses, poses_nearby;
      const dgd::Result<double> result = growth(state, pair, poses);
      const auto gradient =
          dgd::GrowthDistanceGradient(model.parts()[pair.first].body.set(), poses[pair.first],
                                      model.parts()[pair.second].body.set(), poses[pair.second], result);
      if (!gradient.IsUnique()) continue;
      const Configuration by_joints = JointGradient(model, LinkPoses(model.arm(), state), poses, pair, gradient);
      Configuration differences(6);
      for (Eigen::Index joint = 0; joint < 6; ++joint) {
        const Configuration offset = kStep * Configuration::Unit(6, joint);
        differences[joint] = (growth(state + offset, pair, poses_nearby).GrowthDistance() -
                              growth(state - offset, pair, poses_nearby).GrowthDistance()) /
                             (2 * kStep);
      }
      const double scale = std::max(1.0, by_joints.norm());
      // A kink within the step is no error of the gradient: where the derivatives to both sides differ.
      const double curvature = (growth(state + kStep * by_joints / scale, pair, poses_nearby).GrowthDistance() +
                                growth(state - kStep * by_joints / scale, pair, poses_nearby).GrowthDistance() -
                                2 * result.GrowthDistance()) /
                               kStep;
      if (std::abs(curvature) > 1e-3) continue;
      EXPECT_LE((by_joints - differences).cwiseAbs().maxCoeff(), 1e-4 * scale) << model.NameOf(pair);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace dgd_demos
