// The signed distance of two polytopes whose cores stay apart from frame to frame: GJK, from where it ended last.
//
// Most often the last nearest simplex holds the contact still, and one evaluation of the support functions proves it.
// So nothing is made ready that this does not need: the axes are the world's and the points' origins the sets' own,
// without the centres, the ray and its frame. What does not end here quickly is left to the growth distance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dgd/assert.h"
#include "dgd/convex_set.h"
#include "dgd/distance/gjk_simplex.h"
#include "dgd/query_types.h"
#include "dgd/solver/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class WarmGjk {
 public:
  using S = typename Set1::Scalar;
  using Point = Vector3<S>;
  using Feature = DifferencePoint<S, 3>;

  WarmGjk(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
          const Settings<S>& settings)
      : set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2),
        settings_(settings),
        between_(pose_2.translation - pose_1.translation),
        size_(between_.cwiseAbs().maxCoeff()) {}

  /// @return kOptimal or kSeparated; anything else if the cores are not apart, or there is no state.
  Status SolveApart(const WarmStart<S>& last) {
    AddLast(last);
    for (;;) {
      nearest_ = simplex_.Nearest().norm();
      // Also without a point; that of NaN has none.
      if (!IsApart()) return HasFinitePoses() ? Status::kStalled : Status::kInvalidInput;
      if (IsOptimal()) return Status::kOptimal;
      if (iterations_ >= settings_.max_iterations) return Status::kIterationLimit;
      const Feature support = Cut(simplex_.Normal());
      if (IsOptimal()) return Status::kOptimal;
      if (Separation() > settings_.separation_limit) return Status::kSeparated;
      if (simplex_.HoldsOriginWith(support.point)) return Status::kStalled;
      const S before = simplex_.Nearest().squaredNorm();
      simplex_.Add(support);
      if (!descent_.Continues(before, simplex_.Nearest().squaredNorm())) return Status::kStalled;
    }
  }

  /// Leaves the simplex, and the normal, for the next search.
  void Remember(Status status, WarmStart<S>& state) const {
    DGD_ASSERT(status == Status::kOptimal || status == Status::kSeparated);
    state.normal_1 = normal_in_1_.normalized();  // Rotations in float are not quite orthogonal.
    simplex_.Leave(state);
    if (status == Status::kSeparated) state.size = 0;
  }

  int Iterations() const { return iterations_; }
  Point Normal() const { return normal_; }
  S Separation() const { return apart_ - set_1_.radius - set_2_.radius; }
  S UpperBound() const { return std::max(nearest_ + RoundoffBound(), apart_) - set_1_.radius - set_2_.radius; }
  /// Each on its set's supporting plane.
  Point Witness1() const {
    const Point foot = simplex_.Combination().on_1;
    return pose_1_.translation + foot + (on_plane_1_ - normal_.dot(foot) + set_1_.radius) * normal_;
  }
  Point Witness2() const { return Witness1() + Separation() * normal_; }

 private:
  void AddLast(const WarmStart<S>& last) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(last.size); ++i) {
      const VertexId vertex_1 = last.features_1[i], vertex_2 = last.features_2[i];
      // Sets may have changed since.
      if (vertex_1 >= set_1_.core.VertexCount() || vertex_2 >= set_2_.core.VertexCount()) continue;
      simplex_.Append(Difference({set_1_.core.Vertex(vertex_1), vertex_1}, {set_2_.core.Vertex(vertex_2), vertex_2}));
    }
    simplex_.Reduce();
  }

  /// The difference of two points of the cores' frames, about the origins' own difference; in the world's axes.
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
  Feature Cut(const Point& normal) {
    DGD_ASSERT(IsUnitOrNan(normal));
    ++iterations_;
    const Point normal_in_1 = pose_1_.rotation.transpose() * normal;
    const Point against_in_2 = pose_2_.rotation.transpose() * -normal;
    const Feature support = Difference(SupportNear(set_1_.core, normal_in_1, simplex_[0].feature_1),
                                       SupportNear(set_2_.core, against_in_2, simplex_[0].feature_2));
    const S apart = -normal.dot(support.point);
    if (apart > apart_) {
      apart_ = apart;
      normal_ = normal;
      normal_in_1_ = normal_in_1;
      on_plane_1_ = normal.dot(support.on_1);
    }
    return support;
  }

  bool HasFinitePoses() const {
    return std::isfinite(pose_1_.rotation.sum() + pose_2_.rotation.sum() + between_.sum());
  }
  /// Whether the cores are, as far as is known and in numbers that the scalar can compute with; false for NaN.
  bool IsApart() const { return nearest_ > RoundoffBound() && nearest_ >= kLeastSize<S> && size_ <= kGreatestSize<S>; }
  bool IsOptimal() const { return nearest_ - apart_ <= RoundoffBound(); }
  /// How far points of the difference may be off, metres: the last digits of points that were turned and moved.
  S RoundoffBound() const {
    constexpr S kUnits = 8;
    return kUnits * kEpsilon<S> * std::max({size_, set_1_.radius, set_2_.radius});
  }

  const Set1& set_1_;
  const Pose<S>& pose_1_;
  const Set2& set_2_;
  const Pose<S>& pose_2_;
  const Settings<S>& settings_;
  const Point between_;  // From set 1's origin to set 2's; world, metres.
  S size_;               // Largest coordinate of a point; metres.
  GjkSimplex<S> simplex_;
  S nearest_ = 0;  // Distance of the cores' inner approximations, metres.
  // Of the best supporting planes of the cores.
  Point normal_, normal_in_1_;
  S apart_ = -std::numeric_limits<S>::infinity(), on_plane_1_ = 0;
  Descent<S> descent_;
  int iterations_ = 0;
};

}  // namespace dgd
