// Velocities of multibodies' links, against where Bullet moves the links.
#include "body_velocity.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "pair_motion.h"
#include "plugin/rigid_body.h"

namespace dgd_test {
namespace {

using dgd_bullet::BodyVelocity;

constexpr double kTime = 1e-3;  // s
constexpr double kMass = 2;     // kg, of each link.

/// A base and a chain of links by a joint of each kind, with a second link on the first; in a bent pose.
class OfAMultibody : public testing::Test {
 protected:
  void SetUp() override {
    const btQuaternion turned(Vec(1, 2, 3).normalized(), btScalar(0.7));
    const btVector3 inertia = Vec(1, 1, 1), axis = Vec(2, -1, 1).normalized();
    const btVector3 to_pivot = Vec(0.3, 0.1, 0.2), from_pivot = Vec(-0.1, 0.4, 0.2);
    body_.setupRevolute(0, kMass, inertia, -1, turned, axis, to_pivot, from_pivot, true);
    body_.setupPrismatic(1, kMass, inertia, 0, turned, axis, to_pivot, from_pivot, true);
    body_.setupSpherical(2, kMass, inertia, 1, turned, to_pivot, from_pivot, true);
    body_.setupFixed(3, kMass, inertia, 2, turned, to_pivot, from_pivot);
    body_.setupRevolute(4, kMass, inertia, 3, turned, axis, to_pivot, from_pivot, true);
    body_.setupRevolute(5, kMass, inertia, 0, turned, axis, to_pivot, from_pivot, true);
    body_.finalizeMultiDof();
    body_.setBasePos(Vec(0.5, 1, -1));
    body_.setWorldToBaseRot(turned);
    for (int i = -1; i < body_.getNumLinks(); ++i) {
      links_.push_back(std::make_unique<btMultiBodyLinkCollider>(&body_, i));
      links_.back()->setCollisionShape(&shape_);
      if (i < 0) {
        body_.setBaseCollider(links_.back().get());
      } else {
        body_.getLink(i).m_collider = links_.back().get();
      }
    }
    SetVelocity(1);
    Move(0.4);
  }

  /// All joints and the base move, `factor` times as fast.
  void SetVelocity(double factor) {
    std::vector<btScalar> change(std::size_t(6 + body_.getNumDofs()));
    for (std::size_t i = 0; i < change.size(); ++i) {
      change[i] = btScalar(factor * (0.3 + 0.2 * double(i % 4))) - body_.getVelocityVector()[i];
    }
    body_.applyDeltaVeeMultiDof(change.data(), 1);
  }
  void Move(double time) {
    body_.stepPositionsMultiDof(btScalar(time));
    btAlignedObjectArray<btQuaternion> rotations;
    btAlignedObjectArray<btVector3> places;
    body_.updateCollisionObjectWorldTransforms(rotations, places);
  }

  btBoxShape shape_{Vec(0.1, 0.1, 0.1)};
  btMultiBody body_{6, kMass, Vec(1, 1, 1), /*fixedBase=*/false, /*canSleep=*/false};
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> links_;
};

TEST_F(OfAMultibody, LinkMovesAsItsVelocitySays) {
  const double tolerance = sizeof(btScalar) == sizeof(float) ? 5e-3 : 1e-5;
  std::vector<BodyVelocity> velocities;
  std::vector<btTransform> ahead, behind;
  for (const auto& link : links_) velocities.push_back(dgd_bullet::VelocityOf(*link));
  Move(kTime);
  for (const auto& link : links_) ahead.push_back(link->getWorldTransform());
  Move(-2 * kTime);
  for (const auto& link : links_) behind.push_back(link->getWorldTransform());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const btScalar time = btScalar(2 * kTime);
    const btVector3 linear = (ahead[i].getOrigin() - behind[i].getOrigin()) / time;
    const btQuaternion turn = ahead[i].getRotation() * behind[i].getRotation().inverse();
    // By the sine of half a small angle.
    const btVector3 angular = btVector3(turn.x(), turn.y(), turn.z()) * (2 / turn.w() / time);
    EXPECT_NEAR((velocities[i].linear - linear).length(), 0, tolerance) << "of link " << int(i) - 1;
    EXPECT_NEAR((velocities[i].angular - angular).length(), 0, tolerance) << "of link " << int(i) - 1;
  }
}

TEST_F(OfAMultibody, LinkAtRest_HasNoVelocity) {
  SetVelocity(0);
  for (const auto& link : links_) {
    EXPECT_EQ(dgd_bullet::VelocityOf(*link).linear.length(), 0);
    EXPECT_EQ(dgd_bullet::VelocityOf(*link).angular.length(), 0);
  }
}

TEST_F(OfAMultibody, ForcesOnAMovingBase_MoveAllLinks) {
  const double mass = kMass * (1 + body_.getNumLinks());
  body_.addBaseForce(Vec(0, 0, -6));
  body_.addLinkForce(2, Vec(0, 8, 0));
  for (const auto& link : links_) {
    EXPECT_NEAR((dgd_bullet::AccelerationOf(*link) - Vec(0, 8 / mass, -6 / mass)).length(), 0, 1e-6);
  }
  // As of an arm, whose motors hold it up.
  body_.setBaseVel(Vec(0, 0, 0));
  body_.setBaseOmega(Vec(0, 0, 0));
  for (const auto& link : links_) EXPECT_EQ(dgd_bullet::AccelerationOf(*link).length(), 0);
}

TEST(OfABaseAlone, ForcesMoveItAsARigidBody) {
  btBoxShape shape(Vec(0.1, 0.1, 0.1));
  btMultiBody body(0, kMass, Vec(1, 1, 1), /*fixedBase=*/false, /*canSleep=*/false);
  body.finalizeMultiDof();
  btMultiBodyLinkCollider base(&body, -1);
  base.setCollisionShape(&shape);
  body.setBaseVel(Vec(1, 0, 0));
  body.addBaseForce(Vec(0, 0, -6));
  const auto rigid = MakeRigidBody(shape, 3 * kMass, btTransform::getIdentity());
  const dgd_bullet::PairMotion motion(dgd_bullet::BoundedBody(base), dgd_bullet::BoundedBody(*rigid), kTime);
  EXPECT_NEAR(motion.Approach(dgd_bullet::Vector3::Zero(), dgd_bullet::Vector3::UnitZ()), -3 * kTime * kTime, 1e-12);
  EXPECT_NEAR(motion.Approach(dgd_bullet::Vector3::Zero(), dgd_bullet::Vector3::UnitX()), kTime, 1e-9);
}

}  // namespace
}  // namespace dgd_test
