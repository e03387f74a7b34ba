// What a query of the growth distance takes and gives: settings, results, and the state between queries of a pair.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "dgd/convex_set.h"
#include "dgd/solver/tolerances.h"
#include "dgd/types.h"

namespace dgd {

/// How a query ended. Every field of the result is set whatever the status.
enum class Status : std::uint8_t {
  kOptimal,            ///< The bounds agree within the tolerance.
  kSeparated,          ///< Stopped early: apart by more than the limit, along `normal`.
  kColliding,          ///< Collision check only: a common point is certain.
  kTouching,           ///< Collision check only: the bounds agree within the tolerance, and 1 lies between them.
  kCoincidentCenters,  ///< The centres coincide within roundoff: growth distance 0, and any normal is as good.
  kIterationLimit,     ///< The bounds are valid but apart by more than the tolerance.
  kStalled,            ///< The same as kIterationLimit: roundoff allows no further progress.
  kNoInterior,         ///< Neither set has an interior, or one beyond the roundoff of its points: no growth distance
                       ///< exists (paper, Rem. 1).
  kInvalidInput,  ///< NaN or infinity in a pose or radius, or from a core, or sizes of which the scalar cannot multiply
                  ///< four (kLeastSize in solver/tolerances.h). No other field is usable.
};

/// When a query ends, whichever comes first.
template <class S>
struct Settings {
  /// Largest relative gap upper_bound / lower_bound - 1 of an optimal result; > 0. Polytopes reach roundoff error
  /// whatever this is (paper, Sec. III-C4).
  S relative_tolerance = kSqrtEpsilon<S>;
  /// Most evaluations of the support functions; >= 1.
  int max_iterations = 100;
  /// Stop with kSeparated once the sets are certain to be farther apart than this; metres, >= 0, infinite for never.
  /// With a warm start the last normal is tried before anything else: a pair that stays apart costs one evaluation.
  S separation_limit = std::numeric_limits<S>::infinity();
};

/// What an observer of a query gets after each iteration: the bounds of Result so far, which only approach each
/// other, for convergence plots.
template <class S, int L>
struct Iterate {
  int iteration;               ///< Number of the iteration, from 1.
  S lower_bound, upper_bound;  ///< Bounds on the growth distance.
  Vector<S, L> normal;         ///< Normal of the lowest supporting plane so far: world frame, unit length.
};

/// An observer that costs nothing.
struct NoObserver {};

/// A growth distance: its bounds, and what proves them.
template <class S, int L = 3>
struct Result {
  Status status = Status::kInvalidInput;
  int iterations = 0;  ///< Evaluations of the support functions.

  /// Bounds on the growth distance, dimensionless, 0 <= lower <= upper. The upper one is reached by the witness points
  /// (primal), the lower one is proven by the normal (dual). 0 and infinite if unknown.
  S lower_bound = 0;
  S upper_bound = std::numeric_limits<S>::infinity();

  /// Unit vector from set 1 to set 2 in the world, normal to the plane that proves the lower bound. The exact contact
  /// normal where the sets touch; elsewhere it depends on the centres.
  Vector<S, L> normal = Vector<S, L>::UnitX();
  /// Distance of the sets along `normal` between their supporting planes, metres, certain: if positive, they are at
  /// least this far apart; if negative, moving set 2 by its absolute value along `normal` makes them touch.
  S separation = 0;

  /// Points of set 1 and set 2 in the world, metres, that coincide when both sets are scaled by upper_bound about
  /// their centres (paper, eq. primal-optimal-from-ray-intersection). Zero where upper_bound is infinite, as it is when
  /// kSeparated came before any point was found.
  Vector<S, L> witness_1 = Vector<S, L>::Zero();
  Vector<S, L> witness_2 = Vector<S, L>::Zero();

  /// The growth distance: the primal value, never below the true one.
  S GrowthDistance() const { return upper_bound; }
  /// upper_bound / lower_bound - 1.
  S RelativeGap() const { return upper_bound / lower_bound - 1; }
};

/// Whether the result is made of numbers; the upper bound alone may be infinite.
template <class S, int L>
bool IsFinite(const Result<S, L>& result) {
  const S sum = result.normal.sum() + result.separation + result.witness_1.sum() + result.witness_2.sum();
  return std::isfinite(sum + result.lower_bound) && result.lower_bound <= result.upper_bound;  // False for NaN.
}

/// State of one pair of sets from one query to the next, in this order of the sets; default-made for a cold start.
/// Stays correct (a start is only a start) whatever happened to the sets in between, but for vertices that no longer
/// exist, which are ignored.
template <class S, int L = 3>
struct WarmStart {
  /// An overlap in space may be left with more points than the L of a basis or a nearest simplex: with four at most,
  /// hulls in overlap take 1.13 of the instructions of six, with eight 1.01 (query_instructions.sh, `overlap`).
  static constexpr std::size_t kMostFeatures = L == 3 ? 6 : L;

  Vector<S, L> normal_1 = Vector<S, L>::Zero();  ///< Last normal, in set 1's frame, unit length; zero for none.
  /// Points of the Minkowski difference by the features of the two cores: the last basis of the inner approximation,
  /// the nearest simplex of cores that are apart, or corners of an expanding polytope.
  std::array<FeatureId, kMostFeatures> features_1{}, features_2{};
  /// Number of these points, up to kMostFeatures; 0 if the sets were separated by more than the limit.
  std::int32_t size = 0;

  /// @pre There is room.
  void Add(FeatureId feature_1, FeatureId feature_2) {
    const auto slot = static_cast<std::size_t>(size++);
    features_1[slot] = feature_1;
    features_2[slot] = feature_2;
  }
};
static_assert(sizeof(WarmStart<double>) <= 128, "must fit into a Bullet algorithm object beside the rest");

/// Whether there is a last normal, of unit length: nothing else bounds anything, wherever it comes from.
template <class S, int L>
bool HasNormal(const WarmStart<S, L>& warm_start) {
  return std::abs(warm_start.normal_1.squaredNorm() - 1) <= kSqrtEpsilon<S>;  // False for NaN.
}

template <class Set>
using ResultOf = Result<typename Set::Scalar, kDimension<typename Set::Core>>;
template <class Set>
using WarmStartOf = WarmStart<typename Set::Scalar, kDimension<typename Set::Core>>;

/// Whether two sets overlap, and what proves it.
template <class S, int L = 3>
struct CollisionResult {
  /// kSeparated, kColliding or kTouching; or one of the failures of Status.
  Status status = Status::kInvalidInput;
  int iterations = 0;
  /// kSeparated: unit normal from set 1 to set 2 of a plane between them, world.
  Vector<S, L> normal = Vector<S, L>::UnitX();
  /// kSeparated: distance of the sets along the normal, metres, > 0.
  S separation = 0;
  /// kSeparated: a point on the plane half way between the sets. kColliding: a point of both sets. kTouching: a point
  /// within the tolerance of both. World, metres.
  Vector<S, L> point = Vector<S, L>::Zero();
};

template <class S, int L>
bool IsFinite(const CollisionResult<S, L>& result) {
  return std::isfinite(result.normal.sum() + result.separation + result.point.sum());
}

template <class Set>
using CollisionResultOf = CollisionResult<typename Set::Scalar, kDimension<typename Set::Core>>;

}  // namespace dgd
