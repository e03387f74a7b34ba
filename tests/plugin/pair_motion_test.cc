// How far bodies go within a step, by what Bullet says of them.
#include "pair_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "plugin/rigid_body.h"

namespace dgd_test {
namespace {

using dgd_bullet::PairMotion;
using dgd_bullet::Vector3;

constexpr double kTime = 0.5;  // s

class OfTwoBodies : public testing::Test {
 protected:
  /// Of a body that moves along x at 2 m/s and one at rest, both at the origin.
  PairMotion Motion() {
    moving_->setLinearVelocity(Vec(2, 0, 0));
    return {dgd_bullet::BoundedBody(*moving_), dgd_bullet::BoundedBody(*other_), kTime};
  }
  double Way() { return Motion().Approach(Vector3::Zero(), Vector3::UnitX()); }

  btBoxShape shape_{Vec(0.5, 0.5, 0.5)};
  std::unique_ptr<btRigidBody> moving_ = MakeRigidBody(shape_, 0, btTransform::getIdentity());
  std::unique_ptr<btRigidBody> other_ = MakeRigidBody(shape_, 1, btTransform::getIdentity());
};

TEST_F(OfTwoBodies, StaticBody_StandsStill) { EXPECT_EQ(Way(), 0); }

// setCollisionFlags(getCollisionFlags() | CF_KINEMATIC_OBJECT), as Bullet's manual has it.
TEST_F(OfTwoBodies, KinematicBodyStillFlaggedAsStatic_Moves) {
  ASSERT_TRUE(moving_->isStaticObject());
  moving_->setCollisionFlags(moving_->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  EXPECT_EQ(Way(), 2 * kTime);
}

TEST_F(OfTwoBodies, KinematicBodyFlaggedAsNothingElse_Moves) {
  moving_->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  EXPECT_EQ(Way(), 2 * kTime);
}

/// The angle about z by which a body turns in a step.
double TurnOf(const btRigidBody& body, const btRigidBody& other) {
  const PairMotion motion{dgd_bullet::BoundedBody(body), dgd_bullet::BoundedBody(other), kTime};
  return motion.MotionOfA({Eigen::Matrix3d::Identity(), Vector3::Zero()}).rotation.z();
}

// Bullet turns bodies by less than their velocity where that is more than 45 degrees a step.
TEST_F(OfTwoBodies, FastSpinner_TurnsAsBulletTurnsIt) {
  for (const double turn : {0.5, 1.0, 4.0, 20.0}) {
    other_->setAngularVelocity(Vec(0, 0, turn / kTime));
    btTransform end;
    other_->predictIntegratedTransform(btScalar(kTime), end);
    const double angle = std::atan2(double(end.getBasis()[1][0]), double(end.getBasis()[0][0]));
    EXPECT_NEAR(TurnOf(*other_, *moving_), angle, 1e-5) << turn;
  }
}

TEST_F(OfTwoBodies, KinematicSpinner_TurnsAsTheAppTurnsIt) {
  moving_->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  moving_->setAngularVelocity(Vec(0, 0, 3 / kTime));
  EXPECT_NEAR(TurnOf(*moving_, *other_), 3, 1e-5);
}

/// Whether a box on edge that turns goes on turning about its next edge, with its base along x.
/// @param spin  rad/s.
bool TurnsOver(double half_base, double half_height, double spin = 100) {
  btBoxShape shape(Vec(half_base, 0.1, half_height));
  const auto box = MakeRigidBody(shape, 1, At(0, 0, half_height));
  const auto ground = MakeRigidBody(shape, 0, At(0, 0, -half_height));
  box->setAngularVelocity(Vec(0, spin, 0));
  box->setLinearVelocity(Vec(spin * half_height, 0, -spin * half_base));
  box->applyCentralForce(Vec(0, 0, -9.81));
  const PairMotion motion(dgd_bullet::BoundedBody(*ground), dgd_bullet::BoundedBody(*box), kTime);
  return motion.TurnOver({-half_base, 0, 0}, {half_base, 0, 0}, Vector3::UnitZ());
}

// Housner's impact turns a box about its next edge if its base is less than the root of two times its height.
TEST(TurnOver, Box_RocksIfItIsSlender) {
  EXPECT_TRUE(TurnsOver(0.1, 0.5));
  EXPECT_TRUE(TurnsOver(1.39, 1));
  EXPECT_FALSE(TurnsOver(1.44, 1));
  EXPECT_FALSE(TurnsOver(0.5, 0.02));
}

// About an edge a box of base 2 b and height 2 h turns by g b / (4/3 (b^2 + h^2)) within a second of weight.
TEST(TurnOver, Box_StandsIfItsWeightAloneGivesItTheSpeedInAStep) {
  const double by_weight = kTime * 9.81 * 0.1 / (4.0 / 3 * (0.1 * 0.1 + 0.5 * 0.5));
  EXPECT_FALSE(TurnsOver(0.1, 0.5, 0.99 * by_weight));
  EXPECT_TRUE(TurnsOver(0.1, 0.5, 1.01 * by_weight));
}

}  // namespace
}  // namespace dgd_test
