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

/// Points that are looked at in less time than the solver takes to find its own.
constexpr int kMostPoints = 128;

/// As many numbers as a btVector3 has in memory, of which the fourth may be anything.
using Four [[gnu::vector_size(4 * sizeof(btScalar))]] = btScalar;

/// Largest <direction, point>, in Bullet's precision, of four points at a time. NaN counts as no point: a hull that has
/// one is no shape, and the solver's to refuse.
double Highest(const btVector3* points, int count, const btVector3& direction) {
  using InMemory [[gnu::vector_size(4 * sizeof(btScalar)), gnu::aligned(alignof(btVector3)), gnu::may_alias]] =
      btScalar;
  const Four along = {direction.x(), direction.y(), direction.z(), 0};
  Four highest = Four{} - BT_LARGE_FLOAT;
  const auto look_at = [&](const btVector3* at_a, const btVector3* at_b, const btVector3* at_c, const btVector3* at_d) {
    Four a = *reinterpret_cast<const InMemory*>(at_a), b = *reinterpret_cast<const InMemory*>(at_b);
    Four c = *reinterpret_cast<const InMemory*>(at_c), d = *reinterpret_cast<const InMemory*>(at_d);
    a *= along, b *= along, c *= along, d *= along;
    const Four ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Four ab_z = __builtin_shufflevector(a, b, 2, 6, 2, 6), cd_z = __builtin_shufflevector(c, d, 2, 6, 2, 6);
    const Four heights = __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7) +
                         __builtin_shufflevector(ab_z, cd_z, 0, 1, 4, 5);
    highest = heights > highest ? heights : highest;
  };
  const btVector3 *point = points, *end = points + count;
  for (; end - point >= 4; point += 4) look_at(point, point + 1, point + 2, point + 3);
  if (point != end) look_at(point, std::min(point + 1, end - 1), std::min(point + 2, end - 1), end - 1);
  return double(std::max({highest[0], highest[1], highest[2], highest[3]}));
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
