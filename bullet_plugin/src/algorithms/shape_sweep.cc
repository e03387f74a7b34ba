#include "algorithms/shape_sweep.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <exception>

#include "bullet_conversions.h"
#include "dgd/assert.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

using Motion = dgd::Motion<double>;

/// Motion of the shape's body, regardless of the shape's own axis.
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
  return dgd::TimeOfImpact(shape_a.set, WayOf(a, shape_a), shape_b.set, WayOf(b, shape_b));
} catch (const std::exception&) {
  return {};  // A shape that is not one: NaN or infinite sizes, no points.
}

bool Meet(const dgd::TimeOfImpactResult<double>& result, const MovingShape& a, const MovingShape& b) {
  if (result.status == dgd::Status::kSeparated || result.status == dgd::Status::kInvalidInput) return false;
  DGD_ASSERT(result.time >= 0 && result.time <= 1);
  if (result.time > 0) return true;
  const Vector3 approach = VelocityAt(result.witness_1, WayOf(a)) - VelocityAt(result.witness_2, WayOf(b));
  return result.normal.dot(approach) > 0;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
