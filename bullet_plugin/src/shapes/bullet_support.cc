#include "shapes/bullet_support.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <array>
#include <limits>

#include "bullet_conversions.h"
#include "dgd/convex_hull.h"

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

dgd::CustomCore CustomSupport(const btConvexShape& shape, double radius) {
  std::array<Vector3, 6> extremes;
  Vector3 center = Vector3::Zero();
  for (std::size_t i = 0; i < extremes.size(); ++i) {
    Vector3 direction = Vector3::Zero();
    direction[static_cast<Eigen::Index>(i / 2)] = i % 2 == 0 ? 1 : -1;
    extremes[i] = Support(&shape, direction).point;
    center += extremes[i] / double(extremes.size());
  }
  double inradius = 0;
  if (!(radius > 0)) {
    const dgd::ConvexHull hull = dgd::BuildConvexHull(extremes);
    center = hull.center;
    inradius = hull.inradius;
  }
  return {&shape, Support, center, inradius, kAccuracy};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
