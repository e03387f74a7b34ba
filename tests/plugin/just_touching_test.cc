// The sign of a contact's distance, which apps take for whether bodies touch.
#include <gtest/gtest.h>

#include <vector>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

class JustTouching : public testing::Test {
 protected:
  JustTouching() {
    world_.AddGround();
    box_ = &world_.Add(world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.5 + kGap));
    box_->setActivationState(DISABLE_DEACTIVATION);
  }

  /// The distances of the box's contacts after a step.
  std::vector<double> Step() {
    world_.Simulate(TestWorld::kTimeStep);
    std::vector<double> distances;
    for (const btManifoldPoint& point : world_.Points()) distances.push_back(double(point.getDistance()));
    return distances;
  }

  static constexpr double kGap = 1e-5;  // Metres; half of what counts as near.

  TestWorld world_{Route::kConfiguration};
  btRigidBody* box_ = nullptr;
};

// As in space, or where an app moves bodies: there is a gap, however small, and nothing that closes it.
TEST_F(JustTouching, BodyThatHoversOverAnother_DoesNotTouch) {
  world_.world().setGravity(Vec(0, 0, 0));
  box_->setGravity(Vec(0, 0, 0));
  for (int i = 0; i < 3; ++i) {
    const std::vector<double> distances = Step();
    ASSERT_EQ(distances.size(), 4U);
    for (const double distance : distances) EXPECT_NEAR(distance, kGap, 1e-7);
  }
}

// The gap is closed within the first step, and what roundoff leaves of one later carries the weight. In float the box
// often lies at a distance of exactly 0.
TEST_F(JustTouching, BodyThatItsWeightBringsDown_Touches) {
  for (int i = 0; i < 240; ++i) {
    const std::vector<double> distances = Step();
    ASSERT_EQ(distances.size(), 4U);
    for (const double distance : distances) {
      EXPECT_LE(distance, 0) << i;
      EXPECT_GT(distance, -kGap) << i;
    }
  }
}

}  // namespace
}  // namespace dgd_test
