#include "simulation/rounded_core.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <stdexcept>
#include <vector>

#include "scene/shape.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostVertices = 400;

// Rotation from local z to another axis, by an even exchange of axes.
Polyhedron AlongAxis(int axis, Polyhedron polyhedron) {
  if (axis == 2) return polyhedron;
  const auto turn = [axis](Vector3d& v) {
    v = axis == 0 ? Vector3d(v.z(), v.x(), v.y()) : Vector3d(v.y(), v.z(), v.x());
  };
  for (Vector3d& vertex : polyhedron.vertices) turn(vertex);
  for (Polyhedron::Face& face : polyhedron.faces) turn(face.normal);
  return polyhedron;
}

RoundedPolyhedron CoreOfBox(const btBoxShape& box) {
  const Shape shape = Box{FromBullet(box.getHalfExtentsWithMargin())};
  const double margin = double(box.getMargin());
  return {CoreOf(shape, margin), RoundingRadius(shape, margin)};
}

// The convex radius is the shape's own margin, which a tenth of its size need not bound: a program may set any margin.
std::optional<RoundedPolyhedron> CoreOfCylinder(const btCylinderShape& cylinder) {
  const int axis = cylinder.getUpAxis();
  const Vector3d core = FromBullet(cylinder.getHalfExtentsWithoutMargin());
  const double radius = core[(axis + 1) % 3], half_height = core[axis];
  if (!(radius > 0) || !(half_height > 0)) return std::nullopt;
  const Shape sharp = Cylinder{radius, 2 * half_height};
  return RoundedPolyhedron{AlongAxis(axis, CoreOf(sharp, 0)), double(cylinder.getMargin())};
}

std::optional<RoundedPolyhedron> CoreOfCone(const btConeShape& cone) {
  if (!(cone.getRadius() > 0) || !(cone.getHeight() > 0)) return std::nullopt;
  const Shape shape = Cone{double(cone.getRadius()), double(cone.getHeight())};
  return RoundedPolyhedron{AlongAxis(cone.getConeUpIndex(), CoreOf(shape, 0)), double(cone.getMargin())};
}

std::optional<RoundedPolyhedron> CoreOfHull(const btConvexHullShape& hull) {
  std::vector<Vector3d> points;
  for (int i = 0; i < hull.getNumPoints(); ++i) points.push_back(FromBullet(hull.getScaledPoint(i)));
  if (points.size() > kMostVertices) return std::nullopt;
  return RoundedPolyhedron{ConvexHull(points), double(hull.getMargin())};
}

std::optional<RoundedPolyhedron> CoreOfMultiSphere(const btMultiSphereShape& spheres) {
  const Vector3d scaling = FromBullet(spheres.getLocalScaling());
  if (scaling != Vector3d::Constant(scaling.x())) return std::nullopt;
  std::vector<Vector3d> centres;
  for (int i = 0; i < spheres.getSphereCount(); ++i) {
    if (spheres.getSphereRadius(i) != spheres.getSphereRadius(0)) return std::nullopt;
    centres.push_back(FromBullet(spheres.getSpherePosition(i)) * scaling.x());
  }
  const double radius = double(spheres.getSphereRadius(0)) * scaling.x();
  if (centres.size() == 1) {
    Polyhedron point = PointPolyhedron();
    point.vertices[0] = centres[0];
    return RoundedPolyhedron{std::move(point), radius};
  }
  if (centres.size() == 2) {
    Polyhedron segment = SegmentPolyhedron(1);
    segment.vertices = centres;
    return RoundedPolyhedron{std::move(segment), radius};
  }
  if (centres.size() > kMostVertices) return std::nullopt;
  return RoundedPolyhedron{ConvexHull(centres), radius};
}

// @throws std::invalid_argument as ConvexHull().
std::optional<RoundedPolyhedron> SolidCoreOf(const btConvexShape& shape) {
  switch (shape.getShapeType()) {
    case SPHERE_SHAPE_PROXYTYPE:
      return RoundedPolyhedron{PointPolyhedron(), double(static_cast<const btSphereShape&>(shape).getRadius())};
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      return RoundedPolyhedron{AlongAxis(capsule.getUpAxis(), SegmentPolyhedron(double(capsule.getHalfHeight()))),
                               double(capsule.getRadius())};
    }
    case BOX_SHAPE_PROXYTYPE:
      return CoreOfBox(static_cast<const btBoxShape&>(shape));
    case CYLINDER_SHAPE_PROXYTYPE:
      return CoreOfCylinder(static_cast<const btCylinderShape&>(shape));
    case CONE_SHAPE_PROXYTYPE:
      return CoreOfCone(static_cast<const btConeShape&>(shape));
    case CONVEX_HULL_SHAPE_PROXYTYPE:
      return CoreOfHull(static_cast<const btConvexHullShape&>(shape));
    case MULTI_SPHERE_SHAPE_PROXYTYPE:
      return CoreOfMultiSphere(static_cast<const btMultiSphereShape&>(shape));
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<RoundedPolyhedron> RoundedCoreOf(const btConvexShape& shape) {
  try {
    return SolidCoreOf(shape);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // Flat, or nearly so: the oracle does not judge polygons.
  }
}

namespace {

// False if a part has no core.
bool AddParts(const btCollisionShape& shape, const Pose& pose, std::vector<OraclePart>& parts) {
  if (shape.isConvex()) {
    auto core = RoundedCoreOf(static_cast<const btConvexShape&>(shape));
    if (!core) return false;
    parts.push_back({std::move(*core), pose});
    return true;
  }
  if (!shape.isCompound()) return false;
  const auto& compound = static_cast<const btCompoundShape&>(shape);
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    if (!AddParts(*compound.getChildShape(i), pose * FromBullet(compound.getChildTransform(i)), parts)) return false;
  }
  return true;
}

}  // namespace

OracleBody OracleBodyOf(const btCollisionShape& shape) {
  OracleBody body;
  if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
    const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
    body.half_space = HalfSpace{FromBullet(plane.getPlaneNormal()), double(plane.getPlaneConstant())};
  } else if (!AddParts(shape, Pose{}, body.parts)) {
    body.parts.clear();
  }
  return body;
}

}  // namespace dgd_demos
