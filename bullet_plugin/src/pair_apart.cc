#include "pair_apart.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "pair_motion.h"

namespace dgd_bullet {
namespace {

/// What Bullet's support functions are off by, of the distance of a shape's farthest point: some roundings of the
/// direction, and of each point's height.
constexpr double kRounding = 32 * double(std::numeric_limits<btScalar>::epsilon());

/// Larger hulls are the solver's, which climbs them. A point takes 12 instructions here, on either side; the solver's
/// way takes 2000 in all (callgrind, hulls of 8 to 20 points).
constexpr int kMostPoints = 64;

/// Largest <direction, point>, in Bullet's precision. NaN counts as no point: a hull that has one is no shape, and the
/// solver's to refuse.
double Highest(const btVector3* points, int count, const btVector3& direction) {
  btScalar highest = -BT_LARGE_FLOAT;
  for (const btVector3* point = points; point != points + count; ++point) {
    const btScalar height = direction.x() * point->x() + direction.y() * point->y() + direction.z() * point->z();
    highest = height > highest ? height : highest;
  }
  return double(highest);
}

template <class Shape>
std::optional<double> HighestPoint(const btConvexShape& shape, const btVector3& direction) {
  const auto& points = static_cast<const Shape&>(shape);
  const int count = points.getNumPoints();
  if (count < 1 || count > kMostPoints) return std::nullopt;
  return Highest(points.getUnscaledPoints(), count, direction * points.getLocalScalingNV());
}

/// Largest <direction, x> over a shape without its margin, metres; nothing if it would take long.
std::optional<double> CoreSupportValue(const btConvexShape& shape, const btVector3& direction) {
  switch (shape.getShapeType()) {
    case CONVEX_HULL_SHAPE_PROXYTYPE:
      return HighestPoint<btConvexHullShape>(shape, direction);
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
      return HighestPoint<btConvexPointCloudShape>(shape, direction);
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
      return std::nullopt;
    case BOX_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
      // A margin set larger than the shape turns Bullet's core inside out; the solver's is a point then.
      return std::max(0.0, double(direction.dot(shape.localGetSupportVertexWithoutMarginNonVirtual(direction))));
    default:
      return double(direction.dot(shape.localGetSupportVertexWithoutMarginNonVirtual(direction)));
  }
}

/// Largest <direction, x> over a body, margin and rounding included; world, metres.
std::optional<double> SupportValue(const btCollisionObjectWrapper& body, const Vector3& direction) {
  const auto& shape = static_cast<const btConvexShape&>(*body.getCollisionShape());
  const btTransform& transform = body.getWorldTransform();
  const btVector3 local = ToBullet(direction) * transform.getBasis();
  const std::optional<double> height = CoreSupportValue(shape, local);
  if (!height) return std::nullopt;
  const Vector3 origin = FromBullet(transform.getOrigin());
  return direction.dot(origin) + *height + double(shape.getMargin()) +
         kRounding * Reach(*body.getCollisionObject(), origin);
}

}  // namespace

bool AreApart(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b, const Vector3& normal,
              double limit) {
  const std::optional<double> top_a = SupportValue(body_a, normal), top_b = SupportValue(body_b, -normal);
  if (!top_a || !top_b) return false;
  const double separation = -*top_a - *top_b;
  return separation > limit && separation < std::numeric_limits<double>::infinity();  // False for NaN.
}

}  // namespace dgd_bullet
