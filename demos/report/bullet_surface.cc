#include "report/bullet_surface.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "simulation/bullet_math.h"
#include "simulation/rounded_core.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// A rotation that takes z to a unit vector.
Eigen::Matrix3d AxesAlong(const Vector3d& z) {
  Eigen::Matrix3d axes;
  axes << z.unitOrthogonal(), Vector3d::Zero(), z;
  axes.col(1) = z.cross(axes.col(0));
  return axes;
}

// A sphere or a capsule.
SurfaceMesh CapsuleSurface(const Vector3d& start, const Vector3d& end, double radius) {
  const double length = (end - start).norm();
  Pose pose{Eigen::Matrix3d::Identity(), (start + end) / 2};
  if (length > 0) pose.rotation = AxesAlong((end - start) / length);
  SurfaceMesh mesh;
  Append(RoundedRevolutionSurface({{0, -length / 2}, {0, length / 2}}, radius), pose, mesh);
  return mesh;
}

SurfaceMesh SurfaceOfRounded(const RoundedPolyhedron& shape) {
  if (shape.core.IsSolid()) return RoundedPolyhedronSurface(shape.core, shape.radius);
  return CapsuleSurface(shape.core.vertices.front(), shape.core.vertices.back(), shape.radius);
}

// Support points in directions that a spiral spreads evenly over the sphere. A flat shape gets a thickness, so that it
// has a hull.
SurfaceMesh SupportHullSurface(const btConvexShape& shape) {
  constexpr int kDirections = 1000;
  constexpr double kThickness = 1e-3;  // In bounding radii.
  btVector3 ignored_centre;
  btScalar radius = 0;
  shape.getBoundingSphere(ignored_centre, radius);
  std::vector<Vector3d> points;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1 - (2 * i + 1.0) / kDirections, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    const Vector3d direction(r * std::cos(angle), r * std::sin(angle), z);
    points.push_back(FromBullet(shape.localGetSupportingVertex(ToBullet(direction))) +
                     kThickness * double(radius) * direction);
  }
  return RoundedPolyhedronSurface(ConvexHull(points), 0);
}

SurfaceMesh ConvexSurface(const btConvexShape& shape) {
  const std::optional<RoundedPolyhedron> core = RoundedCoreOf(shape);
  return core ? SurfaceOfRounded(*core) : SupportHullSurface(shape);
}

SurfaceMesh PlaneSurface(const btStaticPlaneShape& plane, const PlaneSquare& square) {
  const Vector3d normal = FromBullet(plane.getPlaneNormal());
  const Vector3d middle = square.middle - (normal.dot(square.middle) - double(plane.getPlaneConstant())) * normal;
  SurfaceMesh mesh;
  for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
    const Vector3d corner = middle + AxesAlong(normal) * Vector3d(x, y, 0) * square.half_size;
    mesh.push_back({corner.cast<float>(), normal.cast<float>()});
  }
  return mesh;
}

SurfaceMesh TriangleSurface(const btConcaveShape& shape) {
  struct Corners : btTriangleCallback {
    std::vector<Vector3d> points;
    void processTriangle(btVector3* triangle, int /*part*/, int /*index*/) override {
      for (int i = 0; i < 3; ++i) points.push_back(FromBullet(triangle[i]));
    }
  } corners;
  btVector3 low, high;
  shape.getAabb(btTransform::getIdentity(), low, high);
  shape.processAllTriangles(&corners, low, high);
  return TwoSidedSurface(corners.points);
}

SurfaceMesh CompoundSurface(const btCompoundShape& compound, const PlaneSquare& square) {
  SurfaceMesh mesh;
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    const btTransform& child = compound.getChildTransform(i);
    const PlaneSquare in_child{FromBullet(child.invXform(ToBullet(square.middle))), square.half_size};
    Append(SurfaceOf(*compound.getChildShape(i), in_child), FromBullet(child), mesh);
  }
  return mesh;
}

}  // namespace

SurfaceMesh SurfaceOf(const btCollisionShape& shape, const PlaneSquare& square) {
  if (shape.isConvex()) return ConvexSurface(static_cast<const btConvexShape&>(shape));
  if (shape.isCompound()) return CompoundSurface(static_cast<const btCompoundShape&>(shape), square);
  if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
    return PlaneSurface(static_cast<const btStaticPlaneShape&>(shape), square);
  }
  return shape.isConcave() ? TriangleSurface(static_cast<const btConcaveShape&>(shape)) : SurfaceMesh{};
}

}  // namespace dgd_demos
