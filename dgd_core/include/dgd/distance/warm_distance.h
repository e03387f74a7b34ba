// The signed distance of two polytopes from where it ended last: GJK while their cores are apart, an expanding polytope
// while they overlap.
//
// The last points are named by vertices, and so are points of the difference wherever the sets have moved to. Most
// often they hold the answer still, and one evaluation of the support functions proves it. So nothing is made ready
// that this does not need: the axes are the world's and the points' origins the sets' own, without the centres, the ray
// and its frame. What does not end here quickly is left to the growth distance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/distance/epa.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/inlining.h"
#include "dgd/query_types.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

/// Of the difference K of the two cores, about the origin of the two positions. World axes, metres.
template <class Set1, class Set2>
class WarmDistance {
 public:
  using S = typename Set1::Scalar;
  using Point = Vector3<S>;
  using Feature = DifferencePoint<S, 3>;

  WarmDistance(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
               const Settings<S>& settings)
      : set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2),
        settings_(settings),
        between_(pose_2.translation - pose_1.translation),
        size_(between_.cwiseAbs().maxCoeff()) {}

  /// @return kOptimal or kSeparated; anything else if there is no state, or the points hold the origin no more.
  Status Solve(const WarmStart<S>& last) {
    // A nearest simplex has three points at most.
    if (last.size > 3) return ResumeEpa(last);
    ForEachPoint(last, [&](const Feature& point) { simplex_.Append(point); });
    simplex_.Reduce();
    return RunGjk();
  }

  /// Leaves the points, and the normal, for the next search.
  void Remember(Status status, WarmStart<S>& state) const {
    DGD_ASSERT(status == Status::kOptimal || status == Status::kSeparated);
    if (corners_) {
      state = *corners_;
    } else {
      simplex_.Leave(state);
    }
    state.normal_1 = normal_in_1_.normalized();  // Rotations in float are not quite orthogonal.
    if (status == Status::kSeparated) state.size = 0;
  }

  int Iterations() const { return iterations_; }
  Point Normal() const { return normal_; }
  S Separation() const { return apart_ - set_1_.radius - set_2_.radius; }
  S UpperBound() const { return std::max(nearest_ + RoundoffBound(), apart_) - set_1_.radius - set_2_.radius; }
  Point Witness1() const { return pose_1_.translation + foot_.on_1 + set_1_.radius * normal_; }
  Point Witness2() const { return pose_1_.translation + foot_.on_1 - foot_.point - set_2_.radius * normal_; }

 private:
  /// Calls take(point) for the points that a state names by vertices.
  template <class Take>
  void ForEachPoint(const WarmStart<S>& last, const Take& take) {
    DGD_ASSERT(static_cast<std::size_t>(last.size) <= last.features_1.size());
    for (std::size_t i = 0; i < static_cast<std::size_t>(last.size); ++i) {
      const VertexId vertex_1 = last.features_1[i], vertex_2 = last.features_2[i];
      // Sets may have changed since.
      if (vertex_1 >= set_1_.core.VertexCount() || vertex_2 >= set_2_.core.VertexCount()) continue;
      take(Difference({set_1_.core.Vertex(vertex_1), vertex_1}, {set_2_.core.Vertex(vertex_2), vertex_2}));
    }
  }

  /// The difference of two points of the cores' frames, about the origins' own difference.
  Feature Difference(const SupportPoint<S>& on_1, const SupportPoint<S>& on_2) {
    Feature difference;
    difference.on_1.noalias() = pose_1_.rotation * on_1.point;
    difference.point.noalias() = pose_2_.rotation * on_2.point;
    difference.point = difference.on_1 - (difference.point + between_);
    difference.feature_1 = on_1.feature;
    difference.feature_2 = on_2.feature;
    size_ = std::max({size_, difference.on_1.cwiseAbs().maxCoeff(), difference.point.cwiseAbs().maxCoeff()});
    return difference;
  }

  /// Finds the supporting planes along a normal, and keeps them if they are the farthest apart so far.
  /// @param near  A point whose vertices may be near.
  Feature Cut(const Point& normal, const Feature& near) {
    DGD_ASSERT(IsUnitOrNan(normal));
    ++iterations_;
    const Point normal_in_1 = pose_1_.rotation.transpose() * normal;
    const Point against_in_2 = pose_2_.rotation.transpose() * -normal;
    const Feature support = Difference(SupportNear(set_1_.core, normal_in_1, near.feature_1),
                                       SupportNear(set_2_.core, against_in_2, near.feature_2));
    const S apart = -normal.dot(support.point);
    if (apart > apart_) {
      apart_ = apart;
      normal_ = normal;
      normal_in_1_ = normal_in_1;
      on_plane_1_ = normal.dot(support.on_1);
    }
    return support;
  }

  /// With the cores apart.
  Status RunGjk() {
    for (;;) {
      nearest_ = simplex_.Nearest().norm();
      // Also without a point; that of NaN has none.
      if (!IsApart()) return HasFinitePoses() ? Status::kStalled : Status::kInvalidInput;
      if (IsOptimal()) return FinishAt(simplex_.Combination());
      if (IsExhausted()) return Status::kIterationLimit;
      const Feature support = Cut(simplex_.Normal(), simplex_[0]);
      if (IsOptimal()) return FinishAt(simplex_.Combination());
      if (Separation() > settings_.separation_limit) return Status::kSeparated;
      if (simplex_.HoldsOriginWith(support.point)) {
        return StartEpa({simplex_[0], simplex_[1], simplex_[2], support});
      }
      const S before = simplex_.Nearest().squaredNorm();
      simplex_.Add(support);
      if (!descent_.Continues(before, simplex_.Nearest().squaredNorm())) return Status::kStalled;
    }
  }

  /// With the cores in overlap.
  DGD_NOINLINE Status StartEpa(const std::array<Feature, 4>& corners) {
    EpaPolytope<S> polytope(corners, RoundoffBound(), size_);
    return RunEpa(polytope);
  }

  /// From the points of the last polytope; if the first four do not hold the origin any more, the cores may be apart.
  DGD_NOINLINE Status ResumeEpa(const WarmStart<S>& last) {
    std::array<Feature, WarmStart<S>::kMostFeatures> points;
    std::size_t count = 0;
    ForEachPoint(last, [&](const Feature& point) { points[count++] = point; });
    if (!HasFinitePoses() || !(size_ <= kGreatestSize<S>)) return Status::kInvalidInput;
    if (count < 4) return Status::kStalled;
    EpaPolytope<S> polytope({points[0], points[1], points[2], points[3]}, RoundoffBound(), size_);
    if (!(polytope.Inradius() > RoundoffBound())) {
      simplex_ = GjkSimplex<S>(polytope.CornersOf(polytope.Nearest()), 3);
      return RunGjk();
    }
    for (std::size_t i = 4; i < count; ++i) polytope.Add(points[i]);
    return RunEpa(polytope);
  }

  /// With the origin inside K.
  Status RunEpa(EpaPolytope<S>& polytope) {
    for (;;) {
      const auto& face = polytope.Nearest();
      nearest_ = -polytope.Inradius();
      if (polytope.IsSliver(face)) return Status::kStalled;
      if (IsExhausted()) return Status::kIterationLimit;
      const Feature support = Cut(face.normal, polytope.CornersOf(face)[0]);
      if (IsOptimal()) break;
      if (!polytope.Add(support)) return Status::kStalled;
    }
    polytope.Leave(corners_.emplace());
    return FinishAt(polytope.NearestTo(-apart_ * normal_));
  }

  /// Puts the witness points on their sets' supporting planes, which the inner approximation is below by the gap.
  Status FinishAt(const Feature& of_inner) {
    foot_ = of_inner;
    foot_.on_1 += (on_plane_1_ - normal_.dot(foot_.on_1)) * normal_;
    foot_.point -= (apart_ + normal_.dot(foot_.point)) * normal_;
    return Status::kOptimal;
  }

  bool IsExhausted() const { return iterations_ >= settings_.max_iterations; }
  bool HasFinitePoses() const {
    return std::isfinite(pose_1_.rotation.sum() + pose_2_.rotation.sum() + between_.sum());
  }
  /// Whether the cores are, as far as is known and in numbers that the scalar can compute with; false for NaN.
  bool IsApart() const { return nearest_ > RoundoffBound() && nearest_ >= kLeastSize<S> && size_ <= kGreatestSize<S>; }
  bool IsOptimal() const { return nearest_ - apart_ <= RoundoffBound(); }
  /// How far points of the difference may be off: the last digits of points that were turned and moved.
  S RoundoffBound() const {
    constexpr S kUnits = 8;
    return kUnits * kEpsilon<S> * std::max({size_, set_1_.radius, set_2_.radius});
  }

  const Set1& set_1_;
  const Pose<S>& pose_1_;
  const Set2& set_2_;
  const Pose<S>& pose_2_;
  const Settings<S>& settings_;
  const Point between_;  // From set 1's origin to set 2's.
  S size_;               // Largest coordinate of a point.
  GjkSimplex<S> simplex_;
  std::optional<WarmStart<S>> corners_;  // Of the expanding polytope, at its end.
  S nearest_ = 0;                        // Signed distance of the cores' inner approximations.
  // Of the best supporting planes of the cores.
  Point normal_, normal_in_1_;
  S apart_ = -std::numeric_limits<S>::infinity(), on_plane_1_ = 0;
  Feature foot_;  // The witness points' difference, without radii.
  Descent<S> descent_;
  int iterations_ = 0;
};

}  // namespace dgd
