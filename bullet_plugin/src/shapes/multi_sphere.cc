#include "shapes/multi_sphere.h"

#include <algorithm>
#include <limits>

#include "bullet_conversions.h"
#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

double RadiusOf(const btMultiSphereShape& spheres, int i) {
  return double(spheres.getLocalScalingNV().x()) * double(spheres.getSphereRadius(i));
}

Vector3 CenterOf(const btMultiSphereShape& spheres, int i) {
  return FromBullet(spheres.getSpherePosition(i)).cwiseProduct(FromBullet(spheres.getLocalScalingNV()));
}

dgd::SupportPoint<double> Support(const void* object, const Vector3& direction) {
  const auto& spheres = *static_cast<const btMultiSphereShape*>(object);
  const Vector3 outwards = direction.stableNormalized();
  const double smallest = SmallestRadius(spheres);
  double highest = -std::numeric_limits<double>::infinity();
  Vector3 farthest = Vector3::Zero();
  for (int i = 0; i < spheres.getSphereCount(); ++i) {
    const Vector3 point = CenterOf(spheres, i) + (RadiusOf(spheres, i) - smallest) * outwards;
    const double height = outwards.dot(point);
    if (!(height > highest)) continue;
    highest = height;
    farthest = point;
  }
  return {farthest};
}

}  // namespace

bool AreSpheres(const btMultiSphereShape& spheres) {
  const btVector3& scaling = spheres.getLocalScalingNV();
  return spheres.getSphereCount() > 0 && scaling.x() > 0 && scaling.x() == scaling.y() && scaling.x() == scaling.z();
}

double SmallestRadius(const btMultiSphereShape& spheres) {
  DGD_ASSERT(spheres.getSphereCount() > 0);
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < spheres.getSphereCount(); ++i) smallest = std::min(smallest, RadiusOf(spheres, i));
  return smallest;
}

bool HaveOneRadius(const btMultiSphereShape& spheres) {
  for (int i = 1; i < spheres.getSphereCount(); ++i) {
    if (spheres.getSphereRadius(i) != spheres.getSphereRadius(0)) return false;
  }
  return true;
}

dgd::CustomCore CoreOfSpheres(const btMultiSphereShape& spheres) {
  DGD_ASSERT(AreSpheres(spheres));
  Vector3 center = Vector3::Zero();
  for (int i = 0; i < spheres.getSphereCount(); ++i) center += CenterOf(spheres, i) / double(spheres.getSphereCount());
  return {&spheres, Support, center, 0, 0};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
