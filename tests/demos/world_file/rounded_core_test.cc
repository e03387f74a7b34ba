// Contract: the core and its ball have the support function of Bullet's shape, whatever its axis and scaling; and what
// has no such core has none.
#include "simulation/rounded_core.h"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scene/random.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

double Support(const RoundedPolyhedron& shape, const Eigen::Vector3d& direction) {
  double support = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& vertex : shape.core.vertices) support = std::max(support, direction.dot(vertex));
  return support + shape.radius;
}

/// @param tolerance  m; circles are polygons of 64 sides, and boxes are rounder in Bullet by up to their margin.
void ExpectSameSupport(const btConvexShape& shape, double tolerance) {
  const auto core = RoundedCoreOf(shape);
  ASSERT_TRUE(core) << shape.getName();
  Random random(1, 0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d direction = random.UnitVector();
    const btVector3 d = ToBullet(direction);
    const double expected = direction.dot(FromBullet(shape.localGetSupportVertexWithoutMarginNonVirtual(d))) +
                            double(shape.getMarginNonVirtual());
    EXPECT_NEAR(Support(*core, direction), expected, tolerance) << shape.getName();
  }
}

TEST(RoundedCoreTest, Primitives) {
  const btScalar r = btScalar(0.4), h = btScalar(0.6);
  const double of_circle = 0.4 * 0.0012 + 1e-6;
  ExpectSameSupport(btSphereShape(r), 1e-6);
  ExpectSameSupport(btCapsuleShapeX(r, h), 1e-6);
  ExpectSameSupport(btCapsuleShape(r, h), 1e-6);
  ExpectSameSupport(btCapsuleShapeZ(r, h), 1e-6);
  ExpectSameSupport(btCylinderShapeX(btVector3(h, r, r)), of_circle);
  ExpectSameSupport(btCylinderShape(btVector3(r, h, r)), of_circle);
  ExpectSameSupport(btCylinderShapeZ(btVector3(r, r, h)), of_circle);
  ExpectSameSupport(btConeShapeX(r, h), of_circle);
  ExpectSameSupport(btConeShape(r, h), of_circle);
  ExpectSameSupport(btConeShapeZ(r, h), of_circle);
  ExpectSameSupport(btBoxShape(btVector3(r, h, r)), 0.04 * 0.74);
}

TEST(RoundedCoreTest, ScaledHullsAndMultiSpheres) {
  Random random(2, 0);
  btConvexHullShape hull;
  for (int i = 0; i < 30; ++i) hull.addPoint(ToBullet(random.UnitVector()));
  hull.setLocalScaling(btVector3(1, btScalar(0.5), 2));
  hull.setMargin(btScalar(0.1));
  ExpectSameSupport(hull, 1e-5);

  const std::vector<btVector3> centres = {btVector3(-1, 0, 0), btVector3(1, 0, 0)};
  const std::vector<btScalar> equal = {btScalar(0.5), btScalar(0.5)}, unequal = {btScalar(0.5), btScalar(0.4)};
  const auto two = RoundedCoreOf(btMultiSphereShape(centres.data(), equal.data(), 2));
  ASSERT_TRUE(two);
  EXPECT_EQ(two->core.vertices[0], Eigen::Vector3d(-1, 0, 0));
  EXPECT_EQ(two->radius, 0.5);
  EXPECT_FALSE(RoundedCoreOf(btMultiSphereShape(centres.data(), unequal.data(), 2)));
}

TEST(RoundedCoreTest, WhatHasNone) {
  btConvexHullShape flat;
  for (const int x : {0, 1}) {
    for (const int y : {0, 1}) flat.addPoint(btVector3(btScalar(x), btScalar(y), 0));
  }
  EXPECT_FALSE(RoundedCoreOf(flat));
  // A file may have any size, as this that the fuzzer found: a disc, to Qhull.
  btCylinderShapeZ disc(btVector3(1, 1, 1));
  disc.setImplicitShapeDimensions(btVector3(btScalar(1e14), btScalar(1e14), btScalar(0.3)));
  EXPECT_FALSE(RoundedCoreOf(disc));
  btBoxShape sheet(btVector3(1, 1, 1));
  sheet.setImplicitShapeDimensions(btVector3(1, 1, -sheet.getMargin()));
  EXPECT_FALSE(RoundedCoreOf(sheet));
  EXPECT_FALSE(RoundedCoreOf(btTriangleShape(btVector3(0, 0, 0), btVector3(1, 0, 0), btVector3(0, 1, 0))));
}

TEST(RoundedCoreTest, PlanesAndCompounds) {
  const OracleBody plane = OracleBodyOf(btStaticPlaneShape(btVector3(0, 0, 2), 3));
  ASSERT_TRUE(plane.half_space);
  EXPECT_EQ(plane.half_space->normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(plane.half_space->offset, 3);

  btSphereShape ball(1);
  btTriangleShape triangle(btVector3(0, 0, 0), btVector3(1, 0, 0), btVector3(0, 1, 0));
  btCompoundShape inner, outer;
  const btTransform aside(btQuaternion::getIdentity(), btVector3(2, 0, 0));
  inner.addChildShape(aside, &ball);
  outer.addChildShape(aside, &inner);
  const OracleBody body = OracleBodyOf(outer);
  ASSERT_EQ(body.parts.size(), 1u);
  EXPECT_EQ(body.parts[0].pose.position, Eigen::Vector3d(4, 0, 0));
  outer.addChildShape(aside, &triangle);
  EXPECT_FALSE(OracleBodyOf(outer).IsJudged());
}

}  // namespace
}  // namespace dgd_demos
