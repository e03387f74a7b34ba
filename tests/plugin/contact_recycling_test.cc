// Contacts of bodies that lie still: when they are kept, and what makes them be found anew.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <new>
#include <numbers>
#include <utility>

#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "support/random.h"

namespace dgd_test {
namespace {

class RestingPair : public testing::Test {
 protected:
  RestingPair() {
    world_.AddGround();
    body_ = &world_.Add(box_, 1, Vec(0, 0, 0.499));
    Detect();
  }

  /// One collision detection; whether the pair was told to be as it was.
  bool Detect() {
    const std::uint64_t before = Resting();
    world_.Detect();
    return Resting() > before;
  }

  std::uint64_t Resting() const {
    std::uint64_t resting = 0;
    for (const dgd_bullet::PairStatistics& pair : world_.statistics().pairs) resting += pair.resting;
    return resting;
  }

  btPersistentManifold& Manifold() { return *world_.dispatcher().getManifoldByIndexInternal(0); }
  void MoveBody(const btVector3& way) { body_->getWorldTransform().getOrigin() += way; }

  TestWorld world_{Route::kConfiguration, Counting()};
  btBoxShape& box_ = world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  btRigidBody* body_ = nullptr;
};

TEST_F(RestingPair, Still_KeepsItsContactsAndTheirImpulses) {
  Manifold().getContactPoint(0).m_appliedImpulse = 7;
  const int life_time = Manifold().getContactPoint(0).getLifeTime();
  for (int i = 1; i <= 3; ++i) {
    EXPECT_TRUE(Detect());
    EXPECT_EQ(Manifold().getNumContacts(), 4);
    EXPECT_EQ(Manifold().getContactPoint(0).m_appliedImpulse, btScalar(7));
    EXPECT_EQ(Manifold().getContactPoint(0).getLifeTime(), life_time + i);
  }
}

TEST_F(RestingPair, MovedWithinTheDistance_HasItsDistancesBroughtUpToDate) {
  MoveBody(Vec(0, 0, 1e-5));
  EXPECT_TRUE(Detect());
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(double(Manifold().getContactPoint(i).getDistance()), -0.001 + 1e-5, 1e-6);
}

// A pair that rests from its first step on has had no second one that would have found its points sticking.
TEST_F(RestingPair, PointsThatStick_AreHeldWhereTheyAre) {
  world_.world().getDispatchInfo().m_timeStep = btScalar(TestWorld::kTimeStep);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(Manifold().getContactPoint(i).m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR, 0);
    Manifold().getContactPoint(i).m_appliedImpulse = btScalar(i > 0);
  }
  ASSERT_TRUE(Detect());
  for (int i = 0; i < 4; ++i) {
    const btManifoldPoint& point = Manifold().getContactPoint(i);
    const bool is_held = (point.m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR) != 0;
    EXPECT_EQ(is_held, point.m_appliedImpulse > 0) << "what carries nothing does not stick";
  }
}

TEST_F(RestingPair, PointsThatStickNoLonger_AreLetGo) {
  for (int i = 0; i < 4; ++i) Manifold().getContactPoint(i).m_appliedImpulse = 1;
  ASSERT_TRUE(Detect());
  for (int i = 0; i < 4; ++i) Manifold().getContactPoint(i).m_appliedImpulseLateral1 = 1;
  ASSERT_TRUE(Detect());
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(Manifold().getContactPoint(i).m_contactPointFlags & BT_CONTACT_FLAG_FRICTION_ANCHOR, 0);
  }
}

// Four millimetres across, ten metres from the origin: a twelfth of its threshold is a few of its pose's last digits.
TEST_F(RestingPair, BodyThatItsPosesRoundingMoves_IsNotAtRestInFloat) {
  btBoxShape& tiny = world_.Make<btBoxShape>(Vec(0.002, 0.002, 0.002));
  world_.Add(tiny, 1, Vec(7, 7, 0.00199));
  Detect();
  const std::uint64_t before = Resting();
  Detect();
  EXPECT_EQ(Resting() - before, sizeof(btScalar) == 8 ? 2U : 1U) << "the other one rests";
}

TEST_F(RestingPair, SmallSteps_AddUpFromWhereTheContactsWereFound) {
  int kept = 0;
  for (int i = 0; i < 30; ++i) {
    MoveBody(Vec(2e-4, 0, 0));
    kept += Detect();
  }
  // 6 mm, a new find for each 1.4 or so: the threshold is 17 mm.
  EXPECT_GE(kept, 20);
  EXPECT_LE(kept, 26);
}

TEST_F(RestingPair, WhateverChanges_IsFoundAnew) {
  const std::pair<const char*, std::function<void()>> changes[] = {
      {"moved", [&] { MoveBody(Vec(2e-3, 0, 0)); }},
      {"turned", [&] { body_->getWorldTransform().setRotation(btQuaternion(Vec(0, 0, 1), btScalar(5e-3))); }},
      {"margin", [&] { box_.setMargin(btScalar(0.02)); }},
      {"scaling", [&] { box_.setLocalScaling(Vec(1, 1, 1.001)); }},
      {"contacts cleared", [&] { Manifold().clearManifold(); }},
      {"one contact removed", [&] { Manifold().removeContactPoint(2); }},
      {"velocity", [&] { body_->setLinearVelocity(Vec(0, 0, -1)); }},
  };
  for (const auto& [name, change] : changes) {
    SCOPED_TRACE(name);
    ASSERT_TRUE(Detect());
    change();
    const bool moves = body_->getLinearVelocity().length2() > 0;
    EXPECT_EQ(Detect(), moves) << "what only may move, is where it was";
    EXPECT_EQ(Manifold().getNumContacts(), 4);
  }
}

TEST_F(RestingPair, AnotherShapeAtTheSamePlace_IsSeen) {
  btCylinderShapeZ& cylinder = world_.Make<btCylinderShapeZ>(Vec(0.4, 0.4, 0.5));
  ASSERT_TRUE(Detect());
  body_->setCollisionShape(&cylinder);
  EXPECT_FALSE(Detect());
  EXPECT_TRUE(Detect());
  cylinder.setLocalScaling(Vec(1, 1, 1.002));
  EXPECT_FALSE(Detect());
  EXPECT_NEAR(double(Manifold().getContactPoint(0).getDistance()), -0.002, 1e-5);
}

// A point that is where the body was a step ago is behind a ball, and pushes it on.
TEST_F(RestingPair, BallThatMayRoll_IsNotAtRest) {
  btSphereShape& ball = world_.Make<btSphereShape>(btScalar(0.5));
  body_->setCollisionShape(&ball);
  Detect();
  EXPECT_FALSE(Detect());
  EXPECT_EQ(Manifold().getNumContacts(), 1);
}

TEST_F(RestingPair, ShapeOfTheSameSizeAtTheSameAddress_IsSeen) {
  alignas(16) unsigned char memory[sizeof(btCylinderShapeZ)];
  btCylinderShape* shape = new (memory) btCylinderShapeZ(Vec(0.5, 0.5, 0.5));
  body_->setCollisionShape(shape);
  Detect();
  ASSERT_TRUE(Detect());
  shape->~btCylinderShape();
  shape = new (memory) btCylinderShape(Vec(0.5, 0.5, 0.5));
  EXPECT_FALSE(Detect());
  body_->setCollisionShape(&box_);
  shape->~btCylinderShape();
}

TEST_F(RestingPair, HullWhosePointMoves_IsSeen) {
  const auto hull = MakePrism(4, 0.5, 0.5);
  body_->setCollisionShape(hull.get());
  hull->setMargin(0);
  Detect();
  ASSERT_TRUE(Detect());
  hull->getUnscaledPoints()[0].setZ(btScalar(-0.51));
  hull->recalcLocalAabb();
  EXPECT_FALSE(Detect());
  body_->setCollisionShape(&box_);
}

TEST_F(RestingPair, FrictionOfTheBodies_CountsAtOnce) {
  body_->setFriction(btScalar(0.25));
  ASSERT_TRUE(Detect());
  const double ground = double(Manifold().getBody0() == body_ ? Manifold().getBody1()->getFriction()
                                                              : Manifold().getBody0()->getFriction());
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(double(Manifold().getContactPoint(i).m_combinedFriction), 0.25 * ground, 1e-7);
  }
}

TEST_F(RestingPair, ContactsThatTheAppColours_AreHandedOverAtEachStep) {
  body_->setCollisionFlags(body_->getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  EXPECT_FALSE(Detect());
  EXPECT_FALSE(Detect());
  body_->setCollisionFlags(body_->getCollisionFlags() & ~btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  Detect();
  EXPECT_TRUE(Detect());
}

TEST_F(RestingPair, NotANumber_IsNoRest) {
  ASSERT_TRUE(Detect());
  const btTransform pose = body_->getWorldTransform();
  body_->getWorldTransform().getOrigin().setX(std::numeric_limits<btScalar>::quiet_NaN());
  EXPECT_FALSE(Detect());
  body_->setWorldTransform(pose);
}

TEST(RestingPairOption, Off_FindsAnewAtEachStep) {
  dgd_bullet::Options options;
  options.count_pairs = true;
  options.keep_resting_contacts = false;
  TestWorld world(Route::kConfiguration, options);
  world.AddGround();
  world.Add(world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5)), 1, Vec(0, 0, 0.499));
  for (int i = 0; i < 3; ++i) world.Detect();
  EXPECT_EQ(world.statistics().pairs[0].resting, 0U);
}

// Near enough to be a pair, too far apart for a contact: what is kept of that must not hide what a shot makes of it.
TEST(RestingPairOption, BodyAtRestThatIsShotAtAWall_IsStopped) {
  TestWorld world(Route::kConfiguration);
  world.world().setGravity(Vec(0, 0, 0));
  world.Add(world.Make<btBoxShape>(Vec(1, 1, 0.05)), 0, Vec(0, 0, 0));
  btRigidBody& body = world.Add(world.Make<btBoxShape>(Vec(0.1, 0.1, 0.1)), 1, Vec(0, 0, 0.18));
  for (int i = 0; i < 3; ++i) {
    world.Detect();
    ASSERT_EQ(world.dispatcher().getNumManifolds(), 1);
    ASSERT_TRUE(world.Points().empty());
  }
  body.setLinearVelocity(Vec(0, 0, -240));
  world.Simulate(0.1);
  EXPECT_GT(double(body.getWorldTransform().getOrigin().z()), 0.14);
}

/// A body that is carried along keeps its contacts, and not as they were: the carrier's normal turns with it.
TEST(RestingPairOption, OnATurningCarrier_NormalsTurnWithIt) {
  TestWorld world(Route::kConfiguration, Counting());
  btRigidBody& carrier = world.Add(world.Make<btBoxShape>(Vec(1, 1, 0.1)), 0, Vec(0, 0, 0));
  btRigidBody& rider = world.Add(world.Make<btBoxShape>(Vec(0.2, 0.2, 0.2)), 1, Vec(0, 0, 0.299));
  for (int step = 0; step <= 100; ++step) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1e-3 * step, Vector::UnitX()).toRotationMatrix();
    carrier.setWorldTransform(MakeTransform(turn, {0, 0, 0}));
    rider.setWorldTransform(MakeTransform(turn, turn * Vector(0, 0, 0.299)));
    world.Detect();
    const std::vector<btManifoldPoint> points = world.Points();
    ASSERT_EQ(points.size(), 4U);
    for (const btManifoldPoint& point : points) {
      EXPECT_NEAR(std::abs(ToEigen(point.m_normalWorldOnB).dot(turn * Vector::UnitZ())), 1, 1e-6) << step;
      EXPECT_NEAR(double(point.getDistance()), -0.001, 1e-6);
    }
  }
  EXPECT_GE(world.statistics().pairs[0].resting, 95U);
}

/// Where no face holds a contact, the normal may turn by more than either body does.
TEST(RestingPairOption, EdgesThatAreCarriedAlong_AreFoundAnew) {
  TestWorld world(Route::kConfiguration, Counting());
  const Eigen::Matrix3d on_edge_x = Eigen::AngleAxisd(0.25 * std::numbers::pi, Vector::UnitX()).toRotationMatrix(),
                        on_edge_y = Eigen::AngleAxisd(0.25 * std::numbers::pi, Vector::UnitY()).toRotationMatrix();
  btBoxShape& box = world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  const double to_edge = std::sqrt(0.5);
  btRigidBody& below = world.Add(box, 0, Vec(0, 0, 0));
  btRigidBody& above = world.Add(box, 1, Vec(0, 0, 0));
  for (int step = 0; step <= 10; ++step) {
    below.setWorldTransform(MakeTransform(on_edge_x, {1e-4 * step, 0, 0}));
    above.setWorldTransform(MakeTransform(on_edge_y, {1e-4 * step, 0, 2 * to_edge - 0.001}));
    world.Detect();
    ASSERT_EQ(world.Points().size(), 1U) << step;
    EXPECT_NEAR(double(world.Points()[0].getDistance()), -0.001, 1e-6);
  }
  EXPECT_EQ(world.statistics().pairs[0].resting, 0U);
}

/// What slides over a face on one contact: a box on its corner as it is, a ball on a point that is another in each
/// step.
TEST(RestingPairOption, OnOneContact_CornersAreKeptAndBallsFoundAnew) {
  const Eigen::Matrix3d on_corner =
      Eigen::AngleAxisd(std::acos(1 / std::sqrt(3.0)), Vector(1, -1, 0).normalized()).toRotationMatrix();
  for (const bool is_ball : {false, true}) {
    TestWorld world(Route::kConfiguration, Counting());
    btBoxShape& box = world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
    btConvexShape* shape = &box;
    double reach = std::sqrt(0.75);
    if (is_ball) {
      shape = &world.Make<btSphereShape>(btScalar(0.5));
      reach = 0.5;
    }
    world.Add(world.Make<btBoxShape>(Vec(2, 2, 0.5)), 0, Vec(0, 0, 0));
    btRigidBody& body = world.Add(*shape, 1, Vec(0, 0, 0));
    for (int step = 0; step < 40; ++step) {
      body.setWorldTransform(MakeTransform(on_corner, {1e-4 * step, 0, 0.5 + reach - 0.001}));
      world.Detect();
      ASSERT_EQ(world.Points().size(), 1U) << step;
      EXPECT_NEAR(double(world.Points()[0].getDistance()), -0.001, 1e-6);
    }
    const std::uint64_t resting = world.statistics().pairs[0].resting;
    EXPECT_TRUE(is_ball ? resting == 0 : resting >= 30) << resting;
  }
}

/// Sinks, slides and rocks by less than its contacts are kept for: they have the distances that are found anew.
TEST(RestingPairOption, LittleByLittleOnAFace_DistancesAreThoseFoundAnew) {
  dgd_bullet::Options anew = Counting();
  anew.keep_resting_contacts = false;
  TestWorld world(Route::kConfiguration, Counting()), reference(Route::kConfiguration, anew);
  btRigidBody *body[2], *floor[2];
  TestWorld* const worlds[2] = {&world, &reference};
  for (int i = 0; i < 2; ++i) {
    floor[i] = &worlds[i]->Add(worlds[i]->Make<btBoxShape>(Vec(2, 2, 0.5)), 0, Vec(0, 0, 0));
    body[i] = &worlds[i]->Add(worlds[i]->Make<btBoxShape>(Vec(0.5, 0.3, 0.5)), 1, Vec(0, 0, 1));
  }
  Random random(TestSeed());
  Eigen::Vector3d place(0, 0, 0.999), turn(0.002, 0.001, 0);
  Eigen::Matrix3d carried = Eigen::Matrix3d::Identity();
  for (int step = 0; step < 300; ++step) {
    for (int axis = 0; axis < 3; ++axis) {
      place[axis] += random.Uniform(-2e-5, 2e-5);
      turn[axis] += random.Uniform(-2e-5, 2e-5);
    }
    carried = Eigen::AngleAxisd(0.01, Vector(1, 2, 3).normalized()).toRotationMatrix() * carried;
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    for (int i = 0; i < 2; ++i) {
      floor[i]->setWorldTransform(MakeTransform(carried, {0, 0, 0}));
      body[i]->setWorldTransform(MakeTransform(carried * rotation, carried * place));
      worlds[i]->Detect();
    }
    const auto deepest = [](TestWorld& asked) {
      double distance = std::numeric_limits<double>::infinity();
      for (const btManifoldPoint& point : asked.Points()) distance = std::min(distance, double(point.getDistance()));
      return distance;
    };
    EXPECT_NEAR(deepest(world), deepest(reference), 2e-6) << step;
  }
  EXPECT_GE(world.statistics().pairs[0].resting, 150U);
  EXPECT_EQ(reference.statistics().pairs[0].resting, 0U);
}

/// A tilted box slides over the edge of another: its lowest corners come along, and what is above the edge is ever
/// higher.
TEST(RestingPairOption, SlidingTiltedOverAnEdge_DistancesAreNearlyThoseFoundAnew) {
  dgd_bullet::Options anew = Counting();
  anew.keep_resting_contacts = false;
  TestWorld world(Route::kConfiguration, Counting()), reference(Route::kConfiguration, anew);
  TestWorld* const worlds[2] = {&world, &reference};
  btRigidBody* body[2];
  for (int i = 0; i < 2; ++i) {
    worlds[i]->Add(worlds[i]->Make<btBoxShape>(Vec(0.2, 0.5, 0.5)), 0, Vec(0, 0, -0.5));
    body[i] = &worlds[i]->Add(worlds[i]->Make<btBoxShape>(Vec(0.2, 0.2, 0.2)), 1, Vec(0, 0, 1));
    worlds[i]->world().getDispatchInfo().m_timeStep = btScalar(TestWorld::kTimeStep);
  }
  const auto farthest = [](TestWorld& asked) {
    double distance = -std::numeric_limits<double>::infinity();
    for (const btManifoldPoint& point : asked.Points()) distance = std::max(distance, double(point.getDistance()));
    return distance;
  };
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(-0.01, Vector::UnitY()).toRotationMatrix();
  for (int step = 0; step < 100; ++step) {
    for (int i = 0; i < 2; ++i) {
      body[i]->setWorldTransform(MakeTransform(tilt, {0.15 - 1e-4 * step, 0, 0.203}));
      worlds[i]->Detect();
    }
    ASSERT_EQ(world.Points().size(), 4U);
    EXPECT_NEAR(farthest(world), farthest(reference), 4e-6) << step;
  }
  EXPECT_GE(world.statistics().pairs[0].resting, 50U);
}

}  // namespace
}  // namespace dgd_test
