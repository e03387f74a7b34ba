#include "pipeline/separating_axis.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pipeline/pair_motion.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// What Bullet's support functions are off by, of the distance of a shape's farthest point: some roundings of the
/// direction, and of each point's height.
constexpr double kRounding = 32 * double(std::numeric_limits<btScalar>::epsilon());

/// Larger hulls are the solver's, which climbs them. A point takes up to 12 instructions here, on either side; the
/// solver's way takes 2000 in all (callgrind, hulls of 8 to 20 points).
constexpr int kMostPoints = 64;

constexpr btScalar kUnknown = std::numeric_limits<btScalar>::infinity();

/// Largest <direction, point>. NaN counts as no point: a hull that has one is no shape, and the solver's to refuse.
btScalar HighestInTurn(const btVector3* points, int count, const btVector3& direction) {
  btScalar highest = -BT_LARGE_FLOAT;
  for (const btVector3* point = points; point != points + count; ++point) {
    const btScalar height = direction.x() * point->x() + direction.y() * point->y() + direction.z() * point->z();
    highest = height > highest ? height : highest;
  }
  return highest;
}

#if defined(__SSE__) && !defined(BT_USE_DOUBLE_PRECISION)
/// The same, four points at a time: two thirds of the time for hulls of 8 to 20 points.
btScalar Highest(const btVector3* points, int count, const btVector3& direction) {
  constexpr int kLanes = 4;
  if (count < kLanes) return HighestInTurn(points, count, direction);
  const __m128 x = _mm_set1_ps(direction.x()), y = _mm_set1_ps(direction.y()), z = _mm_set1_ps(direction.z());
  __m128 highest = _mm_set1_ps(-BT_LARGE_FLOAT);
  for (int i = 0; i < count; i += kLanes) {
    // The last four overlap those before.
    const btVector3* four = points + std::min(i, count - kLanes);
    __m128 points_x = _mm_loadu_ps(four[0]), points_y = _mm_loadu_ps(four[1]), points_z = _mm_loadu_ps(four[2]),
           unused = _mm_loadu_ps(four[3]);
    _MM_TRANSPOSE4_PS(points_x, points_y, points_z, unused);
    const __m128 heights =
        _mm_add_ps(_mm_add_ps(_mm_mul_ps(x, points_x), _mm_mul_ps(y, points_y)), _mm_mul_ps(z, points_z));
    highest = _mm_max_ps(heights, highest);  // The second where one is NaN.
  }
  std::array<float, kLanes> lanes;
  _mm_storeu_ps(lanes.data(), highest);
  return *std::max_element(lanes.begin(), lanes.end());
}
#else
btScalar Highest(const btVector3* points, int count, const btVector3& direction) {
  return HighestInTurn(points, count, direction);
}
#endif

template <class Shape>
btScalar HighestPoint(const btConvexShape& shape, const btVector3& direction) {
  const auto& points = static_cast<const Shape&>(shape);
  const int count = points.getNumPoints();
  if (count < 1 || count > kMostPoints) return kUnknown;
  return Highest(points.getUnscaledPoints(), count, direction * points.getLocalScalingNV());
}

/// Largest <direction, x> over a shape without its margin, metres; kUnknown if it would take long.
btScalar CoreSupportValue(const btConvexShape& shape, const btVector3& direction) {
  switch (shape.getShapeType()) {
    case CONVEX_HULL_SHAPE_PROXYTYPE:
      return HighestPoint<btConvexHullShape>(shape, direction);
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
      return HighestPoint<btConvexPointCloudShape>(shape, direction);
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
      return kUnknown;
    case SPHERE_SHAPE_PROXYTYPE:
      return 0;
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      return Extent(capsule.getHalfHeight()) * btFabs(direction[capsule.getUpAxis()]);
    }
    case BOX_SHAPE_PROXYTYPE: {
      const btVector3 half = static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin();
      return Extent(half.x()) * btFabs(direction.x()) + Extent(half.y()) * btFabs(direction.y()) +
             Extent(half.z()) * btFabs(direction.z());
    }
    case CYLINDER_SHAPE_PROXYTYPE:
      // As Extent() has it.
      return btMax(btScalar(0), direction.dot(shape.localGetSupportVertexWithoutMarginNonVirtual(direction)));
    default:
      return direction.dot(shape.localGetSupportVertexWithoutMarginNonVirtual(direction));
  }
}

/// Largest <direction, x> over a shape, margin and rounding included, from its own origin; the direction is the
/// world's, metres.
double SupportValue(const PlacedShape& placed, const btVector3& direction) {
  const auto& shape = static_cast<const btConvexShape&>(*placed.wrapper.getCollisionShape());
  const btTransform& pose = placed.wrapper.getWorldTransform();
  // Of a part of a body, the origin is elsewhere.
  const btVector3 aside = (pose.getOrigin() - placed.body.object.getWorldTransform().getOrigin()).absolute();
  const double reach = placed.body.reach + double(aside.x() + aside.y() + aside.z());
  const bool is_box = shape.getShapeType() == BOX_SHAPE_PROXYTYPE;  // Its margin is within it.
  return double(CoreSupportValue(shape, direction * pose.getBasis())) + (is_box ? 0 : double(shape.getMargin())) +
         kRounding * reach;
}

}  // namespace

double SeparationAlong(const PlacedShape& shape_a, const PlacedShape& shape_b, const btVector3& normal) {
  const Vector3 between = FromBullet(shape_b.wrapper.getWorldTransform().getOrigin()) -
                          FromBullet(shape_a.wrapper.getWorldTransform().getOrigin());
  const double separation =
      FromBullet(normal).dot(between) - SupportValue(shape_a, normal) - SupportValue(shape_b, -normal);
  return std::isfinite(separation) ? separation : -std::numeric_limits<double>::infinity();
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
