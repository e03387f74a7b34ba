// The signed distance of two sets as long as a face of one of them holds the contact.
//
// A body that lies, slides or rocks on a face of another keeps that face's normal, step after step. Nothing needs to be
// searched then: the supporting planes along the normal bound the distance from below; and if the sets' faces, seen
// along it, overlap in a corner where the two surfaces are no farther apart than the planes, the distance is just that.
// The faces are what a contact patch is made from in any case (contact_patch.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dgd/assert.h"
#include "dgd/contact/facing_faces.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/signed_distance.h"
#include "dgd/types.h"

namespace dgd {

/// The set whose face is across the contact's normal.
enum class ReferenceSide : std::uint8_t { kNone, kSet1, kSet2 };

/// The same if the sets are named in the other order.
constexpr ReferenceSide Swapped(ReferenceSide side) {
  return side == ReferenceSide::kSet1   ? ReferenceSide::kSet2
         : side == ReferenceSide::kSet2 ? ReferenceSide::kSet1
                                        : ReferenceSide::kNone;
}

/// @param facing  With its overlap, along the normal of the signed distance.
template <class S>
ReferenceSide ReferenceSideOf(const FacingFaces<S>& facing) {
  return facing.is_across_1 ? ReferenceSide::kSet1 : facing.is_across_2 ? ReferenceSide::kSet2 : ReferenceSide::kNone;
}

/// The area vector of a face, twice the area long, that is turned by a matrix; square metres. Of its cofactors:
/// rotations in float are not quite orthogonal.
template <class S>
Vector3<S> TurnedArea(const Matrix3<S>& rotation, const SupportingFace<S>& face) {
  const auto x = rotation.col(0), y = rotation.col(1), z = rotation.col(2);
  const Vector3<S> area = face.Area();
  return area.x() * y.cross(z) + area.y() * z.cross(x) + area.z() * x.cross(y);
}

/// The signed distance from the face that held the contact last, if it still does.
/// @param settings           relative_tolerance is of the sets' inradii, for curved cores: polytopes end at roundoff
///                           error. separation_limit as UpdateDistance() has it.
/// @param angular_tolerance  Of FacingFaces::FindOverlap().
/// @param side             ReferenceSideOf() the last contact, not kNone.
/// @param state              In and out, as UpdateDistance() has it: its normal names the face. Left as it was if the
///                           face does not tell.
/// @param facing             Out: what the sets show each other along the normal, if the result is optimal.
/// @return kOptimal: the sets are apart, or overlap by less than their radii, and no normal separates them by more,
///         within the tolerance. kSeparated, with the normal and the separation along it. kStalled: the face does not
///         tell, and no other field is usable.
/// Allocates nothing and does not throw.
template <class Set1, class Set2>
DGD_FLATTEN SignedDistanceResult<typename Set1::Scalar> UpdateOnReferenceFace(
    const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
    const Settings<typename Set1::Scalar>& settings, typename Set1::Scalar angular_tolerance, ReferenceSide side,
    WarmStartOf<Set1>& state, FacingFaces<typename Set1::Scalar>& facing) {
  using S = typename Set1::Scalar;
  using Vector = Vector3<S>;
  SignedDistanceResult<S> result;
  result.status = Status::kStalled;
  facing.Clear();
  DGD_ASSERT(side != ReferenceSide::kNone && angular_tolerance > 0);
  // Support functions take finite directions.
  if (!std::isfinite(pose_1.rotation.sum() + pose_2.rotation.sum() + state.normal_1.sum())) return result;
  // The face on that side along the last normal, and the face's own normal: that has no roundoff of the steps
  // in between.
  const Vector last = pose_1.rotation * state.normal_1;
  Vector normal;
  if (side == ReferenceSide::kSet1) {
    set_1.core.SupportFace(state.normal_1, facing.face_1);
    normal = TurnedArea(pose_1.rotation, facing.face_1);
  } else {
    set_2.core.SupportFace(pose_2.rotation.transpose() * -last, facing.face_2);
    normal = TurnedArea(pose_2.rotation, facing.face_2);
  }
  const S area = normal.norm();
  if (!(area > 0 && std::isfinite(area))) return result;
  normal *= std::copysign(1 / area, normal.dot(last));

  const Vector normal_1 = pose_1.rotation.transpose() * normal, normal_2 = pose_2.rotation.transpose() * -normal;
  const Vector support_1 = set_1.core.Support(normal_1).point, support_2 = set_2.core.Support(normal_2).point;
  const Vector between = pose_2.translation - pose_1.translation;
  const S radius = set_1.radius + set_2.radius;
  const S separation = normal.dot(between) - normal_1.dot(support_1) - normal_2.dot(support_2) - radius;
  // What is left of points that were turned and moved twice.
  constexpr S kUnits = 16;
  const S roundoff = kUnits * kEpsilon<S> *
                     std::max({support_1.cwiseAbs().maxCoeff(), support_2.cwiseAbs().maxCoeff(), between.norm()});
  const S inradii = set_1.core.Inradius() + set_2.core.Inradius() + radius;
  const S tolerance = MinkowskiDifference<Set1, Set2>::kIsPolytope
                          ? roundoff
                          : std::max(roundoff, settings.relative_tolerance * inradii);
  if (!(separation + radius > tolerance && std::isfinite(separation))) return result;  // Also for NaN.

  const bool is_separated = separation > settings.separation_limit;
  if (!is_separated) {
    facing.frame = PatchFrame<S>(normal, pose_1.translation);
    if (side == ReferenceSide::kSet1) {
      MoveFace(set_1, pose_1, normal, facing.frame, facing.face_1);
      FindFace(set_2, pose_2, Vector(-normal), facing.frame, facing.face_2);
    } else {
      FindFace(set_1, pose_1, normal, facing.frame, facing.face_1);
      MoveFace(set_2, pose_2, Vector(-normal), facing.frame, facing.face_2);
    }
    facing.FindOverlap(angular_tolerance);
    const Corner<S>* nearest = facing.Nearest();
    if (nearest == nullptr || !(nearest->Separation() <= separation + tolerance)) return result;
    result.upper_bound = std::max(separation, nearest->Separation());
    result.witness_1 = facing.frame.ToWorld({nearest->x, nearest->y, nearest->height_1});
    result.witness_2 = result.witness_1 + separation * normal;
  }
  result.status = is_separated ? Status::kSeparated : Status::kOptimal;
  result.iterations = 1;
  result.normal = normal;
  result.separation = separation;
  state.normal_1 = normal_1.normalized();
  if (is_separated) state.size = 0;
  return result;
}

}  // namespace dgd
