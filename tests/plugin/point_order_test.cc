// The order of a manifold's points for Bullet's solver: Options::order_points_by_impulse.
#include <gtest/gtest.h>

#include <array>

#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr int kPoints = 4;

/// A box on another one, whose points have carried impulses that increase by their index; the impulses after the next
/// step's detection, point by point.
/// @param mass   Of the lower box, kg; 0 if it cannot move.
/// @param moves  Whether the box moves before that, so that recycled contacts are updated, or found from scratch.
std::array<btScalar, kPoints> ImpulsesAfterStep(bool orders, bool recycles, bool moves, btScalar mass = 1) {
  dgd_bullet::Options options;
  options.order_points_by_impulse = orders;
  options.keep_resting_contacts = recycles;
  TestWorld world(Route::kConfiguration, options);
  btBoxShape& shape = world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  world.Add(shape, mass, Vec(0, 0, -0.5));
  btRigidBody& box = world.Add(shape, 1, Vec(0, 0, 0.499));
  world.Detect();
  btPersistentManifold& manifold = *world.dispatcher().getManifoldByIndexInternal(0);
  EXPECT_EQ(manifold.getNumContacts(), kPoints);
  for (int i = 0; i < kPoints; ++i) manifold.getContactPoint(i).m_appliedImpulse = btScalar(1 + i);
  if (moves) box.getWorldTransform().getOrigin() += Vec(1e-4, 0, 0);
  world.Detect();
  std::array<btScalar, kPoints> impulses{};
  for (int i = 0; i < kPoints; ++i) impulses[std::size_t(i)] = manifold.getContactPoint(i).m_appliedImpulse;
  return impulses;
}

TEST(PointOrder, On_PointThatCarriedMostComesFirst) {
  EXPECT_EQ(ImpulsesAfterStep(true, false, false)[0], btScalar(kPoints)) << "contacts that are found again";
  EXPECT_EQ(ImpulsesAfterStep(true, true, true)[0], btScalar(kPoints)) << "recycled contacts whose normals turn";
}

// A change of the order in which Bullet's solver goes through the points makes bodies tremble.
TEST(PointOrder, On_PointsStayInTheirOrderWhereBodiesRest) {
  const std::array<btScalar, kPoints> as_they_were{1, 2, 3, 4};
  EXPECT_EQ(ImpulsesAfterStep(true, true, false), as_they_were);
}

TEST(PointOrder, On_PointsStayInTheirOrderOnWhatCannotMove) {
  const std::array<btScalar, kPoints> as_they_were{1, 2, 3, 4};
  EXPECT_EQ(ImpulsesAfterStep(true, false, false, 0), as_they_were);
  EXPECT_EQ(ImpulsesAfterStep(true, true, true, 0), as_they_were);
}

TEST(PointOrder, Off_PointsStayInTheirOrder) {
  const std::array<btScalar, kPoints> as_they_were{1, 2, 3, 4};
  EXPECT_EQ(ImpulsesAfterStep(false, false, false), as_they_were);
  EXPECT_EQ(ImpulsesAfterStep(false, true, true), as_they_were);
}

}  // namespace
}  // namespace dgd_test
