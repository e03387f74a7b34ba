// Contract of the collision checks: right in every state, whatever was checked before it.
#include "motion/state_checker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/motion_checks.h"

namespace dgd_demos {
namespace {

TEST(ConvexBodyTest, SupportValue_IsThatOfTheSet) {
  Random random(1, 0);
  const Polyhedron hull = ConvexHull({{0, 0, 0}, {0.3, 0, 0}, {0, 0.2, 0}, {0, 0, 0.4}, {0.3, 0.3, 0.3}});
  for (const Shape& shape : {Shape(Sphere{0.3}), Shape(Capsule{0.1, 0.5}), Shape(Box{{0.1, 0.2, 0.3}}),
                             Shape(Cylinder{0.2, 0.5}), Shape(Cone{0.2, 0.5}), Shape(Hull{hull})}) {
    const ConvexBody body("body", shape);
    for (int i = 0; i < 100; ++i) {
      const dgd::Pose<double> pose{random.Rotation(), random.InBox({-1, -1, -1}, {1, 1, 1})};
      const Eigen::Vector3d normal = random.UnitVector();
      const Eigen::Vector3d local = pose.rotation.transpose() * normal;
      const double expected = normal.dot(pose * body.set().CoreSupport(local)) + body.set().Radius();
      EXPECT_NEAR(body.SupportValue(pose, normal), expected, 1e-14) << "shape " << shape.index();
    }
  }
}

TEST(StateCheckerTest, RandomStates_AgreeWithTheOracle) {
  const CollisionModel model(ShippedMotionScene());
  const MotionOracle oracle(model);
  using Shortcuts = StateChecker::Shortcuts;
  StateChecker cached(model), cold(model, Shortcuts::kNearestPoints), alone(model, Shortcuts::kNone);
  Random random(2, 0);
  int valid = 0, colliding = 0;
  for (int i = 0; i < 400; ++i) {
    const Configuration state = RandomState(model.arm(), random);
    const double distance = oracle.LeastDistance(state);
    if (std::abs(distance) <= kOracleError) continue;
    const std::optional<std::size_t> collision = cached.FindCollision(state);
    EXPECT_EQ(collision.has_value(), distance < 0) << state.transpose() << ", distance " << distance;
    EXPECT_EQ(cold.FindCollision(state), collision) << state.transpose();
    EXPECT_EQ(alone.FindCollision(state), collision) << state.transpose();
    ++(distance < 0 ? colliding : valid);
  }
  EXPECT_GE(valid, 100);
  EXPECT_GE(colliding, 100);
  EXPECT_GT(cached.counts().pairs_by_plane, cached.counts().pairs / 4);
  EXPECT_EQ(cached.counts().pairs, cold.counts().pairs);
  EXPECT_EQ(cold.counts().pairs_by_plane, 0);
}

// The planes are of use where planners need them: from one state to the next along a motion.
TEST(StateCheckerTest, AlongAMotion_PlanesDecideNearlyAll) {
  const MotionScene scene = ShippedMotionScene();
  const CollisionModel model(scene);
  StateChecker checker(model);
  for (int i = 0; i <= 200; ++i) {
    const Configuration state = scene.start + Configuration::Constant(6, 0.0005 * i);
    EXPECT_EQ(checker.FindCollision(state), std::nullopt) << i;
  }
  EXPECT_EQ(checker.counts().states, 201);
  EXPECT_EQ(checker.counts().pairs, 201 * static_cast<std::int64_t>(model.pairs().size()));
  EXPECT_GT(static_cast<double>(checker.counts().pairs_by_plane), 0.98 * static_cast<double>(checker.counts().pairs));
}

TEST(CollisionModelTest, Pairs_AreOfLinksThatCanMeet) {
  const CollisionModel model(ShippedMotionScene());
  for (const CheckedPair& pair : model.pairs()) {
    const auto &first = model.parts()[pair.first], &second = model.parts()[pair.second];
    ASSERT_TRUE(first.link.has_value());
    if (second.link) {
      EXPECT_GE(*first.link, *second.link + 2) << model.NameOf(pair);
    }
    EXPECT_NE(model.NameOf(pair), "wrist_3 and wrist_1") << "excluded by the scene";
    EXPECT_NE(model.NameOf(pair), "shoulder and table") << "excluded by the scene";
  }
  EXPECT_EQ(model.parts().size(), 14u);  // 9 of the arm, 5 obstacles.
}

// A second arm stands in the way like any obstacle.
TEST(CollisionModelTest, SecondArm_IsAnObstacleAtRest) {
  MotionScene scene = ShippedMotionScene();
  SceneArm second = scene.arms[0];
  second.arm.name = "other";
  scene.arms.push_back(second);
  const CollisionModel model(scene);
  EXPECT_EQ(model.parts().size(), 14u + 9u);
  StateChecker checker(model);
  const std::optional<std::size_t> collision = checker.FindCollision(second.rest);
  ASSERT_TRUE(collision.has_value());
  EXPECT_EQ(model.NameOf(model.pairs()[*collision]).substr(0, 19), "wrist_3 and other's");
}

}  // namespace
}  // namespace dgd_demos
