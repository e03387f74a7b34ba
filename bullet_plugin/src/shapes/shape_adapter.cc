#include "shapes/shape_adapter.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include "shapes/bullet_support.h"
#include "shapes/multi_sphere.h"
#include "shapes/shape_points.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// The hull of a shape's points, cached in `hull` from one call to the next.
dgd::CoreReference<dgd::Polytope<double>> HullOf(const btConvexShape& shape, HullCache& cache,
                                                 std::shared_ptr<const CachedHull>& hull, HullUse use) {
  if (hull == nullptr || !hull->Matches(shape)) hull = cache.Find(shape);
  return dgd::CoreReference(hull->CoreForQuery(use));
}

/// Spheres of one radius are the hull of their centres with that radius.
PosedShape AdaptSpheres(const btMultiSphereShape& spheres, const btTransform& transform, HullCache& cache,
                        std::shared_ptr<const CachedHull>& hull, HullUse use) {
  const double radius = dgd::RequireLength(SmallestRadius(spheres), true, "radius of a multi-sphere");
  if (HaveOneRadius(spheres))
    return {dgd::RoundedSet{HullOf(spheres, cache, hull, use), radius}, FromBullet(transform)};
  return {dgd::RoundedSet{CoreOfSpheres(spheres), radius}, FromBullet(transform)};
}

}  // namespace

int UpAxis(const btConvexShape& shape) {
  switch (shape.getShapeType()) {
    case CAPSULE_SHAPE_PROXYTYPE:
      return static_cast<const btCapsuleShape&>(shape).getUpAxis();
    case CYLINDER_SHAPE_PROXYTYPE:
      return static_cast<const btCylinderShape&>(shape).getUpAxis();
    case CONE_SHAPE_PROXYTYPE:
      return static_cast<const btConeShape&>(shape).getConeUpIndex();
    default:
      return kZAxis;
  }
}

PosedShape AdaptShape(const btConvexShape& shape, const btTransform& transform, GeometryMode geometry, HullCache& cache,
                      std::shared_ptr<const CachedHull>& hull, HullUse use, bool is_for_distance) {
  const int type = shape.getShapeType();
  const double margin = dgd::RequireLength(double(shape.getMargin()), true, "collision margin");
  // The radius of shapes that have a margin besides their core.
  const bool is_sharp = geometry == GeometryMode::kSharp;
  const double radius = is_sharp ? 0 : margin;
  switch (type) {
    case SPHERE_SHAPE_PROXYTYPE:
      // A sphere's margin is its radius.
      return {dgd::RoundedSet{dgd::Point<double>(), margin}, FromBullet(transform)};
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      return {dgd::RoundedSet{dgd::Segment<double>(double(ClampHalfExtent(capsule.getHalfHeight()))), margin},
              FromBullet(transform, UpAxis(shape))};
    }
    case TRIANGLE_SHAPE_PROXYTYPE: {
      const btVector3* corners = static_cast<const btTriangleShape&>(shape).m_vertices1;
      return {
          dgd::RoundedSet{dgd::Triangle<double>(FromBullet(corners[0]), FromBullet(corners[1]), FromBullet(corners[2])),
                          radius},
          FromBullet(transform)};
    }
    case BOX_SHAPE_PROXYTYPE: {
      // A box includes its margin, and users see it with sharp edges, as Bullet's own test of two boxes does.
      const btVector3 half = static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin();
      const Vector3 core =
          FromBullet({ClampHalfExtent(half.x()), ClampHalfExtent(half.y()), ClampHalfExtent(half.z())});
      return {dgd::RoundedSet{dgd::Box<double>(core), 0.0}, FromBullet(transform)};
    }
    case CYLINDER_SHAPE_PROXYTYPE: {
      const auto& cylinder = static_cast<const btCylinderShape&>(shape);
      const btVector3 half = is_sharp ? cylinder.getHalfExtentsWithMargin() : cylinder.getHalfExtentsWithoutMargin();
      const int up = UpAxis(shape);
      // Bullet takes the radius from the first axis that is not the cylinder's own.
      return {dgd::RoundedSet{dgd::Cylinder<double>(double(ClampHalfExtent(half[up == 0 ? 1 : 0])),
                                                    double(ClampHalfExtent(half[up]))),
                              radius},
              FromBullet(transform, up)};
    }
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      return {dgd::RoundedSet{dgd::Cone<double>(double(cone.getRadius()), double(cone.getHeight())), radius},
              FromBullet(transform, UpAxis(shape))};
    }
    case MULTI_SPHERE_SHAPE_PROXYTYPE: {
      const auto& spheres = static_cast<const btMultiSphereShape&>(shape);
      if (AreSpheres(spheres)) return AdaptSpheres(spheres, transform, cache, hull, use);
      break;
    }
    default:
      break;
  }
  if (IsHullOfPoints(shape)) return {dgd::RoundedSet{HullOf(shape, cache, hull, use), radius}, FromBullet(transform)};
  return {dgd::RoundedSet{CustomSupport(shape, radius, is_for_distance), radius}, FromBullet(transform)};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
