// Bounding boxes of shapes on their way over the step, by which the triangles of meshes and the children of compounds
// are found that a body may touch.
#pragma once

#include <LinearMath/btVector3.h>

#include "dgd_bullet/linkage.h"

class btTransform;
struct btCollisionObjectWrapper;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairMotion;

/// A box whose sides are along the axes of a frame; metres.
struct Box {
  btVector3 low, high;
};

/// The box of all places where a shape may touch what is fixed to a frame within the step, in that frame.
/// @param shape     A shape of the motion's body A.
/// @param frame     Frame that is fixed to the motion's body B; world.
/// @param distance  Metres up to which they touch.
Box SweptBox(const btCollisionObjectWrapper& shape, const btTransform& frame, const PairMotion& motion,
             double distance);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
