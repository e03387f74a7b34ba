// What a set shows a half-space: the contact patch of a body on the ground.
//
// The border has no end and faces the set's lowest face wherever that is, so nothing is clipped: the patch's corners
// are those of that face.
#pragma once

#include "dgd/contact/facing_faces.h"
#include "dgd/half_space_distance.h"

namespace dgd {

/// What a set shows a half-space as set 2 along a result's normal, as FindContactPatch() takes it: its face there, all
/// of which the border overlaps. The border itself has no corners, so `face_2` is empty. Does not allocate or throw.
/// @param result  Of GrowthDistance() for the two; its normal, separation and witness points count. World, metres.
template <class Set>
requires ConvexCore<typename Set::Core> FacingFaces<typename Set::Scalar> FindFacingFaces(
    const Set& set, const Pose<typename Set::Scalar>& pose, const HalfSpace<typename Set::Scalar>&,
    const Result<typename Set::Scalar>& result) {
  FacingFaces<typename Set::Scalar> facing;
  facing.frame = PatchFrame<typename Set::Scalar>(result);
  FindFace(set, pose, result.normal, facing.frame, facing.face_1);
  // The frame's origin is half way between the surfaces.
  const typename Set::Scalar border = result.separation / 2;
  for (std::size_t i = 0; i < static_cast<std::size_t>(facing.face_1.size); ++i) {
    const auto& point = facing.face_1.points[i];
    facing.overlap.Add({point.x(), point.y(), point.z(), border});
  }
  return facing;
}

}  // namespace dgd
