// Contract of the smoothing: never worse, not too long, free of collisions; and it visibly works.
#include "motion/path_smoothing.h"

#include <gtest/gtest.h>

#include "motion/motion_checks.h"

namespace dgd_demos {
namespace {

// The arm folds, turns, and reaches out between the posts. Of such paths that are free, the one with the least
// clearance: below a millimetre.
JointPath TightPath(const MotionScene& scene, const CollisionModel& model) {
  JointPath best;
  double least = std::numeric_limits<double>::infinity();
  PlaneCache planes(model);
  for (double lift = -2.4; lift <= -1.2; lift += 0.1) {
    for (double elbow = 1.6; elbow <= 2.8; elbow += 0.05) {
      JointPath path = {scene.start, scene.start, scene.goal, scene.goal};
      for (std::size_t i : {1, 2}) {
        path[i][1] = lift;
        path[i][2] = elbow;
      }
      const double clearance = LeastSignedDistance(model, path, 0.01, planes);
      if (clearance <= 0 || clearance >= least) continue;
      least = clearance;
      best = path;
    }
  }
  return best;
}

TEST(PathSmoothingTest, TightPath_GainsClearanceWithinTheAllowedLength) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  const JointPath path = TightPath(scene, model);
  ASSERT_FALSE(path.empty());
  const double before = MeasureClearance(model, path, 0.003).signed_distance.value;
  EXPECT_GT(before, 0);
  EXPECT_LT(before, 1e-3);
  const SmoothingOptions options;
  const JointPath smooth = Smooth(model, path, options);
  EXPECT_EQ(smooth.front(), path.front());
  EXPECT_EQ(smooth.back(), path.back());
  EXPECT_LE(Length(smooth), options.most_lengthening * Length(path) * (1 + 1e-12));
  EXPECT_GE(MeasureClearance(model, smooth, 0.003).signed_distance.value, 0.01);
  EXPECT_FALSE(FindUnprovenState(model, smooth, 0.003).has_value());
  for (const Configuration& state : smooth) EXPECT_EQ(FindJointBeyondLimits(model.arm(), state), std::nullopt);
}

// Nothing to gain: the least clearance is that of the start itself.
TEST(PathSmoothingTest, PathAsFreeAsItsEnds_IsKept) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  const JointPath path = {scene.start, scene.start + Configuration::Unit(6, 0) * 0.05};
  PlaneCache planes(model);
  const JointPath smooth = Smooth(model, path);
  EXPECT_GE(LeastSignedDistance(model, smooth, 0.01, planes), LeastSignedDistance(model, path, 0.01, planes));
  EXPECT_LE(Length(smooth), 1.1 * Length(path));
}

}  // namespace
}  // namespace dgd_demos
