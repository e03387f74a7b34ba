// What a set shows a half-space: the contact patch of a body on the ground.
//
// The border has no end and faces the set's lowest face wherever that is, so nothing is clipped: the patch's corners
// are those of that face.
#pragma once

#include "dgd/facing_faces.h"
#include "dgd/half_space_distance.h"

namespace dgd {

/// The faces of set 1 and a half-space as set 2 along a result's normal, as FindContactPatch() takes them. The
/// half-space's own has no corners: `overlap` is all of the set's face.
/// @param result  Of GrowthDistance() for the two; its normal, separation and witness points count. World, metres.
template <class Set>
requires ConvexCore<typename Set::Core>
void FindFacingFaces(const Set& set, const Pose<typename Set::Scalar>& pose, const HalfSpace<typename Set::Scalar>&,
                     const Result<typename Set::Scalar>& result, FacingFaces<typename Set::Scalar>& facing) {
  facing.Clear();
  facing.frame = PatchFrame<typename Set::Scalar>(result);
  FindFace(set, pose, result.normal, facing.frame, facing.face_1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(facing.face_1.size); ++i) {
    const auto& point = facing.face_1.points[i];
    facing.overlap.Add({point.x(), point.y(), point.z(), result.separation / 2});
  }
}

}  // namespace dgd
