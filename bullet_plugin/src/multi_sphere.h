// btMultiSphereShape: the hull of its spheres.
#pragma once

#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>

#include "dgd_bullet/linkage.h"
#include "support_core.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether the spheres are spheres, scaled as they are. Bullet's own support function is none of a hull otherwise.
bool AreSpheres(const btMultiSphereShape& spheres);

/// Of spheres that are; metres.
double SmallestRadius(const btMultiSphereShape& spheres);
bool HaveOneRadius(const btMultiSphereShape& spheres);

/// The hull of the spheres, less the smallest one's radius. In double, whatever Bullet's precision: with the roundoff
/// of Bullet's own support function in float, flat ones do not converge. The shape must outlive it.
SupportCore CoreOfSpheres(const btMultiSphereShape& spheres);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
