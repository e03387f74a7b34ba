// The contact patch: the points in which two posed sets face each other along a certified normal.
//
// The patch is the overlap of the two supporting faces (facing_faces.h); over each of its corners the distance of the
// two surfaces is exact, so no point claims more overlap than there is. Where faces are tilted against each other, the
// far corners are apart by more than the contact distance and fall away.
#pragma once

#include <array>

#include "dgd/assert.h"
#include "dgd/contact/facing_faces.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/types.h"

namespace dgd {

/// One point of the patch: two surface points above each other along the normal.
template <class S>
struct ContactPoint {
  Vector3<S> on_1;  ///< World, metres.
  Vector3<S> on_2;  ///< on_1 + separation * normal.
  S separation;     ///< Metres, negative for overlap.
};

/// What belongs to a patch.
template <class S>
struct PatchSettings {
  /// Points not farther apart than this; metres.
  S contact_distance = 0;
  /// Least distance of two points across the normal, of a line's ends a thousandth of this; metres, >= 0. A foot that
  /// is smaller is one point: by several the few iterations of a solver with warm starts make it rock until it falls.
  S spacing = 0;
  /// A corner that is as deep as the witness within this stands for it, and the first of corners within a hundredth of
  /// this counts as the deepest; metres, >= 0. For simulations: four corners serve the solver of the constraints better
  /// than a point in their middle, and the last digits must not choose others in every step.
  S equal_depth = 0;
  /// 1 to ContactPatch::kMaxPoints.
  int max_points = 4;
};

/// Up to four points that span where two sets face each other.
template <class S>
struct ContactPatch {
  static constexpr int kMaxPoints = 4;

  std::array<ContactPoint<S>, kMaxPoints> points;  ///< The deepest first.
  int size = 0;
};

namespace contact_patch_internal {

/// The witness: half way between the two witness points; or over the only point that a set has there. A sphere is
/// touched on the line through its centre: elsewhere, a contact would spin it.
template <class S>
Corner<S> WitnessCorner(const Result<S>& result, const FacingFaces<S>& facing) {
  const S separation = result.separation;
  if (facing.face_1.size == 1) {
    const Vector3<S>& point = facing.face_1.points[0];
    return {point.x(), point.y(), point.z(), point.z() + separation};
  }
  if (facing.face_2.size == 1) {
    const Vector3<S>& point = facing.face_2.points[0];
    return {point.x(), point.y(), point.z() - separation, point.z()};
  }
  const Vector3<S> middle = facing.frame.FromWorld((result.witness_1 + result.witness_2) / 2);
  return {middle.x(), middle.y(), middle.z() - separation / 2, middle.z() + separation / 2};
}

/// Keeps up to `max_points` corners that span the patch: the deepest (of equals the first), the farthest from it, and
/// one on either side of the line between the two that spans most area. Corners nearer than `spacing` to a kept one are
/// left out.
template <class S>
void Reduce(const CornerList<S>& corners, const PatchSettings<S>& settings, CornerList<S>& kept) {
  DGD_ASSERT(corners.size > 0 && kept.size == 0);
  DGD_ASSERT(settings.max_points >= 1 && settings.max_points <= ContactPatch<S>::kMaxPoints && settings.spacing >= 0);
  constexpr S kLineEndsPart = S(1e-3);  // Nearer to each other they are one place, but for roundoff.
  const S spacing = (corners.size == 2 ? kLineEndsPart : 1) * settings.spacing, spacing_sq = spacing * spacing;
  const auto distance_sq = [](const Corner<S>& a, const Corner<S>& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  };
  int deepest = 0;
  for (int i = 1; i < corners.size; ++i) {
    if (corners[i].Separation() < corners[deepest].Separation()) deepest = i;
  }
  // Another corner brings other three. Much deeper ones must be chosen: with a tenth of the tolerance in the place of a
  // hundredth, towers sway and piles creep (scenes/studies/contacts.json).
  const S as_deep = corners[deepest].Separation() + settings.equal_depth / 100;
  // None is where the depth is not finite.
  int first = 0;
  while (first < deepest && !(corners[first].Separation() <= as_deep)) ++first;
  deepest = first;
  kept.Add(corners[deepest]);
  if (settings.max_points == 1) return;

  int farthest = deepest;
  S farthest_sq = 0;
  for (int i = 0; i < corners.size; ++i) {
    const S away_sq = distance_sq(corners[i], kept[0]);
    if (!(away_sq > farthest_sq)) continue;
    farthest_sq = away_sq;
    farthest = i;
  }
  if (!(farthest_sq > spacing_sq)) return;
  kept.Add(corners[farthest]);

  const S dx = kept[1].x - kept[0].x, dy = kept[1].y - kept[0].y;
  int left = -1, right = -1;
  S most_left = 0, most_right = 0;  // Twice the area that is spanned.
  for (int i = 0; i < corners.size; ++i) {
    const S area = dx * (corners[i].y - kept[0].y) - dy * (corners[i].x - kept[0].x);
    if (area > most_left) {
      most_left = area;
      left = i;
    }
    if (area < most_right) {
      most_right = area;
      right = i;
    }
  }
  for (const int widest : {left, right}) {
    if (widest < 0 || kept.size == settings.max_points) continue;
    bool apart = true;
    for (int i = 0; i < kept.size; ++i) apart &= distance_sq(corners[widest], kept[i]) > spacing_sq;
    if (apart) kept.Add(corners[widest]);
  }
}

}  // namespace contact_patch_internal

/// The patch of two sets along result.normal, from what they show each other there. The witness point is in it, or a
/// point as deep.
/// @param result            Of GrowthDistance() for these sets and poses, or with the normal, separation and witness
///                          points of SignedDistance() in the place of its own. World, metres.
/// @param facing            The faces of set 1 along the normal and of set 2 along its opposite, and their overlap.
/// @param settings          In range.
/// @param is_approaching    bool(const Vector3<S>& point, S separation): whether a point beyond the contact distance
///                          belongs to it too, e.g. because the sets move. World, half way between the surfaces,
///                          metres.
/// Does not allocate or throw, if `is_approaching` does not.
template <class S, class IsApproaching>
DGD_FLATTEN ContactPatch<S> FindContactPatch(const Result<S>& result, const FacingFaces<S>& facing,
                                             const PatchSettings<S>& settings, const IsApproaching& is_approaching) {
  using namespace contact_patch_internal;
  // The witness, unless a corner is as deep: for polytopes one usually is.
  const S as_deep = result.separation + settings.equal_depth;
  CornerList<S> near;
  bool witness_needed = true;
  const auto add_if_kept = [&](const Corner<S>& corner) {
    const auto in_world = [&] {
      return facing.frame.ToWorld({corner.x, corner.y, (corner.height_1 + corner.height_2) / 2});
    };
    const S separation = corner.Separation();
    if (!(separation <= settings.contact_distance) && !is_approaching(in_world(), separation)) return;
    near.Add(corner);
    if (corner.Separation() <= as_deep) witness_needed = false;
  };
  for (int i = 0; i < facing.overlap.size; ++i) add_if_kept(facing.overlap[i]);
  if (witness_needed) add_if_kept(WitnessCorner(result, facing));
  if (near.size == 0) return {};

  CornerList<S> kept;
  Reduce(near, settings, kept);
  ContactPatch<S> patch;
  DGD_ASSERT(kept.size <= ContactPatch<S>::kMaxPoints);
  for (int i = 0; i < kept.size; ++i) {
    const Corner<S>& corner = kept[i];
    ContactPoint<S>& point = patch.points[static_cast<std::size_t>(patch.size++)];
    point.on_1 = facing.frame.ToWorld({corner.x, corner.y, corner.height_1});
    point.separation = corner.Separation();
    point.on_2 = point.on_1 + point.separation * result.normal;
  }
  return patch;
}

}  // namespace dgd
