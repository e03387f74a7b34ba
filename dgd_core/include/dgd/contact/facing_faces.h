// What two posed sets show each other along a normal: their supporting faces, and the overlap of these.
//
// Seen along the normal, supporting faces are convex polygons, segments or points, and their heights are affine: over
// each corner of the overlap the distance of the two surfaces is exact. So that is where contact points are chosen from
// (contact_patch.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dgd/assert.h"
#include "dgd/contact/supporting_face.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/minkowski_difference.h"
#include "dgd/types.h"

namespace dgd {

/// The frame in which faces are seen: the normal is its z axis.
template <class S>
struct PatchFrame {
  PatchFrame() = default;  ///< Not set.
  PatchFrame(const Vector3<S>& normal, const Vector3<S>& origin_in_world)
      : axes(FrameAlong<S>(normal)), origin(origin_in_world) {}
  /// The middle between the witness points is its origin.
  explicit PatchFrame(const Result<S>& result)
      : PatchFrame(result.normal, Vector3<S>((result.witness_1 + result.witness_2) / 2)) {}

  Vector3<S> ToWorld(const Vector3<S>& point) const { return origin + axes * point; }
  Vector3<S> FromWorld(const Vector3<S>& point) const { return axes.transpose() * (point - origin); }

  Matrix3<S> axes;    ///< Patch frame to world.
  Vector3<S> origin;  ///< World, metres.
};

/// The supporting face of a posed set along a world direction, in the patch's frame and moved out by the set's radius.
/// Not inlined: it is the same for all that a set may meet.
/// @param face  Out; empty before.
template <class Set>
DGD_FLATTEN DGD_NOINLINE void FindFace(const Set& set, const Pose<typename Set::Scalar>& pose,
                                       const Vector3<typename Set::Scalar>& direction,
                                       const PatchFrame<typename Set::Scalar>& frame,
                                       SupportingFace<typename Set::Scalar>& face) {
  using S = typename Set::Scalar;
  set.core.SupportFace(pose.rotation.transpose() * direction, face);
  face.radius += set.radius;
  const Matrix3<S> rotation = frame.axes.transpose() * pose.rotation;
  const Vector3<S> translation = frame.axes.transpose() * (pose.translation + set.radius * direction - frame.origin);
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.size); ++i) {
    face.points[i] = rotation * face.points[i] + translation;
  }
}

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

  void Add(const Corner<S>& corner) {
    DGD_ASSERT(size >= 0 && size < static_cast<int>(kCapacity));
    corners[static_cast<std::size_t>(size++)] = corner;
  }
  const Corner<S>& operator[](int i) const {
    DGD_ASSERT(i >= 0 && i < size);
    return corners[static_cast<std::size_t>(i)];
  }
  Corner<S>& operator[](int i) {
    DGD_ASSERT(i >= 0 && i < size);
    return corners[static_cast<std::size_t>(i)];
  }
};

namespace facing_faces_internal {

/// Least cosine of a polygon's normal to the contact's. One that is turned away farther counts as its nearest edge:
/// seen from aside, its heights lose their digits.
constexpr double kMinCosine = 0.1;

/// A face seen along the normal.
template <class S>
class ProjectedFace {
 public:
  // cppcheck-suppress uninitMemberVar ; a reference, which is
  explicit ProjectedFace(const SupportingFace<S>& face) : face_(face), area_(face.Area()) {
    is_polygon_ = face.size > 2 && area_.z() * area_.z() > S(kMinCosine * kMinCosine) * area_.squaredNorm();
    if (!is_polygon_) return;
    slope_x_ = -area_.x() / area_.z();
    slope_y_ = -area_.y() / area_.z();
  }

  const SupportingFace<S>& Face() const { return face_; }
  bool IsPolygon() const { return is_polygon_; }
  bool IsSegment() const { return face_.size == 2; }
  /// Whether the polygon is across the normal, within roundoff.
  bool IsAcross() const {
    return is_polygon_ && std::max(std::abs(slope_x_), std::abs(slope_y_)) <= kLevel * kEpsilon<S>;
  }
  /// +1 if the polygon runs counterclockwise seen along the normal, else -1.
  S Orientation() const { return area_.z() > 0 ? S(1) : S(-1); }
  /// The height of the polygon's plane over (x, y).
  S Height(S x, S y) const {
    const Vector3<S>& origin = face_.points[0];
    return origin.z() + slope_x_ * (x - origin.x()) + slope_y_ * (y - origin.y());
  }

 private:
  /// A face's slope comes from points, and is off by their last digits over its size: up to 2e-10 in double, for faces
  /// of 1e-6 of the set. A millionfold of float's last digit would be a slope of 0.1; 64-fold is 8e-6.
  static constexpr S kLevel = sizeof(S) == 8 ? S(1e6) : S(64);

  const SupportingFace<S>& face_;
  Vector3<S> area_;
  S slope_x_ = 0, slope_y_ = 0;
  bool is_polygon_ = false;
};

/// Keeps the part of `subject` (polygon, segment or point) on the inner side of the line from a to b
/// (Sutherland-Hodgman).
/// @param orientation  +1 if the clipping polygon runs counterclockwise, -1 if clockwise.
/// @return false, and `clipped` is left as it was, if that is all of it.
template <class S>
bool ClipByLine(const Vector3<S>& a, const Vector3<S>& b, S orientation, const CornerList<S>& subject,
                CornerList<S>& clipped) {
  const S dx = orientation * (b.x() - a.x()), dy = orientation * (b.y() - a.y());
  // Distances from the line in any unit; not negative inside.
  std::array<S, CornerList<S>::kCapacity> sides;
  bool is_inside = true;
  for (int i = 0; i < subject.size; ++i) {
    const S side = dx * (subject[i].y - a.y()) - dy * (subject[i].x - a.x());
    sides[static_cast<std::size_t>(i)] = side;
    is_inside &= side >= 0;  // There is no branch for each.
  }
  if (is_inside) return false;
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

/// The overlap of a face (polygon, segment or point) with a polygon. The subject carries set 1's heights if
/// `subject_is_1`, else set 2's; the other ones come from the polygon's plane.
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

/// Leaves the edge of a face that is nearest to the other set: its two highest corners, which are neighbours in a
/// convex polygon.
/// @param towards  1 if the other set is up the frame's z axis, -1 if down.
template <class S>
void KeepNearestEdge(S towards, SupportingFace<S>& face) {
  if (face.size <= 2) return;
  std::partial_sort(face.points.begin(), face.points.begin() + 2, face.points.begin() + face.size,
                    [towards](const auto& a, const auto& b) { return towards * a.z() > towards * b.z(); });
  face.size = 2;
}

}  // namespace facing_faces_internal

/// Two sets' faces along a normal: of set 1 along it, of set 2 against it, and where they overlap.
template <class S>
struct FacingFaces {
  /// Leaves neither faces nor an overlap.
  void Clear() {
    for (SupportingFace<S>* face : {&face_1, &face_2}) {
      face->size = 0;
      face->radius = 0;
    }
    overlap.size = 0;
  }

  /// Finds the overlap of the two faces, once both are there. Not inlined: it is long, and the same for all sets.
  DGD_FLATTEN DGD_NOINLINE void FindOverlap() {
    DGD_ASSERT(overlap.size == 0);
    using namespace facing_faces_internal;
    const ProjectedFace<S> projected_1(face_1), projected_2(face_2);
    if (!projected_1.IsPolygon()) KeepNearestEdge(S(1), face_1);
    if (!projected_2.IsPolygon()) KeepNearestEdge(S(-1), face_2);
    is_across_1 = projected_1.IsAcross();
    is_across_2 = projected_2.IsAcross();
    if (projected_1.IsPolygon()) {
      ClipByPolygon(projected_2, false, projected_1, overlap);
    } else if (projected_2.IsPolygon()) {
      ClipByPolygon(projected_1, true, projected_2, overlap);
    } else if (projected_1.IsSegment() && projected_2.IsSegment()) {
      OverlapSegments(face_1, face_2, overlap);
    }
  }

  /// The corner where the surfaces are nearest to each other, or overlap most; nullptr without an overlap.
  const Corner<S>* Nearest() const {
    const Corner<S>* nearest = nullptr;
    for (int i = 0; i < overlap.size; ++i) {
      if (nearest == nullptr || overlap[i].Separation() < nearest->Separation()) nearest = &overlap[i];
    }
    return nearest;
  }

  PatchFrame<S> frame;
  SupportingFace<S> face_1, face_2;  ///< Faces of FindFace().
  CornerList<S> overlap;  ///< Its corners in any order; none of segments that cross, or of faces next to each other.
  bool is_across_1 = false, is_across_2 = false;  ///< Whether a face is a polygon across the normal, within roundoff.
};

/// What two sets show each other along a result's normal, as FindContactPatch() takes it.
/// @param result  Its normal and witness points count; world, metres.
template <class Set1, class Set2>
FacingFaces<typename Set1::Scalar> FindFacingFaces(const Set1& set_1, const Pose<typename Set1::Scalar>& pose_1,
                                                   const Set2& set_2, const Pose<typename Set1::Scalar>& pose_2,
                                                   const Result<typename Set1::Scalar>& result) {
  using S = typename Set1::Scalar;
  FacingFaces<S> facing;
  facing.frame = PatchFrame<S>(result);
  FindFace(set_1, pose_1, result.normal, facing.frame, facing.face_1);
  FindFace(set_2, pose_2, Vector3<S>(-result.normal), facing.frame, facing.face_2);
  facing.FindOverlap();
  return facing;
}

}  // namespace dgd
