// Contract: the surface that is drawn of a Bullet shape is the one that it collides by, in its place, and is seen from
// outside.
#include "report/bullet_surface.h"

#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <btBulletCollisionCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scene/random.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

const PlaneSquare kSquare{Vector3d(3, 4, 5), 50};

double SupportValue(const SurfaceMesh& mesh, const Vector3d& direction) {
  double value = -std::numeric_limits<double>::infinity();
  for (const SurfaceVertex& vertex : mesh) value = std::max(value, vertex.position.cast<double>().dot(direction));
  return value;
}

// By the divergence theorem; negative if the surface is inside out.
double Volume(const SurfaceMesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i + 2 < mesh.size(); i += 3) {
    volume += double(mesh[i].position.dot(mesh[i + 1].position.cross(mesh[i + 2].position))) / 6;
  }
  return volume;
}

void ExpectNormalsToFaceOutwards(const SurfaceMesh& mesh) {
  for (std::size_t i = 0; i + 2 < mesh.size(); i += 3) {
    const Eigen::Vector3f facing =
        (mesh[i + 1].position - mesh[i].position).cross(mesh[i + 2].position - mesh[i].position);
    for (std::size_t k = i; k < i + 3; ++k) {
      ASSERT_NEAR(mesh[k].normal.norm(), 1, 1e-4);
      ASSERT_GE(facing.dot(mesh[k].normal), -1e-6f);
    }
  }
}

void ExpectSurfaceOfConvex(const btConvexShape& shape) {
  const SurfaceMesh mesh = SurfaceOf(shape, kSquare);
  ASSERT_FALSE(mesh.empty());
  EXPECT_GT(Volume(mesh), 0);
  ExpectNormalsToFaceOutwards(mesh);
  btVector3 ignored_centre;
  btScalar radius = 0;
  shape.getBoundingSphere(ignored_centre, radius);
  Random random(1, 0);
  for (int i = 0; i < 300; ++i) {
    const Vector3d direction = random.UnitVector();
    const double support = FromBullet(shape.localGetSupportingVertex(ToBullet(direction))).dot(direction);
    EXPECT_NEAR(SupportValue(mesh, direction), support, 0.01 * double(radius)) << direction.transpose();
  }
}

TEST(BulletSurfaceTest, ConvexShapes_ReachAsFarAsTheirSupport) {
  const btScalar r = btScalar(0.4), h = btScalar(0.9);
  ExpectSurfaceOfConvex(btSphereShape(r));
  ExpectSurfaceOfConvex(btCapsuleShapeX(r, h));
  ExpectSurfaceOfConvex(btCapsuleShape(r, h));
  ExpectSurfaceOfConvex(btCapsuleShapeZ(r, h));
  ExpectSurfaceOfConvex(btCylinderShapeX(btVector3(h, r, r)));
  ExpectSurfaceOfConvex(btConeShape(r, h));
  btBoxShape box(btVector3(r, h, 1));
  box.setLocalScaling(btVector3(1, 2, btScalar(0.5)));
  ExpectSurfaceOfConvex(box);
}

TEST(BulletSurfaceTest, ShapesThatTheOracleDoesNotJudge_AreDrawnAsWell) {
  Random random(2, 0);
  btConvexHullShape large, flat;
  for (int i = 0; i < 800; ++i) large.addPoint(ToBullet(random.UnitVector()));
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    flat.addPoint(btVector3(btScalar(x), btScalar(y), 0));
  }
  flat.setMargin(0);
  ExpectSurfaceOfConvex(large);
  ExpectSurfaceOfConvex(flat);
  const std::vector<btVector3> centres = {btVector3(-1, 0, 0), btVector3(1, 0, 0)};
  const std::vector<btScalar> radii = {btScalar(0.8), btScalar(0.3)};
  ExpectSurfaceOfConvex(btMultiSphereShape(centres.data(), radii.data(), 2));
}

TEST(BulletSurfaceTest, Compound_HasItsChildrenInTheirPlaces) {
  btBoxShape box(btVector3(1, 1, 1));
  btSphereShape ball(1);
  btCompoundShape inner, outer;
  const btTransform turned(btQuaternion(btVector3(0, 0, 1), btScalar(SIMD_HALF_PI)), btVector3(0, 0, 5));
  inner.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(3, 0, 0)), &box);
  outer.addChildShape(turned, &inner);
  outer.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, -4, 0)), &ball);
  const SurfaceMesh mesh = SurfaceOf(outer, kSquare);
  EXPECT_NEAR(Volume(mesh), 8 + 4 * SIMD_PI / 3, 0.1);
  ExpectNormalsToFaceOutwards(mesh);
  EXPECT_NEAR(SupportValue(mesh, Vector3d::UnitY()), 4, 0.01) << "the box, turned to y";
  EXPECT_NEAR(SupportValue(mesh, Vector3d::UnitZ()), 6, 0.01);
  EXPECT_NEAR(SupportValue(mesh, -Vector3d::UnitY()), 5, 0.01);
}

TEST(BulletSurfaceTest, Mesh_HasEachTriangleFromBothSides) {
  btTriangleMesh triangles;
  triangles.addTriangle(btVector3(0, 0, 1), btVector3(1, 0, 1), btVector3(0, 1, 1));
  triangles.addTriangle(btVector3(1, 0, 1), btVector3(1, 1, 1), btVector3(0, 1, 1));
  triangles.addTriangle(btVector3(0, 0, 1), btVector3(1, 1, 1), btVector3(1, 1, 1));  // Without an area.
  btBvhTriangleMeshShape mesh_shape(&triangles, true);
  const btScaledBvhTriangleMeshShape scaled(&mesh_shape, btVector3(2, 3, 4));
  const SurfaceMesh mesh = SurfaceOf(scaled, kSquare);
  ASSERT_EQ(mesh.size(), 12u);
  ExpectNormalsToFaceOutwards(mesh);
  EXPECT_EQ(std::ranges::count_if(mesh, [](const SurfaceVertex& vertex) { return vertex.normal.z() > 0.99f; }), 6);
  EXPECT_NEAR(SupportValue(mesh, Vector3d::UnitX()), 2, 1e-6);
  EXPECT_NEAR(SupportValue(mesh, Vector3d::UnitY()), 3, 1e-6);
  EXPECT_NEAR(SupportValue(mesh, -Vector3d::UnitZ()), -4, 1e-6);
}

TEST(BulletSurfaceTest, Plane_IsASquareAroundTheMiddle) {
  const Vector3d normal = Vector3d(1, 2, 2) / 3;
  const SurfaceMesh mesh = SurfaceOf(btStaticPlaneShape(ToBullet(normal), btScalar(0.5)), kSquare);
  ASSERT_EQ(mesh.size(), 6u);
  ExpectNormalsToFaceOutwards(mesh);
  const Vector3d middle = kSquare.middle - (normal.dot(kSquare.middle) - 0.5) * normal;
  for (const SurfaceVertex& vertex : mesh) {
    const Vector3d corner = vertex.position.cast<double>();
    EXPECT_NEAR(corner.dot(normal), 0.5, 1e-4);
    EXPECT_NEAR((corner - middle).norm(), kSquare.half_size * std::sqrt(2.0), 1e-3);
    EXPECT_GT(vertex.normal.cast<double>().dot(normal), 0.999);
  }
}

}  // namespace
}  // namespace dgd_demos
