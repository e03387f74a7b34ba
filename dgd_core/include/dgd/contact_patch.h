// The contact patch: the points in which two posed sets face each other along a certified normal.
//
// Seen along the normal, both supporting faces are convex polygons, segments or points, and their heights are affine.
// The patch is the overlap of the two; over each of its corners the distance of the two surfaces is exact, so no point
// claims more overlap than there is. An angular tolerance hardly matters: where faces are tilted against each other,
// the far corners are simply apart by more than the contact distance and fall away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dgd/growth_distance.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/supporting_face.h"
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
  /// Least distance of two points across the normal; metres, >= 0.
  S spacing = 0;
  /// A corner that is as deep as the witness within this stands for it, and the first of corners within a hundredth of
  /// this counts as the deepest; metres, >= 0. For simulations: four corners serve the solver of the constraints better
  /// than a point in their middle, and the last digits must not choose others in every step.
  S equal_depth = 0;
  /// Faces turned away from the normal by more than this count as edges, radians, in (0, pi / 2): seen from aside,
  /// their heights lose their digits.
  S angular_tolerance = S(1.47);
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

/// A corner seen along the normal: x, y across it, and the height of either surface on it.
template <class S>
struct Corner {
  S x, y, height_1, height_2;

  S Separation() const { return height_2 - height_1; }
};

/// A list of corners that never overflows: a convex polygon of kMaxPoints corners, cut by as many lines, gains at most
/// one corner by each.
template <class S>
struct CornerList {
  static constexpr std::size_t kCapacity = 2 * SupportingFace<S>::kMaxPoints + 1;  // One more for the witness.

  std::array<Corner<S>, kCapacity> corners;
  int size = 0;

  void Add(const Corner<S>& corner) { corners[static_cast<std::size_t>(size++)] = corner; }
  const Corner<S>& operator[](int i) const { return corners[static_cast<std::size_t>(i)]; }
  Corner<S>& operator[](int i) { return corners[static_cast<std::size_t>(i)]; }
};

/// A face seen along the normal.
template <class S>
class ProjectedFace {
 public:
  /// @param min_cosine  Of the angle between the polygon's normal and the contact's; below it, the face is an edge.
  ProjectedFace(const SupportingFace<S>& face, S min_cosine) : face_(face) {
    for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(face.size); ++i) {
      area_ += (face.points[i] - face.points[0]).cross(face.points[i + 1] - face.points[0]);
    }
    is_polygon_ = face.size > 2 && area_.z() * area_.z() > min_cosine * min_cosine * area_.squaredNorm();
    if (!is_polygon_) return;
    slope_x_ = -area_.x() / area_.z();
    slope_y_ = -area_.y() / area_.z();
  }

  const SupportingFace<S>& Face() const { return face_; }
  bool IsPolygon() const { return is_polygon_; }
  bool IsSegment() const { return face_.size == 2; }
  /// +1 if the polygon runs counterclockwise seen along the normal, else -1.
  S Orientation() const { return area_.z() > 0 ? S(1) : S(-1); }
  /// The height of the polygon's plane over (x, y).
  S Height(S x, S y) const {
    const Vector3<S>& origin = face_.points[0];
    return origin.z() + slope_x_ * (x - origin.x()) + slope_y_ * (y - origin.y());
  }

 private:
  const SupportingFace<S>& face_;
  Vector3<S> area_ = Vector3<S>::Zero();  // Newell's normal, twice the area long.
  S slope_x_ = 0, slope_y_ = 0;
  bool is_polygon_ = false;
};

/// Keeps the part of `subject` (polygon or segment) on the inner side of the line from a to b (Sutherland-Hodgman).
/// @param orientation  +1 if the clipping polygon runs counterclockwise, -1 if clockwise.
/// @return false, and `clipped` is left as it was, if that is all of it.
template <class S>
bool ClipByLine(const Vector3<S>& a, const Vector3<S>& b, S orientation, const CornerList<S>& subject,
                CornerList<S>& clipped) {
  const S dx = orientation * (b.x() - a.x()), dy = orientation * (b.y() - a.y());
  std::array<S, CornerList<S>::kCapacity> sides;
  bool all_inside = true;
  for (int i = 0; i < subject.size; ++i) {
    const S side = dx * (subject[i].y - a.y()) - dy * (subject[i].x - a.x());
    sides[static_cast<std::size_t>(i)] = side;
    all_inside = all_inside && side >= 0;
  }
  if (all_inside) return false;

  clipped.size = 0;
  const bool closed = subject.size > 2;
  for (int i = 0; i < subject.size; ++i) {
    const S side_from = sides[static_cast<std::size_t>(i)];
    if (side_from >= 0) clipped.Add(subject[i]);
    if (!closed && i + 1 == subject.size) break;
    const int next = i + 1 < subject.size ? i + 1 : 0;
    const S side_to = sides[static_cast<std::size_t>(next)];
    if ((side_from > 0 && side_to < 0) || (side_from < 0 && side_to > 0)) {
      const Corner<S>& from = subject[i];
      const Corner<S>& to = subject[next];
      const S t = side_from / (side_from - side_to);
      clipped.Add({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                   from.height_1 + t * (to.height_1 - from.height_1),
                   from.height_2 + t * (to.height_2 - from.height_2)});
    }
  }
  return true;
}

/// The overlap of a face (polygon or segment) with a polygon. `subject_is_1` tells whose heights the subject carries;
/// the other ones come from the polygon's plane.
template <class S>
void ClipByPolygon(const ProjectedFace<S>& subject, bool subject_is_1, const ProjectedFace<S>& polygon,
                   CornerList<S>& overlap) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(subject.Face().size); ++i) {
    const Vector3<S>& point = subject.Face().points[i];
    const S other = polygon.Height(point.x(), point.y());
    overlap.Add({point.x(), point.y(), subject_is_1 ? point.z() : other, subject_is_1 ? other : point.z()});
  }
  const int lines = polygon.Face().size;
  CornerList<S> buffer;
  CornerList<S>* current = &overlap;
  CornerList<S>* next = &buffer;
  for (int i = 0; i < lines && current->size > 0; ++i) {
    const auto from = static_cast<std::size_t>(i), to = static_cast<std::size_t>(i + 1 < lines ? i + 1 : 0);
    if (ClipByLine(polygon.Face().points[from], polygon.Face().points[to], polygon.Orientation(), *current, *next)) {
      std::swap(current, next);
    }
  }
  if (current == &overlap) return;
  overlap.size = 0;
  for (int i = 0; i < current->size; ++i) overlap.Add((*current)[i]);
}

/// The common part of two nearly parallel segments: its two ends, half way between the surfaces there.
template <class S>
void OverlapSegments(const SupportingFace<S>& segment_1, const SupportingFace<S>& segment_2, CornerList<S>& overlap) {
  // Beyond about 3 degrees two edges touch in a point, which the witness is.
  constexpr S kMaxSine = S(0.05);
  const Vector3<S>& a1 = segment_1.points[0];
  const Vector3<S>& a2 = segment_2.points[0];
  const Vector3<S> d1 = segment_1.points[1] - a1;
  const Vector3<S> d2 = segment_2.points[1] - a2;
  const S length_1 = std::hypot(d1.x(), d1.y()), length_2 = std::hypot(d2.x(), d2.y());
  if (!(std::abs(d1.x() * d2.y() - d1.y() * d2.x()) < kMaxSine * length_1 * length_2)) return;
  // Parameters on segment 1 (times its length) of the ends of segment 2.
  const S ux = d1.x() / length_1, uy = d1.y() / length_1;
  const S begin_2 = (a2.x() - a1.x()) * ux + (a2.y() - a1.y()) * uy;
  const S extent_2 = d2.x() * ux + d2.y() * uy;
  const S low = std::max(S(0), std::min(begin_2, begin_2 + extent_2));
  const S high = std::min(length_1, std::max(begin_2, begin_2 + extent_2));
  if (!(low < high)) return;
  const S radii = segment_1.radius + segment_2.radius;
  for (const S at : {low, high}) {
    // The surfaces' lines, and the axes that they curve about.
    const Vector3<S> line_1 = a1 + at / length_1 * d1;
    const Vector3<S> line_2 = a2 + (at - begin_2) / extent_2 * d2;
    const Vector3<S> axis_1 = line_1 - Vector3<S>(0, 0, segment_1.radius);
    const Vector3<S> axis_2 = line_2 + Vector3<S>(0, 0, segment_2.radius);
    const Vector3<S> across = axis_2 - axis_1;
    // Beside each other, curved surfaces part: their distance there, not the one of the lines along the normal.
    const bool faces = across.z() > 0;
    const S distance = faces ? across.norm() - radii : line_2.z() - line_1.z();
    const Vector3<S> outwards = faces ? Vector3<S>(across / across.norm()) : Vector3<S>(Vector3<S>::UnitZ());
    const Vector3<S> middle = axis_1 + (segment_1.radius + distance / 2) * outwards;
    overlap.Add({middle.x(), middle.y(), middle.z() - distance / 2, middle.z() + distance / 2});
  }
}

/// The witness: half way between the two witness points, which is the frame's origin; or over the only point that a set
/// has there. A sphere is touched on the line through its centre: elsewhere, a contact would spin it.
template <class S>
Corner<S> WitnessCorner(const SupportingFace<S>& face_1, const SupportingFace<S>& face_2, S separation) {
  if (face_1.size == 1) {
    const Vector3<S>& point = face_1.points[0];
    return {point.x(), point.y(), point.z(), point.z() + separation};
  }
  if (face_2.size == 1) {
    const Vector3<S>& point = face_2.points[0];
    return {point.x(), point.y(), point.z() - separation, point.z()};
  }
  return {0, 0, -separation / 2, separation / 2};
}

/// Keeps up to `max_points` corners that span the patch: the deepest (of equals the first), the farthest from it, and
/// one on either side of the line between the two that spans most area. Corners nearer than `spacing` to a kept one are
/// left out.
template <class S>
void Reduce(const CornerList<S>& corners, const PatchSettings<S>& settings, CornerList<S>& kept) {
  const S spacing = settings.spacing;
  const auto distance_sq = [](const Corner<S>& a, const Corner<S>& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  };
  int deepest = 0;
  for (int i = 1; i < corners.size; ++i) {
    if (corners[i].Separation() < corners[deepest].Separation()) deepest = i;
  }
  // Another corner brings other three. Much deeper ones must be chosen: with a tenth of the tolerance in the place of a
  // hundredth, towers sway and piles creep (demos/contact_report).
  const S as_deep = corners[deepest].Separation() + settings.equal_depth / 100;
  for (deepest = 0; !(corners[deepest].Separation() <= as_deep);) ++deepest;
  kept.Add(corners[deepest]);
  if (settings.max_points == 1) return;

  int farthest = deepest;
  for (int i = 0; i < corners.size; ++i) {
    if (distance_sq(corners[i], kept[0]) > distance_sq(corners[farthest], kept[0])) farthest = i;
  }
  if (!(distance_sq(corners[farthest], kept[0]) > spacing * spacing)) return;
  kept.Add(corners[farthest]);

  const S dx = kept[1].x - kept[0].x, dy = kept[1].y - kept[0].y;
  for (const S side : {S(1), S(-1)}) {
    int widest = -1;
    S most_area = 0;
    for (int i = 0; i < corners.size; ++i) {
      const S area = side * (dx * (corners[i].y - kept[0].y) - dy * (corners[i].x - kept[0].x));
      if (area > most_area) {
        most_area = area;
        widest = i;
      }
    }
    if (widest < 0 || kept.size == settings.max_points) continue;
    bool apart = true;
    for (int i = 0; i < kept.size; ++i) apart = apart && distance_sq(corners[widest], kept[i]) > spacing * spacing;
    if (apart) kept.Add(corners[widest]);
  }
}

}  // namespace contact_patch_internal

/// The frame in which a patch is found: the normal is its z axis, the middle between the witness points its origin.
template <class S>
struct PatchFrame {
  explicit PatchFrame(const Result<S>& result)
      : axes(FrameAlong<S>(result.normal)), origin((result.witness_1 + result.witness_2) / 2) {}

  Matrix3<S> axes;    ///< Patch frame to world.
  Vector3<S> origin;  ///< World, metres.
};

/// The supporting face of a posed set along a world direction, in the patch's frame and moved out by the set's radius.
template <class Set>
[[gnu::flatten]] SupportingFace<typename Set::Scalar> FindFace(const Set& set, const Pose<typename Set::Scalar>& pose,
                                                               const Vector3<typename Set::Scalar>& direction,
                                                               const PatchFrame<typename Set::Scalar>& frame) {
  using S = typename Set::Scalar;
  SupportingFace<S> face;
  set.core.SupportFace(pose.rotation.transpose() * direction, face);
  face.radius += set.radius;
  const Matrix3<S> rotation = frame.axes.transpose() * pose.rotation;
  const Vector3<S> translation = frame.axes.transpose() * (pose.translation + set.radius * direction - frame.origin);
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.size); ++i) {
    face.points[i] = rotation * face.points[i] + translation;
  }
  return face;
}

/// The patch of two sets along result.normal, from their supporting faces along it and against it. The witness point is
/// in it, or a point as deep.
/// @param result            Of GrowthDistance() for these sets and poses, or with the normal, separation and witness
///                          points of SignedDistance() in the place of its own. World, metres.
/// @param face_1, face_2    FindFace() of set 1 along the normal and of set 2 along its opposite.
/// @param settings          In range.
/// @param is_approaching    bool(const Vector3<S>& point, S separation): whether a point beyond the contact distance
///                          belongs to it too, e.g. because the sets move. World, half way between the surfaces,
///                          metres.
/// Does not allocate or throw, if `is_approaching` does not.
template <class S, class IsApproaching>
[[gnu::flatten]] ContactPatch<S> FindContactPatch(const Result<S>& result, const PatchFrame<S>& frame,
                                                  const SupportingFace<S>& face_1, const SupportingFace<S>& face_2,
                                                  const PatchSettings<S>& settings,
                                                  const IsApproaching& is_approaching) {
  using namespace contact_patch_internal;
  const S min_cosine = std::cos(settings.angular_tolerance);
  const ProjectedFace<S> projected_1(face_1, min_cosine), projected_2(face_2, min_cosine);
  CornerList<S> overlap;
  if (projected_1.IsPolygon() && (projected_2.IsPolygon() || projected_2.IsSegment())) {
    ClipByPolygon(projected_2, false, projected_1, overlap);
  } else if (projected_2.IsPolygon() && projected_1.IsSegment()) {
    ClipByPolygon(projected_1, true, projected_2, overlap);
  } else if (projected_1.IsSegment() && projected_2.IsSegment()) {
    OverlapSegments(face_1, face_2, overlap);
  }

  // The witness, unless a corner is as deep: for polytopes one usually is.
  const S as_deep = result.separation + settings.equal_depth;
  CornerList<S> near;
  bool witness_needed = true;
  const auto add_if_kept = [&](const Corner<S>& corner) {
    const auto in_world = [&] {
      return Vector3<S>(frame.origin +
                        frame.axes * Vector3<S>(corner.x, corner.y, (corner.height_1 + corner.height_2) / 2));
    };
    const S separation = corner.Separation();
    if (!(separation <= settings.contact_distance) && !is_approaching(in_world(), separation)) return;
    near.Add(corner);
    if (corner.Separation() <= as_deep) witness_needed = false;
  };
  for (int i = 0; i < overlap.size; ++i) add_if_kept(overlap[i]);
  if (witness_needed) add_if_kept(WitnessCorner(face_1, face_2, result.separation));
  if (near.size == 0) return {};

  CornerList<S> kept;
  Reduce(near, settings, kept);
  ContactPatch<S> patch;
  for (int i = 0; i < kept.size; ++i) {
    const Corner<S>& corner = kept[i];
    ContactPoint<S>& point = patch.points[static_cast<std::size_t>(patch.size++)];
    point.on_1 = frame.origin + frame.axes * Vector3<S>(corner.x, corner.y, corner.height_1);
    point.separation = corner.Separation();
    point.on_2 = point.on_1 + point.separation * result.normal;
  }
  return patch;
}

}  // namespace dgd
