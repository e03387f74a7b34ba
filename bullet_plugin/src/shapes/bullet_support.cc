#include "shapes/bullet_support.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <array>
#include <limits>

#include "bullet_conversions.h"
#include "dgd/convex_hull.h"
#include "dgd/solver/minkowski_difference.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// What the shape's arithmetic, in Bullet's precision, may be off by: a few roundings. Four times as much leaves one
/// deep overlap in 2000 of Bullet's cones and multi-spheres off by 1e-5 of its size (contact_parity).
constexpr double kAccuracy = 4 * double(std::numeric_limits<btScalar>::epsilon());

dgd::SupportPoint<double> Support(const void* object, const Vector3& direction) {
  const auto* shape = static_cast<const btConvexShape*>(object);
  return {FromBullet(shape->localGetSupportingVertexWithoutMargin(ToBullet(direction)))};
}

}  // namespace

dgd::CustomCore CustomSupport(const btConvexShape& shape, double radius, bool is_for_distance) {
  if (is_for_distance) return {&shape, Support, Vector3::Zero(), 0, kAccuracy};
  // Not along the axes: there, most of a box's support points are one corner.
  const Matrix3 axes = dgd::FrameAlong<double>(Vector3(0.4834, 0.5742, 0.6607).normalized());
  std::array<Vector3, 6> extremes;
  Vector3 center = Vector3::Zero();
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    extremes[i] = Support(&shape, (i % 2 == 0 ? 1 : -1) * axes.col(static_cast<Eigen::Index>(i / 2))).point;
    center += extremes[i] / double(extremes.size());
  }
  return {&shape, Support, center, radius > 0 ? 0 : dgd::InradiusAboutMean(extremes, center), kAccuracy};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
