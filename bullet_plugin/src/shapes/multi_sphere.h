// btMultiSphereShape: the hull of its spheres.
#pragma once

#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>

#include "dgd/shapes/custom_core.h"
#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether the scaling leaves the spheres spheres. With another one, Bullet's support function is not that of a convex
/// set, and the shape goes through it (bullet_support.h).
bool AreSpheres(const btMultiSphereShape& spheres);

/// Radius of the smallest sphere, scaled, of a shape for which AreSpheres() holds; metres.
double SmallestRadius(const btMultiSphereShape& spheres);

/// Whether all spheres have the same radius.
bool HaveOneRadius(const btMultiSphereShape& spheres);

/// The hull of the spheres, each with its radius less the smallest one, of a shape for which AreSpheres() holds. It is
/// evaluated in double in both precisions: with the roundoff of Bullet's own support function in float, flat shapes do
/// not converge. The shape must outlive it.
dgd::CustomCore CoreOfSpheres(const btMultiSphereShape& spheres);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
