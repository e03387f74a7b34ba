// Pairs without a growth distance go to Bullet's own algorithm, and are counted; flat, tiny and coincident shapes need
// no fallback at all.
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "plugin/fallback_fixture.h"
#include "plugin/shape_zoo.h"

namespace dgd_test {
namespace {

// Two flat shapes without margins have no interior together: no scale at which they "just" touch (paper, Rem. 1). Their
// distance and their least translation exist all the same.
TEST_F(Fallback, TwoFlatTriangles_HaveTheirLeastTranslation) {
  Random random(TestSeed());
  const int count = TestCount(600, 100);
  int contacts_found = 0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const auto point = [&] { return ToBullet(random.InCube()); };
    btTriangleShape a(point(), point(), point()), b(point(), point(), point());
    for (btTriangleShape* triangle : {&a, &b}) triangle->setMargin(0);
    // A third of them with one centroid, a third parallel.
    btTransform pose = MakeTransform(random.Rotation(), 0.5 * random.InCube());
    if (i % 3 == 0) {
      const auto centroid = [](const btTriangleShape& t) -> btVector3 {
        return (t.m_vertices1[0] + t.m_vertices1[1] + t.m_vertices1[2]) / 3;
      };
      pose.setOrigin(centroid(b) - pose.getBasis() * centroid(a));
    } else if (i % 3 == 1) {
      for (int corner = 0; corner < 3; ++corner) b.m_vertices1[corner] = pose.getBasis() * a.m_vertices1[corner];
    }
    PairQuery pair(dispatching_.dispatcher(), a, b);
    pair.SetPoses(pose, btTransform::getIdentity());
    const SignedDistance truth = DistanceOfShapes(pair.A(), pair.B());
    const double threshold = double(std::min(a.getContactBreakingThreshold(gContactBreakingThreshold),
                                             b.getContactBreakingThreshold(gContactBreakingThreshold)));
    for (int step = 0; step < 2; ++step) {
      const std::vector<Contact> contacts = pair.Step();
      if (truth.value > threshold + kLength) {
        EXPECT_TRUE(contacts.empty());
      } else if (truth.upper < threshold - kLength) {
        ExpectSound(pair, contacts);
        if (HasFailure()) return;
        EXPECT_NEAR(Deepest(contacts).depth, truth.value, truth.upper - truth.value + kLength);
        ++contacts_found;
      }
    }
  }
  EXPECT_GT(contacts_found, count / 2);
  ExpectCounts(0, 0);
}

TEST_F(Fallback, TwoFlatTriangles_HaveADistanceInClosestPointQueriesToo) {
  btTriangleShape triangle(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  triangle.setMargin(0);
  PairQuery ours(dispatching_.dispatcher(), triangle, triangle);
  ours.SetPoses(At(0, 0, 0.4), btTransform::getIdentity());
  const std::vector<Contact> contacts = ours.ClosestPoints(1);
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts[0].depth, 0.4, kLength);
  ExpectCounts(0, 0);
  EXPECT_EQ(dispatching_.dispatcher().getNumManifolds(), 0);
}

// One evaluation does not suffice: Bullet's own contacts, counted, in the pair's own manifold.
TEST_F(Fallback, TwoFlatTrianglesInTooFewIterations_AreLeftToBullet) {
  dgd_bullet::Options options;
  options.max_iterations = 1;
  Dispatching hurried(Route::kConfiguration, options);
  btTriangleShape triangle(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  triangle.setMargin(0);
  PairQuery ours(hurried.dispatcher(), triangle, triangle), bullets(builtin_.dispatcher(), triangle, triangle);
  const btTransform crossing =
      MakeTransform(Eigen::AngleAxisd(std::numbers::pi / 2, Vector::UnitX()).toRotationMatrix(), {0.1, 0.2, 0.2});
  for (PairQuery* pair : {&ours, &bullets}) pair->SetPoses(crossing, btTransform::getIdentity());
  const std::vector<Contact> contacts = ours.Step(), expected = bullets.Step();
  ASSERT_EQ(contacts.size(), expected.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_EQ(contacts[i].depth, expected[i].depth);
  EXPECT_EQ(hurried.statistics().fallbacks_no_interior, 1U);
  EXPECT_EQ(hurried.dispatcher().getNumManifolds(), 1);
}

// One margin between the two, or one solid, is enough.
TEST_F(Fallback, OneFlatShape_NeedsNoFallback) {
  btTriangleShape flat(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0)),
      rounded(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  flat.setMargin(0);
  btBoxShape sharp(Vec(0.5, 0.5, 0.5));
  sharp.setMargin(0);
  PairQuery with_margin(dispatching_.dispatcher(), rounded, flat), with_solid(dispatching_.dispatcher(), sharp, flat);
  with_margin.SetPoses(At(0.1, 0.1, 0.035), btTransform::getIdentity());
  with_solid.SetPoses(At(0.1, 0.1, 0.49), btTransform::getIdentity());
  ExpectSound(with_margin, with_margin.Step());
  ExpectSound(with_solid, with_solid.Step());
  ExpectCounts(0, 0);
}

// An iteration limit that cannot suffice: Bullet answers, and the count says why.
TEST_F(Fallback, TooFewIterations_AreCountedAsNotConverged) {
  dgd_bullet::Options options;
  options.max_iterations = 1;
  Dispatching hurried(Route::kConfiguration, options);
  const auto hull = MakePrism(7, 0.4, 0.3);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  PairQuery pair(hurried.dispatcher(), *hull, box), bullets(builtin_.dispatcher(), *hull, box);
  const btTransform pose =
      MakeTransform(Eigen::AngleAxisd(0.3, Vector(1, 2, 3).normalized()).toRotationMatrix(), {0.25, 0.2, 0.75});
  for (PairQuery* each : {&pair, &bullets}) each->SetPoses(pose, btTransform::getIdentity());
  const std::vector<Contact> contacts = pair.Step(), expected = bullets.Step();
  EXPECT_EQ(hurried.statistics().fallbacks_not_converged, 1U);
  ASSERT_EQ(contacts.size(), expected.size());
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts[0].depth, expected[0].depth);
}

// Flat and thinner hulls: the margin is their interior.
TEST_F(Fallback, HullsOfFewOrCoplanarPoints_NeedNoFallback) {
  const std::vector<std::vector<btVector3>> point_sets = {
      {Vec(0, 0, 0)},
      {Vec(0.3, 0.1, 0), Vec(0.3, 0.1, 0)},
      {Vec(-0.4, 0, 0), Vec(0.4, 0.1, 0)},
      {Vec(-0.4, 0, 0), Vec(0, 0, 0), Vec(0.4, 0, 0)},
      {Vec(-0.4, -0.3, 0), Vec(0.4, -0.3, 0), Vec(0, 0.5, 0)},
      {Vec(-0.4, -0.4, 0), Vec(0.4, -0.4, 0), Vec(0.4, 0.4, 0), Vec(-0.4, 0.4, 0), Vec(0, 0, 0)},
      {Vec(-0.4, -0.4, 0), Vec(0.4, -0.4, 0.01), Vec(0.4, 0.4, 1e-9), Vec(-0.4, 0.4, -1e-7)},
      {Vec(0, 0, 0), Vec(1e-4, 0, 0), Vec(0, 1e-4, 0), Vec(0, 0, 1e-4)}};
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  Random random(TestSeed());
  for (std::size_t i = 0; i < point_sets.size(); ++i) {
    btConvexHullShape hull;
    for (const btVector3& point : point_sets[i]) hull.addPoint(point);
    for (int pose = 0; pose < 20; ++pose) {
      SCOPED_TRACE("hull " + std::to_string(i) + ", pose " + std::to_string(pose));
      for (btConvexShape* partner : {static_cast<btConvexShape*>(&box), static_cast<btConvexShape*>(&hull)}) {
        PairQuery pair(dispatching_.dispatcher(), hull, *partner);
        const Eigen::Matrix3d rotation = random.Rotation();
        Vector position = 3 * random.UnitVector();
        pair.SetPoses(MakeTransform(rotation, position), btTransform::getIdentity());
        const SignedDistance far = DistanceOfShapes(pair.A(), pair.B());
        position -= (far.value + 0.002) * far.normal_b_to_a;  // 2 mm of overlap.
        pair.SetPoses(MakeTransform(rotation, position), btTransform::getIdentity());
        const std::vector<Contact> contacts = pair.Step();
        ExpectSound(pair, contacts);
        EXPECT_NEAR(Deepest(contacts).depth, -0.002, 1e-3);
        if (HasFailure()) return;
      }
    }
  }
  ExpectCounts(0, 0);
}

// Centres that coincide leave the direction open: any unit normal that parts the bodies will do.
TEST_F(Fallback, CoincidentAndNearlyCoincidentCentres_FiniteNormalThatParts) {
  for (const ZooShape& shape : MakeShapeZoo(1)) {
    for (const double offset : {0.0, 1e-300, 1e-17, 1e-12, 1e-8, 1e-5}) {
      SCOPED_TRACE(shape.name + " " + std::to_string(offset));
      PairQuery pair(dispatching_.dispatcher(), *shape.shape, *shape.shape);
      pair.SetPoses(At(offset, 0, -offset), btTransform::getIdentity());
      const std::vector<Contact> contacts = pair.Step();
      ExpectSound(pair, contacts);
      if (HasFailure()) return;
      EXPECT_LE(Deepest(contacts).depth, 0);
      ExpectSound(pair, pair.Step());
    }
  }
  ExpectCounts(0, 0);
}

// The second of two coincident steps keeps the normal of the first, so that the solver does not work against itself.
TEST_F(Fallback, CoincidentCentres_KeepTheLastNormal) {
  btSphereShape sphere(btScalar(0.5));
  PairQuery pair(dispatching_.dispatcher(), sphere, sphere);
  const Vector direction = Vector(0.3, -0.5, 0.8).normalized();
  pair.SetPoses(MakeTransform(Eigen::Matrix3d::Identity(), 0.1 * direction), btTransform::getIdentity());
  EXPECT_LE((pair.Step()[0].normal_b_to_a - direction).norm(), 1e-5);
  pair.SetPoses(btTransform::getIdentity(), btTransform::getIdentity());
  const std::vector<Contact> contacts = pair.Step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_LE((contacts[0].normal_b_to_a - direction).norm(), 1e-5);
  EXPECT_NEAR(contacts[0].depth, -1, kLength);
}

// Sizes and places at the ends of what an app may have.
TEST_F(Fallback, ExtremeSizes_NeedNoFallback) {
  for (const double size : {1e-3, 1e-2, 1e2, 1e4}) {
    for (const ZooShape& a : MakeShapeZoo(size)) {
      btBoxShape box(Vec(size / 2, size / 2, size / 2));
      box.setMargin(btScalar(0.02 * size));
      PairQuery pair(dispatching_.dispatcher(), *a.shape, box);
      pair.SetPoses(At(0.3 * size, 0.1 * size, 0.5 * size), btTransform::getIdentity());
      const std::vector<Contact> contacts = pair.Step();
      SCOPED_TRACE(a.name + " of size " + std::to_string(size));
      ASSERT_FALSE(contacts.empty());
      ExpectFinite(pair, contacts);
      const Contact& deepest = Deepest(contacts);
      EXPECT_NEAR(deepest.depth, PlaneSeparation(pair.A(), pair.B(), deepest.normal_b_to_a), 3e-5 * size);
    }
  }
  ExpectCounts(0, 0);
}

TEST_F(Fallback, SmallOnHuge_NeedsNoFallback) {
  btBoxShape ground(Vec(1000, 1000, 10));
  for (const ZooShape& a : MakeShapeZoo(0.05)) {
    SCOPED_TRACE(a.name);
    PairQuery pair(dispatching_.dispatcher(), *a.shape, ground);
    btTransform pose = At(300, -450, 0);
    pair.SetPoses(pose, At(0, 0, -10));
    pose.getOrigin().setZ(btScalar(PosedConvex{*a.shape, pose}.SupportValue(-Vector::UnitZ()) - 1e-4));
    pair.SetPoses(pose, At(0, 0, -10));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(Deepest(contacts).depth, -1e-4, 3e-5);
    EXPECT_LE((Deepest(contacts).normal_b_to_a - Vector::UnitZ()).norm(), 1e-3);
  }
  ExpectCounts(0, 0);
}

// A user's margin larger than the box leaves Bullet no core of it; its size is as it was.
TEST_F(Fallback, MarginLargerThanTheBox_LeavesItsSize) {
  btBoxShape plate(Vec(0.5, 0.5, 0.01));
  plate.setMargin(btScalar(0.04));
  btBoxShape floor(Vec(5, 5, 1));
  PairQuery pair(dispatching_.dispatcher(), plate, floor);
  pair.SetPoses(At(0, 0, 0.02), At(0, 0, -1));
  const std::vector<Contact> contacts = pair.Step();
  ASSERT_FALSE(contacts.empty());
  ExpectFinite(pair, contacts);
  EXPECT_NEAR(contacts[0].normal_b_to_a.z(), 1, 1e-5);
  EXPECT_NEAR(Deepest(contacts).depth, 0.01, kLength);
}

}  // namespace
}  // namespace dgd_test
