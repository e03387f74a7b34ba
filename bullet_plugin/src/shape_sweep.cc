#include "shape_sweep.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <exception>
#include <utility>

#include "bullet_conversions.h"
#include "pair_sweep.h"
#include "shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Of the shape's body, whatever the shape's own axis.
Motion WayOf(const MovingShape& moving) { return Motion::Between(FromBullet(moving.from), FromBullet(moving.to)); }

Motion WayOf(const MovingShape& moving, const PosedShape& posed) {
  Motion motion = WayOf(moving);
  motion.start = posed.pose;
  return motion;
}

Vector3 VelocityAt(const Vector3& point, const Motion& motion) {
  return motion.translation + motion.rotation.cross(point - motion.start.translation);
}

}  // namespace

dgd::TimeOfImpactResult<double> SweepShapes(const MovingShape& a, const MovingShape& b, GeometryMode geometry,
                                            HullCache& cache, HullUse use) try {
  PosedShape shape_a = AdaptShape(a.shape, a.from, geometry, cache, a.hull, use);
  PosedShape shape_b = AdaptShape(b.shape, b.from, geometry, cache, b.hull, use);
  MoveCentersTogether(shape_a, shape_b);
  const Motion way_a = WayOf(a, shape_a), way_b = WayOf(b, shape_b);
  if (IsInOrder(shape_a, shape_b)) return SweepPair(shape_a, way_a, shape_b, way_b, {});
  dgd::TimeOfImpactResult<double> result = SweepPair(shape_b, way_b, shape_a, way_a, {});
  result.normal = -result.normal;
  std::swap(result.witness_1, result.witness_2);
  return result;
} catch (const std::exception&) {
  return {};  // A shape that is not one: NaN or infinite sizes, no points.
}

bool Meet(const dgd::TimeOfImpactResult<double>& result, const MovingShape& a, const MovingShape& b) {
  if (result.status == dgd::Status::kSeparated || result.status == dgd::Status::kInvalidInput) return false;
  if (result.time > 0) return true;
  const Vector3 approach = VelocityAt(result.witness_1, WayOf(a)) - VelocityAt(result.witness_2, WayOf(b));
  return result.normal.dot(approach) > 0;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
