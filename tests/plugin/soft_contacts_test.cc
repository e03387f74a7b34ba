// Contacts with a stiffness and a damping, against the spring and the dashpot that they stand for.
#include <gtest/gtest.h>

#include <vector>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr double kMass = 2, kSpeed = 1;

/// A body that falls onto soft ground without weight, and touches it after a share of the step.
class SoftImpact : public testing::TestWithParam<double> {
 protected:
  /// Makes the first step.
  /// @param stiffness, damping  Of the body.
  btRigidBody& Fall(btCollisionShape& shape, double stiffness, double damping) {
    world_.world().setGravity(Vec(0, 0, 0));
    world_.AddGround().setContactStiffnessAndDamping(btScalar(1e18), 0);
    const double gap = GetParam() * kSpeed * TestWorld::kTimeStep;
    btRigidBody& body = world_.Add(shape, kMass, Vec(0, 0, 0.5 + gap));
    body.setContactStiffnessAndDamping(btScalar(stiffness), btScalar(damping));
    body.setLinearVelocity(Vec(0, 0, -kSpeed));
    world_.Simulate(TestWorld::kTimeStep);
    return body;
  }

  double Impulse() {
    double sum = 0;
    for (const btManifoldPoint& point : world_.Points()) sum += double(point.m_appliedImpulse);
    return sum;
  }

  TestWorld world_{Route::kConfiguration};
};

TEST_P(SoftImpact, ActsForTheRestOfTheStep) {
  constexpr double kStiffness = 2000, kDamping = 1;
  btSphereShape ball(btScalar(0.5));
  Fall(ball, kStiffness, kDamping);
  const double rest = (1 - GetParam()) * TestWorld::kTimeStep;
  const double impulse = kSpeed * (kStiffness * rest * rest / 2 + kDamping * rest);
  EXPECT_NEAR(Impulse(), impulse, 0.02 * impulse);
}

TEST_P(SoftImpact, AtEachCornerOfABox) {
  constexpr double kStiffness = 500;
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  Fall(box, kStiffness, 0);
  const double rest = (1 - GetParam()) * TestWorld::kTimeStep;
  const double impulse = 4 * kSpeed * kStiffness * rest * rest / 2;
  EXPECT_NEAR(Impulse(), impulse, 0.02 * impulse);
}

TEST_P(SoftImpact, StiffAsRigid_EndsOnTheGround) {
  btSphereShape ball(btScalar(0.5));
  const btRigidBody& body = Fall(ball, 1e12, 0);
  EXPECT_NEAR(double(body.getWorldTransform().getOrigin().z()), 0.5, kLength);
}

INSTANTIATE_TEST_SUITE_P(Shares, SoftImpact, testing::Values(0.1, 0.5, 0.9));

}  // namespace
}  // namespace dgd_test
