// Alg. 3 of the paper as named steps; included by growth_distance.h.
#pragma once

#include <algorithm>

#include "dgd/growth_distance.h"
#include "dgd/ray/inner_approximation.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/outer_approximation.h"

namespace dgd {

/// Whether there is a last normal, of unit length: nothing else bounds anything, wherever it comes from.
template <class S, int L>
bool HasNormal(const WarmStart<S, L>& warm_start) {
  return std::abs(warm_start.normal_1.squaredNorm() - 1) <= kSqrtEpsilon<S>;  // False for NaN.
}

/// What ends a query besides convergence.
enum class Question { kDistance, kCollision };

/// One query: the ray from 0 along p against C = C1 - C2 + p, between an inner and an outer approximation.
template <class Set1, class Set2>
class RayIntersection {
 public:
  using S = typename Set1::Scalar;
  static_assert(std::is_same_v<S, typename Set2::Scalar>, "both sets must have the same scalar");

  RayIntersection(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2,
                  const Settings<S>& settings)
      : difference_(set_1, pose_1, set_2, pose_2), settings_(settings) {}

  Status Solve(Question question, WarmStart<S>* warm_start) {
    if (!difference_.IsFinite()) return Status::kInvalidInput;
    if (!(difference_.Inradius() > 0)) return Status::kNoInterior;
    const bool coincident = difference_.Length() <= kCoincidence<S> * difference_.Inradius();
    const Status status = coincident ? MeasureAlongAnyNormal(warm_start) : Iterate(question, warm_start);
    if (warm_start != nullptr) Remember(status, *warm_start);
    return status;
  }

  int Iterations() const { return iterations_; }
  /// At most the upper one, also where rounding puts the two heights in the wrong order.
  S LowerBound() const {
    return coincident_ ? S(0) : difference_.Length() / std::max(outer_.Height(), inner_.Height());
  }
  S UpperBound() const { return coincident_ ? S(0) : difference_.Length() / inner_.Height(); }
  Vector3<S> Normal() const { return difference_.DirectionToWorld(outer_.Normal()); }
  /// Distance of the supporting planes along the normal, metres.
  S Separation() const { return outer_.Normal().z() * difference_.Length() - outer_.SupportValue(); }

  Vector3<S> Witness1() const {
    return coincident_ ? difference_.Center1() : difference_.World1(inner_.CorePoint1(), inner_.Normal());
  }
  Vector3<S> Witness2() const {
    return coincident_ ? difference_.Center2() : difference_.World2(inner_.CorePoint2(), inner_.Normal());
  }
  /// Where the witness points meet when the sets are scaled by the upper bound about their centres: a point of both
  /// sets if that is at most 1.
  Vector3<S> MeetingPoint() const {
    return difference_.Center1() + UpperBound() * (Witness1() - difference_.Center1());
  }
  /// A point half way between the supporting planes along the normal.
  Vector3<S> PointBetween() const {
    return difference_.World1(outer_.SupportPoint1(), outer_.Normal()) + Separation() / 2 * Normal();
  }

 private:
  /// With p = 0 the growth distance is 0 and every direction is a normal: take the last one, or x.
  Status MeasureAlongAnyNormal(const WarmStart<S>* warm_start) {
    coincident_ = true;
    Vector3<S> normal = Vector3<S>::UnitX();
    if (warm_start != nullptr && HasNormal(*warm_start)) {
      normal = difference_.DirectionToFrame(warm_start->normal_1);
    }
    iterations_ = 1;
    const DifferencePoint<S> support = difference_.Support(normal);
    outer_.Adopt(normal, normal.dot(support.point) + difference_.Rounding(), support);
    return Status::kCoincidentCenters;
  }

  [[gnu::flatten]] Status Iterate(Question question, const WarmStart<S>* warm_start) {
    InitializeInner();
    Vector3<S> normal = warm_start != nullptr ? AdoptLastState(*warm_start) : inner_.Normal();
    for (;;) {
      if (!(normal.z() > 0)) return Status::kStalled;  // Also for NaN.
      const DifferencePoint<S> added = CutAlong(normal);
      if (const Status status = Verdict(question); status != kGoOn) return status;
      if (iterations_ >= settings_.max_iterations) return Status::kIterationLimit;
      // Without progress along its own normal, the inner approximation is as high as rounding lets it be.
      if (!inner_.Insert(added) && normal == inner_.Normal()) return Status::kStalled;
      normal = inner_.Normal();
    }
  }

  /// Alg. 1: the difference of the centres if there is a ball about it, else a triangle in the inradius.
  void InitializeInner() {
    inner_ = difference_.Rounding() > 0
                 ? InnerApproximation<S>::FromCenter(difference_.Rounding())
                 : InnerApproximation<S>::FromInradius(difference_.Inradius(), difference_.InradiusShare1());
  }

  /// Alg. 2, lines 1 and 2: support point and outer update.
  DifferencePoint<S> CutAlong(const Vector3<S>& normal) {
    ++iterations_;
    const DifferencePoint<S> added = difference_.Support(normal);
    outer_.Cut(normal, normal.dot(added.point) + difference_.Rounding(), added);
    return added;
  }

  /// Primal warm start (Sec. III-D3): the last basis, moved with the sets, goes into the inner approximation; all at
  /// once if it still carries the ray, else point by point. Without one (curved cores, or sets that were apart) the
  /// last normal starts the outer approximation instead.
  /// @return the first direction to search.
  Vector3<S> AdoptLastState(const WarmStart<S>& warm_start) {
    if constexpr (VertexCore<typename Set1::Core> && VertexCore<typename Set2::Core>) {
      std::array<DifferencePoint<S>, 3> basis;
      int size = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(warm_start.size); ++i) {
        if (!difference_.HasVertices(warm_start.features_1[i], warm_start.features_2[i])) continue;
        basis[static_cast<std::size_t>(size++)] =
            difference_.FromVertices(warm_start.features_1[i], warm_start.features_2[i]);
      }
      if (size > 0) {
        if (inner_.AdoptBasis(basis, size)) return inner_.Normal();
        for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) inner_.Insert(basis[i]);
        return inner_.Normal();
      }
    }
    if (!HasNormal(warm_start)) return inner_.Normal();
    // Scaled to unit length each time: the rotations' rounding would add up over the frames.
    const Vector3<S> last_normal = difference_.DirectionToFrame(warm_start.normal_1).normalized();
    return last_normal.z() > 0 ? last_normal : inner_.Normal();
  }

  Status Verdict(Question question) const {
    if (Separation() > settings_.separation_limit) return Status::kSeparated;
    const bool converged = outer_.Height() <= inner_.Height() * (1 + settings_.relative_tolerance);
    if (question == Question::kCollision) {
      if (inner_.Height() >= difference_.Length()) return Status::kColliding;
      if (Separation() > 0) return Status::kSeparated;
      return converged ? Status::kTouching : kGoOn;
    }
    return converged ? Status::kOptimal : kGoOn;
  }

  /// A pair that is apart remembers its normal only: the next query tries that first, and needs no basis then.
  void Remember(Status status, WarmStart<S>& warm_start) const {
    warm_start.normal_1 = difference_.DirectionToSet1(outer_.Normal());
    warm_start.size = 0;
    if (status == Status::kSeparated) return;
    for (int i = 0; i < inner_.Size(); ++i) {
      if (inner_[i].feature_1 == kNoFeature || inner_[i].feature_2 == kNoFeature) continue;
      const auto slot = static_cast<std::size_t>(warm_start.size++);
      warm_start.features_1[slot] = inner_[i].feature_1;
      warm_start.features_2[slot] = inner_[i].feature_2;
    }
  }

  /// Not a status that a query ends with: the bounds have not decided yet.
  static constexpr Status kGoOn = Status::kInvalidInput;

  MinkowskiDifference<Set1, Set2> difference_;
  const Settings<S>& settings_;
  InnerApproximation<S> inner_;
  OuterApproximation<S> outer_;
  int iterations_ = 0;
  bool coincident_ = false;
};

/// Tries the normal along which the sets were apart at the last query, before any frame is made: two evaluations of
/// support functions and a few dot products decide most pairs of a broadphase, which are apart and stay so.
/// @param warm_start  HasNormal().
/// @return whether the sets are farther apart along it than `limit`; the result then says so.
template <class Set1, class Set2>
[[gnu::flatten]] bool SeparatedAlongLastNormal(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                               const PoseOf<Set1>& pose_2, typename Set1::Scalar limit,
                                               const WarmStartOf<Set1>& warm_start, ResultOf<Set1>& result) {
  using S = typename Set1::Scalar;
  using Point = VectorOf<typename Set1::Core>;
  const Point& normal_1 = warm_start.normal_1;
  const Point normal = pose_1.rotation * normal_1;
  const Point normal_2 = pose_2.rotation.transpose() * -normal;
  const Point support_1 = set_1.core.Support(normal_1).point;
  const Point support_2 = set_2.core.Support(normal_2).point;
  const S separation = normal.dot(pose_2.translation - pose_1.translation) - normal_1.dot(support_1) -
                       normal_2.dot(support_2) - set_1.radius - set_2.radius;
  if (!(separation > limit && std::isfinite(separation))) return false;  // Also for NaN.

  result.status = Status::kSeparated;
  result.iterations = 1;
  result.normal = normal;
  result.separation = separation;
  result.lower_bound = 1;  // The sets are apart.
  return true;
}

template <class Set1, class Set2>
[[gnu::flatten]] ResultOf<Set1> GrowthDistance(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                               const PoseOf<Set1>& pose_2,
                                               const Settings<typename Set1::Scalar>& settings,
                                               WarmStartOf<Set1>* warm_start) {
  ResultOf<Set1> result;
  if (warm_start != nullptr && warm_start->size == 0 && HasNormal(*warm_start) &&
      SeparatedAlongLastNormal(set_1, pose_1, set_2, pose_2, settings.separation_limit, *warm_start, result)) {
    return result;
  }
  RayIntersection<Set1, Set2> query(set_1, pose_1, set_2, pose_2, settings);
  result.status = query.Solve(Question::kDistance, warm_start);
  result.iterations = query.Iterations();
  if (result.status == Status::kInvalidInput || result.status == Status::kNoInterior) return result;
  result.lower_bound = query.LowerBound();
  result.upper_bound = query.UpperBound();
  result.normal = query.Normal();
  result.separation = query.Separation();
  result.witness_1 = query.Witness1();
  result.witness_2 = query.Witness2();
  return result;
}

template <class Set1, class Set2>
CollisionResultOf<Set1> DetectCollision(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2,
                                        const PoseOf<Set1>& pose_2, const Settings<typename Set1::Scalar>& settings,
                                        WarmStartOf<Set1>* warm_start) {
  using S = typename Set1::Scalar;
  CollisionResultOf<Set1> result;
  ResultOf<Set1> apart;
  if (warm_start != nullptr && warm_start->size == 0 && HasNormal(*warm_start) &&
      SeparatedAlongLastNormal(set_1, pose_1, set_2, pose_2, S(0), *warm_start, apart)) {
    result.status = Status::kSeparated;
    result.iterations = apart.iterations;
    result.normal = apart.normal;
    result.separation = apart.separation;
    const VectorOf<typename Set1::Core> support_1 = pose_1 * set_1.core.Support(warm_start->normal_1).point;
    result.point = support_1 + (set_1.radius + apart.separation / 2) * apart.normal;
    return result;
  }
  RayIntersection<Set1, Set2> query(set_1, pose_1, set_2, pose_2, settings);
  result.status = query.Solve(Question::kCollision, warm_start);
  result.iterations = query.Iterations();
  switch (result.status) {
    case Status::kSeparated:
      result.normal = query.Normal();
      result.separation = query.Separation();
      result.point = query.PointBetween();
      break;
    case Status::kCoincidentCenters:
      result.status = Status::kColliding;
      [[fallthrough]];
    case Status::kColliding:
    case Status::kTouching:
      result.point = query.MeetingPoint();
      break;
    default:
      break;
  }
  return result;
}

}  // namespace dgd
