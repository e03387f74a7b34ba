#include "pair/separating_axis.h"

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

#include "dgd/assert.h"
#include "pair_motion.h"
#include "separation_report.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Error of Bullet's support functions relative to the distance of a shape's farthest point: some roundings of the
/// direction, and of each point's height.
constexpr double kRoundoff = 32 * double(std::numeric_limits<btScalar>::epsilon());

constexpr btScalar kUnknown = std::numeric_limits<btScalar>::infinity();

/// Largest <direction, point>. NaN counts as no point: a hull that has one is no shape, which the solver rejects.
btScalar MaxHeightScalar(const btVector3* points, int count, const btVector3& direction) {
  btScalar highest = -BT_LARGE_FLOAT;
  for (const btVector3* point = points; point != points + count; ++point) {
    const btScalar height = direction.x() * point->x() + direction.y() * point->y() + direction.z() * point->z();
    highest = height > highest ? height : highest;
  }
  return highest;
}

#if defined(__SSE__) && !defined(BT_USE_DOUBLE_PRECISION)
/// Largest <direction, point>, four points at a time: two thirds of the time for hulls of 8 to 20 points.
btScalar MaxHeight(const btVector3* points, int count, const btVector3& direction) {
  constexpr int kLanes = 4;
  if (count < kLanes) return MaxHeightScalar(points, count, direction);
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
    highest = _mm_max_ps(heights, highest);  // Returns the second operand where one is NaN.
  }
  std::array<float, kLanes> lanes;
  _mm_storeu_ps(lanes.data(), highest);
  return *std::max_element(lanes.begin(), lanes.end());
}
#else
btScalar MaxHeight(const btVector3* points, int count, const btVector3& direction) {
  return MaxHeightScalar(points, count, direction);
}
#endif

template <class Shape>
btScalar MaxHeightOf(const btConvexShape& shape, const btVector3& direction) {
  const auto& points = static_cast<const Shape&>(shape);
  const int count = points.getNumPoints();
  if (count < 1 || count > kMaxScannedPoints) return kUnknown;
  return MaxHeight(points.getUnscaledPoints(), count, direction * points.getLocalScalingNV());
}

/// Largest <direction, x> over a shape without its margin, metres; kUnknown if that would take long.
btScalar CoreSupportValue(const btConvexShape& shape, const btVector3& direction) {
  switch (shape.getShapeType()) {
    case CONVEX_HULL_SHAPE_PROXYTYPE:
      return MaxHeightOf<btConvexHullShape>(shape, direction);
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
      return MaxHeightOf<btConvexPointCloudShape>(shape, direction);
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
      return kUnknown;
    case SPHERE_SHAPE_PROXYTYPE:
      return 0;
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      return ClampHalfExtent(capsule.getHalfHeight()) * btFabs(direction[capsule.getUpAxis()]);
    }
    case BOX_SHAPE_PROXYTYPE: {
      const btVector3 half = static_cast<const btBoxShape&>(shape).getHalfExtentsWithMargin();
      return ClampHalfExtent(half.x()) * btFabs(direction.x()) + ClampHalfExtent(half.y()) * btFabs(direction.y()) +
             ClampHalfExtent(half.z()) * btFabs(direction.z());
    }
    case CYLINDER_SHAPE_PROXYTYPE:
      // A margin larger than the cylinder leaves Bullet a negative core.
      return btMax(btScalar(0), direction.dot(shape.localGetSupportVertexWithoutMarginNonVirtual(direction)));
    default:
      return direction.dot(shape.localGetSupportVertexWithoutMarginNonVirtual(direction));
  }
}

/// Largest <direction, x> over a shape from its own origin, with its margin and an allowance for roundoff; metres.
/// @param direction  World, unit length.
double SupportValue(const PlacedShape& placed, const btVector3& direction) {
  const auto& shape = static_cast<const btConvexShape&>(*placed.wrapper.getCollisionShape());
  const btTransform& pose = placed.wrapper.getWorldTransform();
  // The origin of a part of a body is not the body's.
  const btVector3 aside = (pose.getOrigin() - placed.body.object.getWorldTransform().getOrigin()).absolute();
  const double radius = placed.body.radius + double(aside.x() + aside.y() + aside.z());
  const bool is_box = shape.getShapeType() == BOX_SHAPE_PROXYTYPE;  // A box includes its margin.
  return double(CoreSupportValue(shape, direction * pose.getBasis())) + (is_box ? 0 : double(shape.getMargin())) +
         kRoundoff * radius;
}

}  // namespace

constinit thread_local SeparationReport* separation_report = nullptr;

double SeparationAlong(const PlacedShape& shape_a, const PlacedShape& shape_b, const btVector3& normal) {
  const Vector3 between = FromBullet(shape_b.wrapper.getWorldTransform().getOrigin()) -
                          FromBullet(shape_a.wrapper.getWorldTransform().getOrigin());
  const double separation =
      FromBullet(normal).dot(between) - SupportValue(shape_a, normal) - SupportValue(shape_b, -normal);
  return std::isfinite(separation) ? separation : -std::numeric_limits<double>::infinity();
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
