// The signed distance of two boxes whose cores are apart, and what they show each other there: without a search.
//
// Of two boxes, the one best of fifteen directions is known: across a face of either, or across an edge of each (the
// separating axes). The separation along any is a lower bound of the distance. It is proven by the two surfaces: where
// one box's lowest corner is above a face of the other, or where two edges pass each other between their ends. Else
// corners are nearest to corners or to edges, and that is FollowDistance()'s. Most often what held the last contact
// still does, or what is beside it, and nothing else is looked at.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/facing_faces.h"
#include "dgd/held_face.h"
#include "dgd/query_types.h"
#include "dgd/rectangle_overlap.h"
#include "dgd/shapes/box.h"
#include "dgd/signed_distance.h"

namespace dgd {

namespace boxes_apart_internal {

constexpr int Next(int axis) { return axis == 2 ? 0 : axis + 1; }
constexpr int Previous(int axis) { return axis == 0 ? 2 : axis - 1; }

/// A face of the holder, by the axis that it is across.
struct BoxFace {
  FaceHolder holder;
  int axis;

  bool operator==(const BoxFace&) const = default;
};

/// An edge of each box, by the axes that they are along.
struct BoxEdges {
  int axis_1, axis_2;
};

/// Two boxes; all lengths in metres, all vectors the world's. Rotations in float are not quite orthogonal: what is
/// proven here is proven of the very points that the support functions give, so normals are cross products.
/// What is called from several places is not inlined in each: FollowBoxes() would be 54 KB then, and a heap's pairs,
/// which go this way and that, would find the processor's cache of instructions filled by each other's copies. By
/// measurement, the narrowphase of 3000 boxes takes 2 to 5 % less time.
template <class S>
class BoxPair {
 public:
  BoxPair(const RoundedSet<Box<S>>& box_1, const Pose<S>& pose_1, const RoundedSet<Box<S>>& box_2,
          const Pose<S>& pose_2, const Settings<S>& settings, S angular_tolerance)
      : box_1_{pose_1.rotation, box_1.core.HalfExtents(), pose_1.translation, box_1.radius},
        box_2_{pose_2.rotation, box_2.core.HalfExtents(), pose_2.translation, box_2.radius},
        between_(pose_2.translation - pose_1.translation),
        radii_(box_1.radius + box_2.radius),
        separation_limit_(settings.separation_limit),
        angular_tolerance_(angular_tolerance) {
    // What is left of points that were turned and moved twice.
    constexpr S kUnits = 16;
    tolerance_ = kUnits * kEpsilon<S> * std::max({box_1_.half.maxCoeff(), box_2_.half.maxCoeff(), between_.norm()});
  }

  /// The holder's face that looks along a normal.
  /// @param normal_1  From box 1 to box 2, in the frame of box 1.
  BoxFace FaceAlong(FaceHolder holder, const Vector3<S>& normal_1) const {
    BoxFace face{holder, 0};
    const Vector3<S> normal =
        holder == FaceHolder::kSet1 ? normal_1 : Vector3<S>(box_2_.axes.transpose() * (box_1_.axes * normal_1));
    normal.cwiseAbs().maxCoeff(&face.axis);
    return face;
  }

  /// The face across which the boxes are farthest apart, but for the rounding of their rotations.
  BoxFace BestFace() const {
    const Matrix3<S> dots = (box_1_.axes.transpose() * box_2_.axes).cwiseAbs();
    const Vector3<S> apart_1 = (box_1_.axes.transpose() * between_).cwiseAbs() - box_1_.half - dots * box_2_.half;
    const Vector3<S> apart_2 =
        (box_2_.axes.transpose() * between_).cwiseAbs() - box_2_.half - dots.transpose() * box_1_.half;
    int axis_1 = 0, axis_2 = 0;
    const S best_1 = apart_1.maxCoeff(&axis_1), best_2 = apart_2.maxCoeff(&axis_2);
    return best_1 >= best_2 ? BoxFace{FaceHolder::kSet1, axis_1} : BoxFace{FaceHolder::kSet2, axis_2};
  }

  /// The edges along which the boxes are farthest apart. By triple products: each separation times the length of the
  /// edges' cross product.
  BoxEdges BestEdges() const {
    Matrix3<S> moments;
    for (int axis = 0; axis < 3; ++axis) moments.col(axis) = between_.cross(box_1_.axes.col(axis));
    const Matrix3<S> centers = (moments.transpose() * box_2_.axes).cwiseAbs();
    const Matrix3<S> across_1 = (Areas(box_1_.axes).transpose() * box_2_.axes).cwiseAbs();
    const Matrix3<S> across_2 = (box_1_.axes.transpose() * Areas(box_2_.axes)).cwiseAbs();
    const Matrix3<S> cosines = box_1_.axes.transpose() * box_2_.axes;
    BoxEdges best{0, 0};
    S most = 0, length_sq_of_most = 1;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const S apart = centers(i, j) - box_1_.half[Next(i)] * across_1(Previous(i), j) -
                        box_1_.half[Previous(i)] * across_1(Next(i), j) -
                        box_2_.half[Next(j)] * across_2(i, Previous(j)) -
                        box_2_.half[Previous(j)] * across_2(i, Next(j));
        const S length_sq = 1 - cosines(i, j) * cosines(i, j);
        if (!(apart > 0 && apart * apart * length_sq_of_most > most * most * length_sq)) continue;
        most = apart;
        length_sq_of_most = length_sq;
        best = {i, j};
      }
    }
    return best;
  }

  /// The distance across a face, if it is that.
  /// @param beside  Out, if it is not: edges that may pass each other where the lowest corner is beside the face.
  /// @return kOptimal with facing, kSeparated, or kStalled.
  [[gnu::flatten, gnu::noinline]] Status TryFace(const BoxFace& face, FacingFaces<S>& facing,
                                                 SignedDistanceResult<S>& result,
                                                 std::optional<BoxEdges>& beside) const {
    DGD_ASSERT(face.holder != FaceHolder::kNone && face.axis >= 0 && face.axis < 3);
    const bool is_1 = face.holder == FaceHolder::kSet1;
    const Placed &holder = is_1 ? box_1_ : box_2_, &other = is_1 ? box_2_ : box_1_;
    const int axis_u = Next(face.axis), axis_v = Previous(face.axis);
    const Vector3<S> side_u = holder.axes.col(axis_u), side_v = holder.axes.col(axis_v);
    const Vector3<S> area = side_u.cross(side_v), to_other = is_1 ? between_ : Vector3<S>(-between_);
    const S area_sq = area.squaredNorm();
    const Vector3<S> outwards = area / std::copysign(std::sqrt(area_sq), area.dot(to_other));
    const Vector3<S> to_center = to_other - MiddleOfFace(holder, face.axis, outwards);
    const Vector3<S> heights = (other.axes.transpose() * outwards).cwiseProduct(other.half);
    const S apart = outwards.dot(to_center) - heights.cwiseAbs().sum();
    if (!(apart > tolerance_ && std::isfinite(apart))) return Status::kStalled;
    result.normal = is_1 ? outwards : Vector3<S>(-outwards);
    result.separation = apart - radii_;
    if (result.separation > separation_limit_) return Status::kSeparated;

    Vector3<S> down;
    for (int axis = 0; axis < 3; ++axis) down[axis] = std::copysign(other.half[axis], -heights[axis]);
    const Vector3<S> lowest = to_center + other.axes * down;
    const Vector3<S> along_u = side_v.cross(area) / area_sq, along_v = area.cross(side_u) / area_sq;
    const S out_u = std::abs(along_u.dot(lowest)) - holder.half[axis_u];
    const S out_v = std::abs(along_v.dot(lowest)) - holder.half[axis_v];
    // Of level edges and faces, another part may be above the face.
    const bool is_level = (heights.cwiseAbs().array() <= tolerance_).any();
    if ((out_u > 0 || out_v > 0) && !is_level) {
      const int axis = out_u > out_v ? axis_v : axis_u;
      const int other_axis = EdgeInwards(out_u > out_v ? along_u : along_v, lowest, other, down, heights);
      beside = is_1 ? BoxEdges{axis, other_axis} : BoxEdges{other_axis, axis};
      return Status::kStalled;
    }
    FindOverlap(face, outwards, facing);
    const Corner<S>* nearest = facing.Nearest();
    if (nearest == nullptr || !(nearest->Separation() <= result.separation + tolerance_)) return Status::kStalled;
    facing.is_across_1 = is_1;
    facing.is_across_2 = !is_1;
    result.upper_bound = std::max(result.separation, nearest->Separation());
    result.witness_1 = facing.frame.ToWorld({nearest->x, nearest->y, nearest->height_1});
    result.witness_2 = result.witness_1 + result.separation * result.normal;
    return Status::kOptimal;
  }

  /// The distance across two edges, if it is that.
  /// @return as TryFace().
  [[gnu::flatten, gnu::noinline]] Status TryEdges(const BoxEdges& edges, FacingFaces<S>& facing,
                                                  SignedDistanceResult<S>& result) const {
    const Vector3<S> edge_1 = box_1_.axes.col(edges.axis_1), edge_2 = box_2_.axes.col(edges.axis_2);
    // The same product without the common part of edges that are nearly parallel, which would leave its last digits.
    const Vector3<S> across = edge_1.cross(Vector3<S>(edge_2 - std::copysign(S(1), edge_1.dot(edge_2)) * edge_1));
    const S across_sq = across.squaredNorm();
    const Vector3<S> normal = across / std::copysign(std::sqrt(across_sq), across.dot(between_));
    const Vector3<S> middle_1 = MiddleOfEdge(box_1_, edges.axis_1, normal);
    const Vector3<S> middle_2 = between_ + MiddleOfEdge(box_2_, edges.axis_2, Vector3<S>(-normal));
    const Vector3<S> way = middle_2 - middle_1;
    // Edges have ends, and the normal last digits.
    const S apart = normal.dot(way) - std::abs(normal.dot(edge_1)) * box_1_.half[edges.axis_1] -
                    std::abs(normal.dot(edge_2)) * box_2_.half[edges.axis_2];
    if (!(apart > tolerance_ && std::isfinite(apart))) return Status::kStalled;  // Also of parallel edges.
    // Where the two lines are nearest, between the edges' ends.
    const auto between_ends = [](S place, S half) { return std::clamp(place, -half, half); };
    const Vector3<S> nearest_1 =
        middle_1 + between_ends(way.cross(edge_2).dot(across) / across_sq, box_1_.half[edges.axis_1]) * edge_1;
    const Vector3<S> nearest_2 =
        middle_2 + between_ends(way.cross(edge_1).dot(across) / across_sq, box_2_.half[edges.axis_2]) * edge_2;
    const S nearest = (nearest_2 - nearest_1).norm();
    if (!(nearest <= apart + tolerance_)) return Status::kStalled;
    result.normal = normal;
    result.separation = apart - radii_;
    if (result.separation > separation_limit_) return Status::kSeparated;
    result.upper_bound = std::max(nearest, apart) - radii_;
    result.witness_1 = box_1_.origin + nearest_1 + box_1_.radius * normal;
    result.witness_2 = result.witness_1 + result.separation * normal;
    BoxFace face{FaceHolder::kSet1, 0};
    (box_1_.axes.transpose() * normal).cwiseAbs().maxCoeff(&face.axis);
    FindOverlap(face, normal, facing);
    return Status::kOptimal;
  }

 private:
  /// A box in its place.
  struct Placed {
    const Matrix3<S>& axes;
    const Vector3<S>& half;
    const Vector3<S>& origin;
    const S radius;
  };

  /// From the box's origin.
  static Vector3<S> MiddleOfFace(const Placed& box, int axis, const Vector3<S>& outwards) {
    return std::copysign(box.half[axis], outwards.dot(box.axes.col(axis))) * box.axes.col(axis);
  }

  /// From the box's origin; of the edge that is farthest along a normal across it.
  static Vector3<S> MiddleOfEdge(const Placed& box, int axis, const Vector3<S>& normal) {
    return MiddleOfFace(box, Next(axis), normal) + MiddleOfFace(box, Previous(axis), normal);
  }

  static Matrix3<S> Areas(const Matrix3<S>& axes) {
    Matrix3<S> areas;
    for (int axis = 0; axis < 3; ++axis) areas.col(axis) = axes.col(Next(axis)).cross(axes.col(Previous(axis)));
    return areas;
  }

  /// Of the edges that leave the lowest corner, the one that rises least on its way in.
  /// @param along  Coordinate in which the corner is out.
  static int EdgeInwards(const Vector3<S>& along, const Vector3<S>& lowest, const Placed& other, const Vector3<S>& down,
                         const Vector3<S>& heights) {
    const S inwards = -std::copysign(S(1), along.dot(lowest));
    int best = 0;
    S most = -std::numeric_limits<S>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const S way = -inwards * along.dot(other.axes.col(axis)) * down[axis];
      const S way_per_rise = way / std::abs(heights[axis]);
      if (!(way_per_rise > most)) continue;
      most = way_per_rise;
      best = axis;
    }
    return best;
  }

  /// Where the holder's face and the other box's overlap, seen along a normal: in coordinates along the face's sides,
  /// and heights along the normal, which need not be across them. Of the faces, only the holder's is put down.
  /// @param outwards  The normal, from the holder to the other box.
  [[gnu::flatten, gnu::noinline]] void FindOverlap(const BoxFace& face, const Vector3<S>& outwards,
                                                   FacingFaces<S>& facing) const {
    facing.overlap.size = 0;
    const bool is_1 = face.holder == FaceHolder::kSet1;
    const Placed &holder = is_1 ? box_1_ : box_2_, &other = is_1 ? box_2_ : box_1_;
    const Vector3<S> side_u = holder.axes.col(Next(face.axis)), side_v = holder.axes.col(Previous(face.axis));
    const Vector3<S> area = side_u.cross(side_v);
    const Vector3<S> cosines = other.axes.transpose() * outwards;
    int down = 0;
    const S cosine = area.dot(outwards), cosine_of_other = cosines.cwiseAbs().maxCoeff(&down);
    if (!AreFaces(std::abs(cosine), cosine_of_other)) return;

    const Vector3<S> middle = MiddleOfFace(holder, face.axis, outwards);
    Matrix3<S> to_plane;
    to_plane.row(0) = side_v.cross(outwards) / cosine;
    to_plane.row(1) = outwards.cross(side_u) / cosine;
    to_plane.row(2) = area / cosine;
    const Matrix3<S> edges = to_plane * other.axes * other.half.asDiagonal();
    const Vector3<S> to_other = is_1 ? between_ : Vector3<S>(-between_);
    const Vector3<S> above = to_plane * (to_other - middle) - std::copysign(S(1), cosines[down]) * edges.col(down);
    const Parallelogram<S> seen{above, edges.col(Next(down)), edges.col(Previous(down))};
    const RectangleOverlap<S> overlap =
        OverlapWithRectangle(seen, holder.half[Next(face.axis)], holder.half[Previous(face.axis)]);
    for (int i = 0; i < overlap.size; ++i) {
      const Vector3<S>& corner = overlap.corners[static_cast<std::size_t>(i)];
      const S height = corner.z() - radii_;
      facing.overlap.Add(is_1 ? Corner<S>{corner.x(), corner.y(), 0, height}
                              : Corner<S>{corner.x(), corner.y(), -height, 0});
    }

    SupportingFace<S>& holders = is_1 ? facing.face_1 : facing.face_2;
    holders.size = 0;
    const S half_u = holder.half[Next(face.axis)], half_v = holder.half[Previous(face.axis)];
    for (const auto& [u, v] : {std::pair{-half_u, -half_v}, {half_u, -half_v}, {half_u, half_v}, {-half_u, half_v}}) {
      holders.Add({u, v, 0});
    }
    facing.frame.axes.col(0) = side_u;
    facing.frame.axes.col(1) = side_v;
    facing.frame.axes.col(2) = is_1 ? outwards : Vector3<S>(-outwards);
    facing.frame.origin = holder.origin + middle + holder.radius * outwards;
  }

  /// Whether two faces seen at these angles count as faces, and not as edges.
  bool AreFaces(S cosine_1, S cosine_2) const {
    // A box's face nearest to a direction is never farther from it.
    constexpr S kFarthest = S(0.9553);  // acos(1 / sqrt(3))
    return angular_tolerance_ > kFarthest || std::min(cosine_1, cosine_2) > std::cos(angular_tolerance_);
  }

  const Placed box_1_, box_2_;
  const Vector3<S> between_;  // From box 1's origin to box 2's.
  const S radii_, separation_limit_, angular_tolerance_;
  S tolerance_;
};

/// Edges are remembered as FollowDistance() keeps a nearest simplex: by the corners at their ends.
template <class S>
std::optional<BoxEdges> LastEdges(const WarmStart<S>& state) {
  if (state.size != 2) return std::nullopt;
  const FeatureId bit_1 = state.features_1[0] ^ state.features_1[1], bit_2 = state.features_2[0] ^ state.features_2[1];
  constexpr FeatureId kAxes = 0b111;
  if (!std::has_single_bit(bit_1) || !std::has_single_bit(bit_2) || ((bit_1 | bit_2) & ~kAxes) != 0) {
    return std::nullopt;
  }
  return BoxEdges{std::countr_zero(bit_1), std::countr_zero(bit_2)};
}

template <class S>
void RememberEdge(const Box<S>& box, const Vector3<S>& normal, int axis, FeatureId& end, FeatureId& other_end) {
  end = box.Support(normal).feature;
  other_end = end ^ (FeatureId(1) << axis);
}

}  // namespace boxes_apart_internal

/// FollowFace() for two boxes, which need no contact before: all faces are tried, and all edges.
/// @param holder  May be kNone.
/// @param state   In and out, as there; is no more than a hint.
/// @param facing  Out: as there, with or without an overlap. A face whose normal the result's is counts as across it,
///                and no other.
template <class S>
[[gnu::flatten]] SignedDistanceResult<S> FollowBoxes(const RoundedSet<Box<S>>& box_1, const Pose<S>& pose_1,
                                                     const RoundedSet<Box<S>>& box_2, const Pose<S>& pose_2,
                                                     const Settings<S>& settings, S angular_tolerance,
                                                     FaceHolder holder, WarmStart<S>& state, FacingFaces<S>& facing) {
  using namespace boxes_apart_internal;
  const BoxPair<S> pair(box_1, pose_1, box_2, pose_2, settings, angular_tolerance);
  SignedDistanceResult<S> result;
  result.status = Status::kStalled;
  facing.Clear();
  std::optional<BoxFace> last_face;
  std::optional<BoxEdges> edges;
  // Each is tried if none before was it.
  const auto try_face = [&](const BoxFace& face) {
    edges.reset();
    result.status = pair.TryFace(face, facing, result, edges);
  };
  const auto try_edges = [&] {
    if (result.status == Status::kStalled && edges) result.status = pair.TryEdges(*edges, facing, result);
  };
  if (holder != FaceHolder::kNone) {
    last_face = pair.FaceAlong(holder, state.normal_1);
    try_face(*last_face);
  } else {
    edges = LastEdges(state);
  }
  try_edges();
  if (result.status == Status::kStalled) {
    if (const BoxFace best = pair.BestFace(); best != last_face) {
      try_face(best);
      try_edges();
    }
  }
  if (result.status == Status::kStalled) {
    edges = pair.BestEdges();
    try_edges();
  }
  if (result.status == Status::kStalled) {
    facing.Clear();
    return result;
  }
  result.iterations = 1;
  const Vector3<S> normal_1 = pose_1.rotation.transpose() * result.normal;
  state.normal_1 = normal_1.normalized();
  if (result.status == Status::kSeparated) {
    state.size = state.known_size = 0;
  } else if (!facing.is_across_1 && !facing.is_across_2) {
    RememberEdge(box_1.core, normal_1, edges->axis_1, state.features_1[0], state.features_1[1]);
    RememberEdge(box_2.core, Vector3<S>(pose_2.rotation.transpose() * -result.normal), edges->axis_2,
                 state.features_2[0], state.features_2[1]);
    state.size = 2;
    state.known_size = 0;
  }
  return result;
}

}  // namespace dgd
