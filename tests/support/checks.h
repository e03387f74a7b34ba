// What every optimal answer must fulfil, as one check with one printed case per failure.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/reference_set.h"
#include "support/solver_pair.h"

namespace dgd_test {

/// Bounds on a certificate. The scalars' epsilons and nothing else decide them.
template <class S>
struct Bounds {
  /// Relative gap of an optimal result, and what the certificate's own evaluation of it may add: the distance of the
  /// centres is a difference of world coordinates, so it carries their rounding.
  static double Gap(const SolverPair<S>& pair, double extent) {
    const double distance = (pair.Center2() - pair.Center1()).template cast<double>().norm();
    return 1.0001 * double(dgd::kSqrtEpsilon<S>) + 16 * double(dgd::kEpsilon<S>) * Reach(pair, extent) / distance;
  }
  /// Metres. In double the 1e-9 of the extent. In float the rounding of the coordinates: of the witness points
  /// in the world, and of their offsets from the centres, which the growth distance magnifies.
  static double Infeasibility(const SolverPair<S>& pair, double extent, double growth_distance) {
    if constexpr (sizeof(S) == 8) return 1e-9 * extent;
    return kFloatUnits * double(dgd::kEpsilon<S>) * (Reach(pair, extent) + growth_distance * extent);
  }
  static double SeparationError(const SolverPair<S>& pair, double extent) {
    return 16 * double(dgd::kEpsilon<S>) * (Reach(pair, extent) + Distance(pair));
  }

 private:
  /// Half of all answers need a fifth of a unit, one in a thousand 5, the worst of 2e4 curved ones (whose last bases
  /// are slivers) 20.
  static constexpr double kFloatUnits = 64;

  static double Distance(const SolverPair<S>& pair) {
    return (pair.Center2() - pair.Center1()).template cast<double>().norm();
  }
  /// Largest world coordinate that a computation of the pair meets.
  static double Reach(const SolverPair<S>& pair, double extent) {
    return std::max(double(pair.Center1().template lpNorm<Eigen::Infinity>()),
                    double(pair.Center2().template lpNorm<Eigen::Infinity>())) +
           extent;
  }
};

template <class S>
::testing::AssertionResult IsFiniteAndOrdered(const dgd::Result<S>& result) {
  const bool finite = std::isfinite(result.lower_bound) && std::isfinite(result.upper_bound) &&
                      std::isfinite(result.separation) && result.normal.allFinite() && result.witness_1.allFinite() &&
                      result.witness_2.allFinite();
  const bool ordered = result.lower_bound >= 0 && result.lower_bound <= result.upper_bound;
  const bool unit = std::abs(result.normal.norm() - 1) <= 16 * dgd::kEpsilon<S>;
  if (finite && ordered && unit && result.iterations >= 1) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "finite " << finite << " ordered " << ordered << " unit normal " << unit
                                       << " bounds " << result.lower_bound << " .. " << result.upper_bound
                                       << " iterations " << result.iterations;
}

/// Optimal, and certified by dgd::Certify and by the reference support functions.
template <class S>
::testing::AssertionResult IsCertified(const ReferencePair& reference, const SolverPair<S>& pair,
                                       const dgd::Result<S>& result) {
  const double extent = reference.Extent();
  const dgd::Certificate certificate = pair.Certify(result);
  const double growth_distance = double(result.GrowthDistance());
  const double infeasibility_bound = Bounds<S>::Infeasibility(pair, extent, growth_distance);
  const double separation_bound = Bounds<S>::SeparationError(pair, extent);
  const double separation = reference.SeparationAlong(result.normal.template cast<double>().normalized());
  const bool certified =
      result.status == dgd::Status::kOptimal && IsFiniteAndOrdered(result) &&
      certificate.primal_infeasibility <= infeasibility_bound && certificate.dual_infeasibility <= 1e-6 &&
      certificate.relative_gap <= Bounds<S>::Gap(pair, extent) && certificate.separation_error <= separation_bound &&
      std::abs(separation - double(result.separation)) <= separation_bound;
  if (certified) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "status " << int(result.status) << ", iterations " << result.iterations
                                       << ", " << IsFiniteAndOrdered(result).message() << "growth distance "
                                       << growth_distance << ", gap " << certificate.relative_gap << " (at most "
                                       << Bounds<S>::Gap(pair, extent) << "), primal infeasibility "
                                       << certificate.primal_infeasibility << " (" << infeasibility_bound
                                       << "), dual infeasibility " << certificate.dual_infeasibility
                                       << ", separation error " << certificate.separation_error << " ("
                                       << separation_bound << "), reported " << result.separation << ", reference "
                                       << separation << "\n"
                                       << reference.Dump();
}

/// As IsCertified, for a fresh cold query.
template <class S>
::testing::AssertionResult SolvesAndCertifies(const ReferencePair& reference) {
  const SolverPair<S> pair(reference);
  return IsCertified<S>(reference, pair, pair.GrowthDistance());
}

/// Whether two results of the same question, however posed, do not contradict each other: their intervals meet.
template <class S>
::testing::AssertionResult Agree(const dgd::Result<S>& a, const dgd::Result<S>& b, S relative_slack) {
  const bool agree =
      a.lower_bound <= b.upper_bound * (1 + relative_slack) && b.lower_bound <= a.upper_bound * (1 + relative_slack);
  if (agree) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "[" << a.lower_bound << ", " << a.upper_bound << "] and [" << b.lower_bound
                                       << ", " << b.upper_bound << "] do not meet";
}

}  // namespace dgd_test
