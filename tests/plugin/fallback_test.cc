// Hard input: pairs without a growth distance go to Bullet's own algorithm, and are counted; what is no shape or no
// pose must not crash nor write NaN; flat, tiny, coincident and changed shapes need no fallback at all.
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <new>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr double kLength = 1e-5;
constexpr double kPi = 3.141592653589793;
const btScalar kNaN = std::numeric_limits<btScalar>::quiet_NaN();
const btScalar kInfinity = std::numeric_limits<btScalar>::infinity();

btTransform At(double x, double y, double z) { return MakeTransform(Eigen::Matrix3d::Identity(), {x, y, z}); }

class Fallback : public testing::Test {
 protected:
  void ExpectCounts(std::uint64_t no_interior, std::uint64_t invalid) const {
    const dgd_bullet::Statistics statistics = dispatching_.statistics();
    EXPECT_EQ(statistics.fallbacks_no_interior, no_interior);
    EXPECT_EQ(statistics.fallbacks_invalid, invalid);
    EXPECT_EQ(statistics.fallbacks_not_converged, 0U);
    EXPECT_EQ(statistics.Fallbacks(), no_interior + invalid);
  }

  /// Nothing that left the algorithm or stayed in its manifold is NaN or infinite.
  static void ExpectFinite(PairQuery& pair, const std::vector<Contact>& contacts) {
    for (const Contact& contact : contacts) {
      EXPECT_TRUE(contact.normal_b_to_a.allFinite());
      EXPECT_TRUE(contact.on_b.allFinite());
      EXPECT_TRUE(std::isfinite(contact.depth));
    }
    if (pair.manifold() == nullptr) return;
    for (int i = 0; i < pair.manifold()->getNumContacts(); ++i) {
      const btManifoldPoint& point = pair.manifold()->getContactPoint(i);
      EXPECT_TRUE(std::isfinite(point.getDistance()));
      EXPECT_TRUE(ToEigen(point.m_normalWorldOnB).allFinite());
      EXPECT_TRUE(ToEigen(point.m_localPointA).allFinite());
      EXPECT_TRUE(ToEigen(point.m_localPointB).allFinite());
    }
  }

  /// The deepest contact of a step against the supporting planes along its own normal.
  static void ExpectSound(PairQuery& pair, const std::vector<Contact>& contacts) {
    ASSERT_FALSE(contacts.empty());
    ExpectFinite(pair, contacts);
    const Contact& deepest = Deepest(contacts);
    EXPECT_NEAR(deepest.normal_b_to_a.norm(), 1, 1e-6);
    EXPECT_NEAR(deepest.depth, PlaneSeparation(pair.A(), pair.B(), deepest.normal_b_to_a), 2e-5 + kLength);
  }

  Dispatching dispatching_{Route::kConfiguration};
  Dispatching builtin_{Route::kBuiltin};
};

// Two flat shapes without margins have no interior together: no scale at which they "just" touch (paper, Rem. 1).
TEST_F(Fallback, TwoFlatTriangles_AnswerAsBulletDoesAndAreCounted) {
  btTriangleShape triangle(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  triangle.setMargin(0);
  PairQuery ours(dispatching_.dispatcher(), triangle, triangle), bullets(builtin_.dispatcher(), triangle, triangle);
  std::uint64_t steps = 0;
  for (const double height : {-0.3, -0.01, 0.0, 0.005}) {
    const btTransform crossing =
        MakeTransform(Eigen::AngleAxisd(kPi / 2, Vector::UnitX()).toRotationMatrix(), {0.1, 0.2, 0.5 + height});
    for (PairQuery* pair : {&ours, &bullets}) pair->SetPoses(crossing, btTransform::getIdentity());
    const std::vector<Contact> contacts = ours.Step(), expected = bullets.Step();
    ++steps;
    ASSERT_EQ(contacts.size(), expected.size()) << height;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_EQ(contacts[i].on_b, expected[i].on_b);
      EXPECT_EQ(contacts[i].normal_b_to_a, expected[i].normal_b_to_a);
      EXPECT_EQ(contacts[i].depth, expected[i].depth);
    }
    EXPECT_EQ(ours.manifold()->getNumContacts(), bullets.manifold()->getNumContacts());
  }
  ExpectCounts(steps, 0);
  EXPECT_EQ(dispatching_.dispatcher().getNumManifolds(), 1) << "the fallback must use the pair's own manifold";
}

TEST_F(Fallback, TwoFlatTriangles_FallBackInClosestPointQueriesToo) {
  btTriangleShape triangle(Vec(-1, -1, 0), Vec(1, -1, 0), Vec(0, 1, 0));
  triangle.setMargin(0);
  PairQuery ours(dispatching_.dispatcher(), triangle, triangle), bullets(builtin_.dispatcher(), triangle, triangle);
  for (PairQuery* pair : {&ours, &bullets}) pair->SetPoses(At(0, 0, 0.4), btTransform::getIdentity());
  const std::vector<Contact> contacts = ours.ClosestPoints(1), expected = bullets.ClosestPoints(1);
  ASSERT_EQ(contacts.size(), expected.size());
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts[0].depth, 0.4, kLength);
  EXPECT_EQ(contacts[0].depth, expected[0].depth);
  ExpectCounts(0 + 1, 0);
  EXPECT_EQ(dispatching_.dispatcher().getNumManifolds(), 0);
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

/// A pose or shape that is none, made by `spoil` from a pair of touching hulls, and undone by `heal`.
void ExpectNothingBad(PairQuery& pair, const std::function<void()>& spoil, const std::function<void()>& heal) {
  for (int round = 0; round < 2; ++round) {
    spoil();
    for (int step = 0; step < 2; ++step) {
      const std::vector<Contact> contacts = pair.Step();
      for (const Contact& contact : contacts) {
        EXPECT_TRUE(contact.normal_b_to_a.allFinite() && contact.on_b.allFinite() && std::isfinite(contact.depth));
      }
      for (int i = 0; i < pair.manifold()->getNumContacts(); ++i) {
        EXPECT_TRUE(std::isfinite(pair.manifold()->getContactPoint(i).getDistance()));
      }
    }
    heal();
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(Deepest(contacts).depth, -0.01, kLength);
  }
}

class InvalidPose : public Fallback {};

// NaN is counted; a body at infinity may as well be called far away.
TEST_F(InvalidPose, NaNOrInfinity_WritesNothingBadAndNaNIsCounted) {
  const auto prism = MakePrism(5, 0.4, 0.3);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  btSphereShape sphere(btScalar(0.3));
  btCylinderShape cylinder(Vec(0.3, 0.3, 0.3));
  btConvexShape* const shapes[] = {prism.get(), &box, &sphere, &cylinder};
  std::uint64_t steps_with_nan = 0;
  for (btConvexShape* shape : shapes) {
    PairQuery pair(dispatching_.dispatcher(), *shape, box);
    const double height = shape == &box ? 0.5 : 0.3 + (shape == prism.get() ? double(prism->getMargin()) : 0);
    const btTransform good = At(0.02, 0.01, 0.5 + height - 0.01);
    pair.SetPoses(good, btTransform::getIdentity());
    pair.Step();
    for (const btScalar bad : {kNaN, kInfinity, -kInfinity}) {
      for (const bool in_rotation : {false, true}) {
        for (const bool of_a : {false, true}) {
          SCOPED_TRACE(std::string(shape->getName()) + " " + std::to_string(bad) +
                       (in_rotation ? " rotation" : " origin") + (of_a ? " of A" : " of B"));
          btTransform broken = of_a ? good : btTransform::getIdentity();
          if (in_rotation) {
            broken.getBasis()[1].setX(bad);
          } else {
            broken.getOrigin().setZ(bad);
          }
          ExpectNothingBad(
              pair, [&] { of_a ? pair.SetPoses(broken, btTransform::getIdentity()) : pair.SetPoses(good, broken); },
              [&] { pair.SetPoses(good, btTransform::getIdentity()); });
          if (std::isnan(bad)) steps_with_nan += 4;
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GE(dispatching_.statistics().fallbacks_invalid, steps_with_nan);
  EXPECT_EQ(dispatching_.statistics().Fallbacks(), dispatching_.statistics().fallbacks_invalid);
}

class InvalidShape : public Fallback {
 protected:
  void ExpectHandled(btConvexShape& bad) {
    btBoxShape box(Vec(0.5, 0.5, 0.5));
    for (const bool swapped : {false, true}) {
      PairQuery pair(dispatching_.dispatcher(), swapped ? box : bad, swapped ? static_cast<btConvexShape&>(bad) : box);
      pair.SetPoses(At(0.02, 0.01, 0.3), btTransform::getIdentity());
      for (int step = 0; step < 2; ++step) ExpectFinite(pair, pair.Step());
      ExpectFinite(pair, pair.ClosestPoints(0.1));
    }
    ExpectCounts(0, 6);
  }
};

TEST_F(InvalidShape, HullWithoutPoints) {
  btConvexHullShape hull;
  ExpectHandled(hull);
}

TEST_F(InvalidShape, HullWithANaNPoint) {
  const auto hull = MakePrism(5, 0.4, 0.3);
  hull->addPoint(btVector3(0, kNaN, 0), false);
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, LargeHullWithANaNPoint) {
  const auto hull = MakePrism(100, 0.4, 0.3);
  hull->getUnscaledPoints()[77].setY(kNaN);
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, BoxOfNaNSize) {
  btBoxShape box(btVector3(kNaN, 1, 1));
  ExpectHandled(box);
}

TEST_F(InvalidShape, NaNMargin) {
  const auto hull = MakePrism(5, 0.4, 0.3);
  hull->setMargin(kNaN);
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, NegativeMargin) {
  const auto hull = MakePrism(5, 0.4, 0.3);
  hull->setMargin(btScalar(-0.02));
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, SphereOfNaNRadius) {
  btSphereShape sphere(kNaN);
  ExpectHandled(sphere);
}

TEST_F(InvalidShape, TriangleWithANaNCorner) {
  btTriangleShape triangle(Vec(0, 0, 0), btVector3(1, kNaN, 0), Vec(0, 1, 0));
  ExpectHandled(triangle);
}

TEST_F(InvalidShape, PointCloudWithoutPoints) {
  btConvexPointCloudShape cloud;
  ExpectHandled(cloud);
}

/// A user's shape whose support function is broken.
class BrokenSupport : public Ellipsoid {
 public:
  BrokenSupport() : Ellipsoid(Vec(0.5, 0.5, 0.5)) {}
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3&) const override { return {kNaN, kNaN, kNaN}; }
};

TEST_F(InvalidShape, CustomShapeOfNaN) {
  BrokenSupport broken;
  ExpectHandled(broken);
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

class ChangedShape : public Fallback {
 protected:
  /// Steps the pair before and after `change`; the second answer must be that of the changed shape.
  void ExpectFollows(btConvexShape& shape, const std::function<void()>& change) {
    btBoxShape floor(Vec(5, 5, 1));
    PairQuery pair(dispatching_.dispatcher(), shape, floor), cold(dispatching_.dispatcher(), shape, floor);
    for (int round = 0; round < 2; ++round) {
      btTransform pose = btTransform::getIdentity();
      pose.getOrigin().setZ(btScalar(PosedConvex{shape, pose}.SupportValue(-Vector::UnitZ()) - 0.001));
      pair.SetPoses(pose, At(0, 0, -1));
      cold.SetPoses(pose, At(0, 0, -1));
      const std::vector<Contact> contacts = pair.Step(), expected = cold.ClosestPoints(0);
      ASSERT_FALSE(contacts.empty());
      EXPECT_NEAR(Deepest(contacts).depth, -0.001, 3e-5) << (round == 0 ? "before" : "after") << " the change, warm";
      EXPECT_NEAR(Deepest(expected).depth, -0.001, 3e-5) << (round == 0 ? "before" : "after") << " the change, cold";
      change();
    }
    ExpectCounts(0, 0);
  }
};

TEST_F(ChangedShape, HullGainsAPoint) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] { hull->addPoint(Vec(0.1, 0.05, -0.6)); });
}

TEST_F(ChangedShape, HullIsScaled) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] { hull->setLocalScaling(Vec(1, 1, -1.7)); });
}

TEST_F(ChangedShape, HullsMarginChanges) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] { hull->setMargin(btScalar(0.1)); });
}

TEST_F(ChangedShape, HullsPointMovesInPlace) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] {
    hull->getUnscaledPoints()[4].setZ(btScalar(-0.5));
    hull->recalcLocalAabb();
  });
}

// Every single point of a large hull counts, not only a sample of them.
TEST_F(ChangedShape, LargeHullsPointMovesInPlace) {
  for (const int point : {0, 1, 7, 100, 199}) {
    SCOPED_TRACE(point);
    const auto hull = MakePrism(100, 0.4, 0.3);
    ExpectFollows(*hull, [&] {
      hull->getUnscaledPoints()[point].setZ(btScalar(-0.5));
      hull->recalcLocalAabb();
    });
    if (HasFailure()) break;
  }
}

TEST_F(ChangedShape, PointCloudGetsOtherPoints) {
  std::array<btVector3, 6> first = {Vec(0.3, 0, 0),  Vec(-0.3, 0, 0), Vec(0, 0.3, 0),
                                    Vec(0, -0.3, 0), Vec(0, 0, 0.3),  Vec(0, 0, -0.3)};
  std::array<btVector3, 6> second = first;
  second[5] = Vec(0.1, 0, -0.7);
  btConvexPointCloudShape cloud(first.data(), 6, Vec(1, 1, 1));
  ExpectFollows(cloud, [&] { cloud.setPoints(second.data(), 6, true, Vec(1, 0.8, 1)); });
}

TEST_F(ChangedShape, TriangleMeshIsDeformed) {
  std::array<btVector3, 4> vertices = {Vec(0.4, 0, 0), Vec(-0.3, 0.4, 0), Vec(-0.3, -0.4, 0), Vec(0, 0, -0.4)};
  std::array<int, 12> indices = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  btTriangleIndexVertexArray mesh(4, indices.data(), 3 * sizeof(int), 4, &vertices[0][0], sizeof(btVector3));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { vertices[3] = Vec(0.05, 0.02, -0.8); });
}

TEST_F(ChangedShape, LargeTriangleMeshIsDeformed) {
  std::vector<btVector3> vertices;
  std::vector<int> indices;
  for (int i = 0; i < 300; ++i) {
    vertices.push_back(Vec(0.4 * std::cos(i * 0.7), 0.4 * std::sin(i * 0.7), 0.001 * i - 0.15));
    indices.push_back(i);
  }
  btTriangleIndexVertexArray mesh(100, indices.data(), 3 * sizeof(int), 300, &vertices[0][0], sizeof(btVector3));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { vertices[155] = Vec(0, 0, -0.8); });
}

// A vertex buffer with the positions at its end: what lies behind the last position is not ours to read. (For the
// address sanitizer.)
TEST_F(ChangedShape, InterleavedTriangleMesh_IsReadWithinItsBounds) {
  constexpr int kStride = 8;  // Scalars: normal, texture, position.
  std::vector<btScalar> buffer(4 * kStride, 0);
  const std::array<btVector3, 4> corners = {Vec(0.4, 0, 0), Vec(-0.3, 0.4, 0), Vec(-0.3, -0.4, 0), Vec(0, 0, -0.4)};
  for (std::size_t i = 0; i < 4; ++i) {
    for (int axis = 0; axis < 3; ++axis) buffer[i * kStride + 5 + static_cast<std::size_t>(axis)] = corners[i][axis];
  }
  std::array<int, 12> indices = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  btTriangleIndexVertexArray mesh(4, indices.data(), 3 * sizeof(int), 4, &buffer[5], kStride * sizeof(btScalar));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { buffer[3 * kStride + 7] = btScalar(-0.8); });
}

TEST_F(ChangedShape, TriangleMeshIsScaled) {
  std::array<btVector3, 4> vertices = {Vec(0.4, 0, 0), Vec(-0.3, 0.4, 0), Vec(-0.3, -0.4, 0), Vec(0, 0, -0.4)};
  std::array<int, 12> indices = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  btTriangleIndexVertexArray mesh(4, indices.data(), 3 * sizeof(int), 4, &vertices[0][0], sizeof(btVector3));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { shape.setLocalScaling(Vec(1, 1, 2)); });
}

TEST_F(ChangedShape, BoxSphereCapsuleAndMultiSphereAreScaled) {
  btBoxShape box(Vec(0.4, 0.3, 0.2));
  btSphereShape sphere(btScalar(0.3));
  btCapsuleShapeZ capsule(btScalar(0.2), btScalar(0.5));
  const btVector3 positions[2] = {Vec(0, 0, 0.2), Vec(0, 0, -0.1)};
  const btScalar radii[2] = {btScalar(0.2), btScalar(0.3)};
  btMultiSphereShape spheres(positions, radii, 2);
  for (btConvexShape* shape : {static_cast<btConvexShape*>(&box), static_cast<btConvexShape*>(&sphere),
                               static_cast<btConvexShape*>(&capsule), static_cast<btConvexShape*>(&spheres)}) {
    SCOPED_TRACE(shape->getName());
    ExpectFollows(*shape, [&] { shape->setLocalScaling(Vec(1.5, 1.5, 1.5)); });
  }
}

// Bullet tells nobody when a shape dies, and a new one may take its address with as many points.
TEST_F(ChangedShape, AnotherHullAtTheSameAddress) {
  struct Slot {
    alignas(btConvexHullShape) std::array<unsigned char, sizeof(btConvexHullShape)> bytes{};
  };
  for (const int sides : {4, 100}) {
    SCOPED_TRACE(sides);
    const auto slot = std::make_unique<Slot>();
    const auto construct = [&](double half_height) {
      const auto source = MakePrism(sides, 0.4, half_height);
      return ::new (static_cast<void*>(slot->bytes.data()))
          btConvexHullShape(&source->getUnscaledPoints()[0][0], source->getNumPoints(), sizeof(btVector3));
    };
    btConvexHullShape* hull = construct(0.3);
    ExpectFollows(*hull, [&] {
      hull->~btConvexHullShape();
      hull = construct(0.7);
    });
    hull->~btConvexHullShape();
  }
}

// The body gets a shape of another type while its pair lives.
TEST_F(ChangedShape, BodyGetsAShapeOfAnotherType) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(1);
  btBoxShape floor(Vec(5, 5, 1));
  PairQuery pair(dispatching_.dispatcher(), *zoo[0].shape, floor);
  Random random(TestSeed());
  for (int step = 0; step < 200; ++step) {
    const ZooShape& next = zoo[static_cast<std::size_t>(random.Below(static_cast<int>(zoo.size())))];
    SCOPED_TRACE("step " + std::to_string(step) + ", " + next.name);
    pair.body_a().setCollisionShape(next.shape.get());
    btTransform pose = MakeTransform(random.Rotation(), Vector::Zero());
    pose.getOrigin().setZ(btScalar(PosedConvex{*next.shape, pose}.SupportValue(-Vector::UnitZ()) - 0.001));
    pair.SetPoses(pose, At(0, 0, -1));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(Deepest(contacts).depth, -0.001, 3e-5);
  }
  ExpectCounts(0, 0);
}

// A user's margin larger than the box leaves no core; the box must not turn inside out.
TEST_F(Fallback, MarginLargerThanTheBox_StaysFiniteAndFarFromHarmless) {
  btBoxShape plate(Vec(0.5, 0.5, 0.01));
  plate.setMargin(btScalar(0.04));
  btBoxShape floor(Vec(5, 5, 1));
  PairQuery pair(dispatching_.dispatcher(), plate, floor);
  pair.SetPoses(At(0, 0, 0.02), At(0, 0, -1));
  const std::vector<Contact> contacts = pair.Step();
  ASSERT_FALSE(contacts.empty());
  ExpectFinite(pair, contacts);
  EXPECT_NEAR(contacts[0].normal_b_to_a.z(), 1, 1e-5);
  EXPECT_LE(std::abs(Deepest(contacts).depth), 0.05);
}

}  // namespace
}  // namespace dgd_test
