// What is in the manifold: the whole patch in one step, the same points from step to step, and none that the geometry
// no longer has.
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

btTransform Turned(const Vector& axis, double angle, const Vector& position) {
  return MakeTransform(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), position);
}

/// Sides of the smallest axis-parallel rectangle in x and y around the points.
Eigen::Vector2d Span(const std::vector<Contact>& contacts) {
  Eigen::AlignedBox2d bounds;
  for (const Contact& contact : contacts) bounds.extend(contact.on_b.head<2>());
  return bounds.isEmpty() ? Eigen::Vector2d::Zero() : Eigen::Vector2d(bounds.sizes());
}

class ManifoldContent : public testing::Test {
 protected:
  /// A on top of B, where they overlap by 1 mm; all points must say so.
  std::vector<Contact> Lay(btConvexShape& shape, const btTransform& pose) {
    PairQuery pair(dispatching_.dispatcher(), shape, floor_);
    pair.SetPoses(pose, At(0, 0, -1));
    std::vector<Contact> contacts = pair.Step();
    EXPECT_EQ(pair.manifold()->getNumContacts(), static_cast<int>(contacts.size())) << "points too near to each other";
    for (const Contact& contact : contacts) {
      EXPECT_NEAR(contact.depth, -0.001, kLength);
      EXPECT_NEAR((contact.normal_b_to_a - Vector::UnitZ()).norm(), 0, 1e-5);
      EXPECT_NEAR(contact.on_b.z(), 0, kLength);
    }
    return contacts;
  }

  Dispatching dispatching_{Route::kConfiguration};
  btBoxShape floor_{Vec(5, 5, 1)};
  btBoxShape box_{Vec(0.5, 0.3, 0.2)};
};

TEST_F(ManifoldContent, BoxOnFloor_FourPointsSpanTheFace) {
  const std::vector<Contact> contacts = Lay(box_, At(0.3, 0.2, 0.199));
  EXPECT_EQ(contacts.size(), 4U);
  EXPECT_NEAR(Span(contacts).x(), 1, kLength);
  EXPECT_NEAR(Span(contacts).y(), 0.6, kLength);
}

TEST_F(ManifoldContent, BoxOnBox_FourPointsSpanTheCommonPart) {
  PairQuery pair(dispatching_.dispatcher(), box_, box_);
  pair.SetPoses(At(0.3, 0.1, 0.399), At(0, 0, 0));
  const std::vector<Contact> contacts = pair.Step();
  EXPECT_EQ(contacts.size(), 4U);
  EXPECT_NEAR(Span(contacts).x(), 0.7, kLength);
  EXPECT_NEAR(Span(contacts).y(), 0.5, kLength);
}

/// Distance of a point to the nearest of a box's corners, which are sharp.
double ToCorner(const btBoxShape& box, const btTransform& pose, const Vector& point) {
  const Vector half = ToEigen(box.getHalfExtentsWithMargin()), local = ToEigen(pose.inverse() * ToBullet(point));
  return (local.cwiseAbs() - half).norm();
}

// On their faces, edges and corners, on a box that is larger.
TEST_F(ManifoldContent, BoxOnBox_PointsAreWithinAHundredthOfTheHalfExtentOfTheTrueCorners) {
  const Vector axes[] = {Vector::UnitZ(), Vector::UnitX(), {1, -1, 0}, {1, 2, 0.5}};
  for (const btVector3& half_extents : {Vec(0.5, 0.5, 0.5), Vec(0.5, 0.3, 0.2), Vec(0.03, 0.02, 0.02)}) {
    btBoxShape box(half_extents);
    const double half = ToEigen(half_extents).minCoeff();
    for (const Vector& axis : axes) {
      for (const double angle : {0.0, 1e-3, 0.1, 0.6, std::numbers::pi / 4, 0.9553, 1.5, std::numbers::pi / 2}) {
        SCOPED_TRACE(std::to_string(half) + " m, " + std::to_string(angle) + " rad");
        btTransform pose = Turned(axis, angle, {0.2, 0.1, 0});
        pose.getOrigin().setZ(btScalar(PosedConvex{box, pose}.SupportValue(-Vector::UnitZ()) - 0.01 * half));
        PairQuery pair(dispatching_.dispatcher(), box, floor_);
        pair.SetPoses(pose, At(0, 0, -1));
        const std::vector<Contact> contacts = pair.Step();
        ASSERT_FALSE(contacts.empty());
        for (const Contact& contact : contacts) EXPECT_LE(ToCorner(box, pose, contact.OnA()), 0.01 * half);
      }
    }
  }
}

TEST_F(ManifoldContent, BoxCrossingBox_FourPointsSpanTheCrossing) {
  btBoxShape plank(Vec(2, 0.2, 0.1));
  PairQuery pair(dispatching_.dispatcher(), plank, plank);
  pair.SetPoses(Turned(Vector::UnitZ(), std::numbers::pi / 2, {0, 0, 0.199}), At(0, 0, 0));
  const std::vector<Contact> contacts = pair.Step();
  EXPECT_EQ(contacts.size(), 4U);
  EXPECT_NEAR(Span(contacts).x(), 0.4, kLength);
  EXPECT_NEAR(Span(contacts).y(), 0.4, kLength);
}

// Two corners opposite to each other, and one on either side: whichever these are, their area is the same.
TEST_F(ManifoldContent, PrismOnFloor_FourPointsSpanTwoThirdsOfTheHexagon) {
  const auto prism = MakePrism(6, 0.5, 0.2);
  const std::vector<Contact> contacts = Lay(*prism, At(0, 0, 0.2 + double(prism->getMargin()) - 0.001));
  ASSERT_EQ(contacts.size(), 4U);
  const auto twice_area = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return (contacts[b].on_b - contacts[a].on_b).cross(contacts[d].on_b - contacts[c].on_b).norm();
  };
  const double area = std::max({twice_area(0, 1, 2, 3), twice_area(0, 2, 1, 3), twice_area(0, 3, 1, 2)}) / 2;
  EXPECT_NEAR(area, std::sqrt(0.75) / 2, 0.07);
}

TEST_F(ManifoldContent, CapsuleLyingOnFloor_TwoPointsAtItsEnds) {
  btCapsuleShapeX capsule(btScalar(0.2), btScalar(1));
  const std::vector<Contact> contacts = Lay(capsule, At(0, 0, 0.199));
  EXPECT_EQ(contacts.size(), 2U);
  EXPECT_NEAR(Span(contacts).x(), 1, kLength);
  EXPECT_NEAR(Span(contacts).y(), 0, kLength);
}

TEST_F(ManifoldContent, CylinderUprightOnFloor_PointsSpanTheCap) {
  btCylinderShapeZ cylinder(Vec(0.4, 0.4, 0.3));
  const std::vector<Contact> contacts = Lay(cylinder, At(0, 0, 0.299));
  EXPECT_GE(contacts.size(), 3U);
  const double radius = 0.4 - double(cylinder.getMargin());
  EXPECT_GE(Span(contacts).minCoeff(), 1.4 * radius);
  for (const Contact& contact : contacts) EXPECT_NEAR(contact.on_b.head<2>().norm(), radius, kLength);
}

TEST_F(ManifoldContent, CylinderLyingOnFloor_TwoPointsAlongItsSide) {
  btCylinderShapeX cylinder(Vec(0.5, 0.3, 0.3));
  const std::vector<Contact> contacts = Lay(cylinder, At(0, 0, 0.299));
  EXPECT_EQ(contacts.size(), 2U);
  EXPECT_NEAR(Span(contacts).x(), 1 - 2 * double(cylinder.getMargin()), kLength);
}

TEST_F(ManifoldContent, ConeUprightOnFloor_PointsSpanTheBase) {
  btConeShapeZ cone(btScalar(0.4), btScalar(0.6));
  const std::vector<Contact> contacts = Lay(cone, At(0, 0, 0.3 + double(cone.getMargin()) - 0.001));
  EXPECT_GE(contacts.size(), 3U);
  EXPECT_GE(Span(contacts).minCoeff(), 1.4 * 0.4);
}

TEST_F(ManifoldContent, SphereOnFloor_OnePoint) {
  btSphereShape sphere(btScalar(0.5));
  EXPECT_EQ(Lay(sphere, At(1, 2, 0.499)).size(), 1U);
}

TEST_F(ManifoldContent, BoxOnItsEdge_TwoPointsAlongIt) {
  btBoxShape cube(Vec(0.5, 0.5, 0.5));
  const double height = std::sqrt(0.5);
  const std::vector<Contact> contacts =
      Lay(cube, Turned(Vector::UnitX(), std::numbers::pi / 4, {0, 0, height - 0.001}));
  EXPECT_EQ(contacts.size(), 2U);
  EXPECT_NEAR(Span(contacts).x(), 1, kLength);
}

TEST_F(ManifoldContent, TriangleOnFloor_ThreePoints) {
  btTriangleShape triangle(Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0));
  EXPECT_EQ(Lay(triangle, At(0, 0, double(triangle.getMargin()) - 0.001)).size(), 3U);
}

// Two capsules that cross at a small angle touch where they cross. Near their ends they are centimetres apart, and no
// point may claim that they overlap there.
TEST_F(ManifoldContent, CapsulesCrossingAtASmallAngle_NoOverlapWhereThereIsNone) {
  btCapsuleShapeX capsule(btScalar(0.02), btScalar(2));
  for (const double degrees : {0.5, 1.0, 2.0, 2.8, 5.0, 30.0}) {
    PairQuery pair(dispatching_.dispatcher(), capsule, capsule);
    pair.SetPoses(Turned(Vector::UnitZ(), degrees * std::numbers::pi / 180, {0, 0, 0.039}), At(0, 0, 0));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(Deepest(contacts).depth, -0.001, kLength);
    for (const Contact& contact : contacts) {
      SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(contact.on_b.x()) + " from the crossing");
      // The exact overlap of the two around that place.
      const double lateral = 2 * std::abs(contact.on_b.x()) * std::tan(degrees / 2 * std::numbers::pi / 180);
      EXPECT_GE(contact.depth, std::hypot(0.039, lateral) - 0.04 - kLength);
      // Half way between two places that are beside each other, not above.
      EXPECT_LE(std::abs(Outside(pair.B(), contact.on_b)), kLength + 1e-4 + 0.2 * std::abs(contact.depth));
    }
  }
}

// A point's impulse is what the next step starts from: it must survive that the body moves a little.
TEST_F(ManifoldContent, PointsPersistWhileTheBodyMovesALittle) {
  PairQuery pair(dispatching_.dispatcher(), box_, floor_);
  pair.SetPoses(At(0, 0, 0.199), At(0, 0, -1));
  pair.Step();
  ASSERT_EQ(pair.manifold()->getNumContacts(), 4);
  std::vector<btScalar> marks;
  for (int i = 0; i < 4; ++i) {
    btManifoldPoint& point = pair.manifold()->getContactPoint(i);
    point.m_appliedImpulse = btScalar(1 + i);
    point.m_appliedImpulseLateral1 = btScalar(10 + i);
  }
  for (int step = 1; step <= 20; ++step) {
    pair.SetPoses(Turned({0.3, -0.2, 1}, 1e-4 * step, {1e-4 * step, -1e-4 * step, 0.199 + 1e-5 * step}), At(0, 0, -1));
    pair.Step();
    ASSERT_EQ(pair.manifold()->getNumContacts(), 4) << "step " << step;
    std::vector<btScalar> impulses;
    for (int i = 0; i < 4; ++i) {
      const btManifoldPoint& point = pair.manifold()->getContactPoint(i);
      impulses.push_back(point.m_appliedImpulse);
      EXPECT_EQ(point.getLifeTime(), step + 1);
      EXPECT_EQ(point.m_appliedImpulseLateral1, point.m_appliedImpulse + 9);
    }
    std::sort(impulses.begin(), impulses.end());
    for (int i = 0; i < 4; ++i) EXPECT_EQ(impulses[static_cast<std::size_t>(i)], btScalar(1 + i));
  }
}

// As in Bullet's own cache: a contact within the breaking threshold of where it was, on the first body, goes on with
// its impulse; one that is farther away is new.
TEST_F(ManifoldContent, PointThatJumpsByMoreThanTheBreakingThreshold_IsNew) {
  for (const double part : {0.9, 1.1, 1.8}) {
    SCOPED_TRACE(part);
    PairQuery pair(dispatching_.dispatcher(), floor_, box_);
    pair.SetPoses(At(0, 0, -1), At(0, 0, 0.199));
    pair.Step();
    pair.Step();
    btPersistentManifold& manifold = *pair.manifold();
    ASSERT_EQ(manifold.getNumContacts(), 4);
    for (int i = 0; i < 4; ++i) manifold.getContactPoint(i).m_appliedImpulse = 7;
    const double threshold = double(manifold.getContactBreakingThreshold());
    pair.SetPoses(At(0, 0, -1), At(part * threshold, 0, 0.199));
    pair.Step();
    ASSERT_EQ(manifold.getNumContacts(), 4);
    for (int i = 0; i < 4; ++i) {
      const btManifoldPoint& point = manifold.getContactPoint(i);
      EXPECT_EQ(point.m_appliedImpulse, part < 1 ? btScalar(7) : btScalar(0));
      EXPECT_EQ(point.getLifeTime(), part < 1 ? 3 : 1);
    }
  }
}

// The order in which Bullet's contact solver goes through them: what carried more first, the nearly equal as they were.
TEST_F(ManifoldContent, Points_GoAroundThePatchFromTheOneThatCarriedMost) {
  PairQuery pair(dispatching_.dispatcher(), box_, floor_);
  for (btCollisionObject* body : {&pair.body_a(), &pair.body_b()}) body->setCollisionFlags(0);  // Not static.
  pair.SetPoses(At(0, 0, 0.199), At(0, 0, -1));
  pair.Step();
  btPersistentManifold& manifold = *pair.manifold();
  ASSERT_EQ(manifold.getNumContacts(), 4);
  for (int i = 0; i < 4; ++i) manifold.getContactPoint(i).m_appliedImpulse = i == 2 ? 3 : 1;
  const btVector3 strongest = manifold.getContactPoint(2).m_localPointA;
  pair.SetPoses(At(1e-4, 0, 0.199), At(0, 0, -1));  // Else they rest as they are.
  pair.Step();
  ASSERT_EQ(manifold.getNumContacts(), 4);
  EXPECT_LE((manifold.getContactPoint(0).m_localPointA - strongest).length(), 1e-4);
  for (int i = 0; i < 4; ++i) {
    const auto place = [&](int j) { return ToEigen(manifold.getContactPoint((i + j) % 4).m_positionWorldOnB); };
    EXPECT_GT((place(1) - place(0)).cross(place(2) - place(1)).z(), 0) << i;
  }
}

TEST_F(ManifoldContent, PointsThatCarriedAboutAsMuch_KeepTheirOrder) {
  PairQuery pair(dispatching_.dispatcher(), box_, floor_);
  for (btCollisionObject* body : {&pair.body_a(), &pair.body_b()}) body->setCollisionFlags(0);  // Not static.
  pair.SetPoses(At(0, 0, 0.199), At(0, 0, -1));
  btPersistentManifold* manifold = nullptr;
  std::array<Vector, 4> places;
  for (int step = 0; step < 3; ++step) {
    pair.Step();
    manifold = pair.manifold();
    ASSERT_EQ(manifold->getNumContacts(), 4);
    for (int i = 0; i < 4; ++i) {
      btManifoldPoint& point = manifold->getContactPoint(i);
      point.m_appliedImpulse = btScalar(1 + 0.4 * ((i + step) % 2));
      Vector& place = places[static_cast<std::size_t>(i)];
      if (step == 2) {
        EXPECT_LE((ToEigen(point.m_localPointA) - place).norm(), kLength);
      }
      place = ToEigen(point.m_localPointA);
    }
  }
}

/// All cached points must be where the bodies are now: on B's surface, along a normal of this step.
void ExpectNothingStale(PairQuery& pair, const std::vector<Contact>& contacts) {
  ASSERT_EQ(pair.manifold()->getNumContacts(), static_cast<int>(contacts.size()));
  for (int i = 0; i < pair.manifold()->getNumContacts(); ++i) {
    const btManifoldPoint& point = pair.manifold()->getContactPoint(i);
    EXPECT_LE((ToEigen(point.m_normalWorldOnB) - contacts[0].normal_b_to_a).norm(), 1e-6);
    double nearest = 1;
    for (const Contact& contact : contacts) {
      nearest = std::min(nearest, (ToEigen(point.getPositionWorldOnB()) - contact.on_b).norm());
    }
    EXPECT_LE(nearest, kLength);
  }
}

// bullet3 issues 1739 and 2646: Bullet keeps points whose normal belongs to an earlier pose.
TEST_F(ManifoldContent, StalePoints_AreDroppedAfterARotation) {
  btBoxShape cube(Vec(0.5, 0.5, 0.5));
  PairQuery pair(dispatching_.dispatcher(), cube, floor_);
  pair.SetPoses(At(0, 0, 0.499), At(0, 0, -1));
  EXPECT_EQ(pair.Step().size(), 4U);
  for (const double degrees : {1.0, 5.0, 20.0, 45.0, 70.0, 89.0, 90.0}) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * std::numbers::pi / 180;
    const double height = 0.5 * (std::cos(angle) + std::sin(angle));
    pair.SetPoses(Turned(Vector::UnitX(), angle, {0, 0, height - 0.001}), At(0, 0, -1));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    ExpectNothingStale(pair, contacts);
  }
}

TEST_F(ManifoldContent, StalePoints_AreDroppedWhenTheBodiesPart) {
  PairQuery pair(dispatching_.dispatcher(), box_, floor_);
  pair.SetPoses(At(0, 0, 0.199), At(0, 0, -1));
  EXPECT_EQ(pair.Step().size(), 4U);
  pair.SetPoses(At(0, 0, 0.3), At(0, 0, -1));
  EXPECT_TRUE(pair.Step().empty());
  EXPECT_EQ(pair.manifold()->getNumContacts(), 0);
}

TEST_F(ManifoldContent, StalePoints_AreDroppedWhenTheBodySlides) {
  PairQuery pair(dispatching_.dispatcher(), box_, box_);
  for (const double x : {0.0, 0.1, 0.25, 0.5, -0.4}) {
    pair.SetPoses(At(x, 0.05, 0.399), At(0, 0, 0));
    const std::vector<Contact> contacts = pair.Step();
    EXPECT_EQ(contacts.size(), 4U);
    ExpectNothingStale(pair, contacts);
  }
}

// A body that jumps to the other side of its partner between two steps.
TEST_F(ManifoldContent, StalePoints_AreDroppedWhenTheNormalTurnsRound) {
  PairQuery pair(dispatching_.dispatcher(), box_, box_);
  for (const double z : {0.399, -0.399, 0.399}) {
    pair.SetPoses(At(0, 0, z), At(0, 0, 0));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_EQ(contacts.size(), 4U);
    EXPECT_NEAR(contacts[0].normal_b_to_a.z(), z > 0 ? 1 : -1, 1e-5);
    ExpectNothingStale(pair, contacts);
  }
}

TEST(ManifoldContentWithoutPatch, OnePointAStep) {
  dgd_bullet::Options options;
  options.contact_patch = false;
  Dispatching dispatching(Route::kConfiguration, options);
  btBoxShape box(Vec(0.5, 0.3, 0.2)), floor(Vec(5, 5, 1));
  PairQuery pair(dispatching.dispatcher(), box, floor);
  for (int step = 1; step <= 8; ++step) {
    // Rocks so that another corner is the deepest each time: Bullet's cache fills up to four.
    pair.SetPoses(Turned({std::cos(step * std::numbers::pi / 2 + 0.4), std::sin(step * std::numbers::pi / 2 + 0.4), 0},
                         0.003, {0, 0, 0.199}),
                  At(0, 0, -1));
    EXPECT_EQ(pair.Step().size(), 1U);
    EXPECT_GE(pair.manifold()->getNumContacts(), std::min(step, 4));
    EXPECT_LE(pair.manifold()->getNumContacts(), 4);
  }
}

// Swapping the bodies flips the normal; depth and points stay, the point on B for that on A.
TEST_F(ManifoldContent, SwappedBodies_SamePatchSeenFromTheOtherSide) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(1);
  for (const ZooShape& a : zoo) {
    for (const ZooShape& b : zoo) {
      SCOPED_TRACE(a.name + " on " + b.name);
      Random random(TestSeed());
      const btTransform pose_a = MakeTransform(random.Rotation(), random.InCube());
      const Eigen::Matrix3d rotation_b = random.Rotation();
      Vector position_b = ToEigen(pose_a.getOrigin()) + 5 * random.UnitVector();
      PairQuery straight(dispatching_.dispatcher(), *a.shape, *b.shape);
      PairQuery swapped(dispatching_.dispatcher(), *b.shape, *a.shape);
      straight.SetPoses(pose_a, MakeTransform(rotation_b, position_b));
      const SignedDistance far = DistanceOfShapes(straight.A(), straight.B());
      position_b += (far.value + 0.001) * far.normal_b_to_a;  // 1 mm of overlap.
      straight.SetPoses(pose_a, MakeTransform(rotation_b, position_b));
      swapped.SetPoses(MakeTransform(rotation_b, position_b), pose_a);
      const std::vector<Contact> contacts = straight.Step(), mirrored = swapped.Step();
      ASSERT_EQ(contacts.size(), mirrored.size());
      // Curved shapes stop within the solver's tolerance, and Bullet's own support functions within their rounding.
      // A height that is off by that part turns the normal by its square root.
      constexpr double kAngle = sizeof(btScalar) == sizeof(double) ? 1e-3 : 3e-3, kPlace = 1e-3, kDepth = 1e-4;
      for (const Contact& contact : contacts) {
        const auto nearest =
            std::min_element(mirrored.begin(), mirrored.end(), [&](const Contact& x, const Contact& y) {
              return (x.on_b - contact.OnA()).norm() < (y.on_b - contact.OnA()).norm();
            });
        EXPECT_LE((nearest->on_b - contact.OnA()).norm(), kPlace);
        EXPECT_LE((nearest->OnA() - contact.on_b).norm(), kPlace);
        EXPECT_LE((nearest->normal_b_to_a + contact.normal_b_to_a).norm(), kAngle);
        EXPECT_NEAR(nearest->depth, contact.depth, kDepth);
      }
      if (HasFailure()) break;
    }
  }
}

// Two stacked copies of a shape share every vertex and edge seen from above: the clipping meets nothing but ties. The
// prisms' vertices are rounded, so that their many short edges are parallel only nearly.
TEST_F(ManifoldContent, AlignedPrisms_FourPointsWithinTheFace) {
  for (const int sides : {3, 4, 5, 8, 12, 16, 17, 24, 40}) {
    SCOPED_TRACE(sides);
    const auto prism = MakePrism(sides, 0.5, 0.2);
    const double gap = 2 * double(prism->getMargin());
    for (const double turn : {0.0, 1e-9, 1e-6, std::numbers::pi / sides}) {
      PairQuery pair(dispatching_.dispatcher(), *prism, *prism);
      pair.SetPoses(Turned(Vector::UnitZ(), turn, {0, 0, 0.4 + gap - 0.001}), At(0, 0, 0));
      const std::vector<Contact> contacts = pair.Step();
      EXPECT_GE(contacts.size(), 3U);
      for (const Contact& contact : contacts) {
        EXPECT_NEAR(contact.depth, -0.001, kLength);
        EXPECT_LE(contact.on_b.head<2>().norm(), 0.5 + kLength);
      }
      // Two opposed triangles have a hexagon of half their size in common.
      EXPECT_GE(Span(contacts).minCoeff(), 0.28);
    }
  }
}

}  // namespace
}  // namespace dgd_test
