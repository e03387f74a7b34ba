// Pairs of sets for the tests of this folder, each answer judged by the solver and the certificate.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "bench/pair_class.h"
#include "bench/textbook/support_function.h"
#include "support/pairs/any_pair.h"
#include "support/pairs/random_pair.h"
#include "support/pairs/with_core.h"

namespace dgd_bench {

inline const PairClass& ClassOf(const std::string& name) {
  for (const PairClass& each : AllPairClasses()) {
    if (each.name == name) return each;
  }
  throw std::invalid_argument("no class " + name);
}

inline dgd::Pose<double> PoseFrom(const dgd_test::PoseNumbers& pose) { return {pose.rotation, pose.translation}; }

/// Poses that overlap and poses that do not are both frequent: nearer than the benchmarks' own.
inline PairPoses DrawNearPoses(dgd_test::Random& random, double extent) { return DrawPoses(random, 3, 0.5 * extent); }

/// Whether the overlaps are between an eighth and seven eighths of all.
inline bool IsBalanced(int overlaps, int count) { return 8 * overlaps >= count && 8 * overlaps <= 7 * count; }

/// What an answer must fulfil, of lengths as parts of the pair's size.
struct Demands {
  double gap;                  ///< Certified.
  double primal;               ///< Infeasibility.
  double separation = primal;  ///< Error of the separation along the normal, and so of the lower bound.
};

class TextbookPair {
 public:
  explicit TextbookPair(const dgd_test::PairNumbers& numbers)
      : numbers_(numbers), judge_(numbers), set_1_(MakeSet(numbers.set_1)), set_2_(MakeSet(numbers.set_2)) {
    MoveTo(numbers.pose_1, numbers.pose_2);
  }

  void MoveTo(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& pose_2) {
    numbers_.pose_1 = pose_1;
    numbers_.pose_2 = pose_2;
    pose_1_ = PoseFrom(pose_1);
    pose_2_ = PoseFrom(pose_2);
    judge_.MoveTo(pose_1, pose_2);
  }

  double Extent() const { return judge_.Extent(); }
  const SupportFunction<3>& Set1() const { return *set_1_; }
  const SupportFunction<3>& Set2() const { return *set_2_; }
  const dgd::Pose<double>& Pose1() const { return pose_1_; }
  const dgd::Pose<double>& Pose2() const { return pose_2_; }
  dgd::Certificate Certify(const dgd::Result<double>& result) const { return judge_.Certify(result); }
  dgd::Result<double> Solve() const { return judge_.GrowthDistance({}); }

  /// Optimal, certified, and not at odds with the solver: the two intervals of bounds meet.
  ::testing::AssertionResult IsCertified(const dgd::Result<double>& result, const Demands& demands) const {
    const dgd::Certificate certificate = Certify(result);
    const dgd::Result<double> solved = Solve();
    const Eigen::Vector3d center_1 = judge_.Center(dgd_test::Which::kFirst);
    const Eigen::Vector3d center_2 = judge_.Center(dgd_test::Which::kSecond);
    const double between = (center_2 - center_1).norm(), size = Extent() + between;
    // The way between the centres is a difference of the world's coordinates: where they nearly coincide, rounding is
    // much of it, and of the growth distance.
    constexpr double kUnits = 16;
    const double reach = Extent() + center_1.norm() + center_2.norm();
    const double rounding = kUnits * dgd::kEpsilon<double> * reach / between;
    // What is infeasible by so much proves no more.
    const double slack = 1 + std::max(demands.primal, demands.separation) + rounding;
    const bool meet = result.lower_bound <= solved.upper_bound * slack &&
                      solved.lower_bound <= result.upper_bound * slack &&
                      result.lower_bound <= result.upper_bound * slack;
    if (result.status == dgd::Status::kOptimal && certificate.primal_infeasibility <= demands.primal * size &&
        certificate.dual_infeasibility <= 1e-9 && certificate.relative_gap <= demands.gap + rounding &&
        certificate.separation_error <= demands.separation * size && meet && result.iterations >= 1) {
      return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "status " << int(result.status) << ", iterations " << result.iterations
                                         << ", bounds " << result.lower_bound << " .. " << result.upper_bound
                                         << ", the solver's " << solved.lower_bound << " .. " << solved.upper_bound
                                         << ", gap " << certificate.relative_gap << " (" << demands.gap
                                         << "), primal infeasibility " << certificate.primal_infeasibility << " ("
                                         << demands.primal * size << "), dual " << certificate.dual_infeasibility
                                         << ", separation error " << certificate.separation_error << '\n'
                                         << Dump(numbers_);
  }

 private:
  static std::unique_ptr<SupportFunction<3>> MakeSet(const dgd_test::SetNumbers& set) {
    return dgd_test::WithCore<double, 3>(set, [&](auto core) -> std::unique_ptr<SupportFunction<3>> {
      return std::make_unique<SupportFunctionOf<decltype(core)>>(dgd::RoundedSet{std::move(core), set.radius});
    });
  }

  dgd_test::PairNumbers numbers_;
  dgd_test::AnyPair<double, 3> judge_;
  const std::unique_ptr<SupportFunction<3>> set_1_, set_2_;
  dgd::Pose<double> pose_1_, pose_2_;
};

/// Lengths of two decades, metres.
inline constexpr dgd_test::LengthRange kTwoDecades{0.0025, 0.25};

/// How many of some pairs a method had an answer for.
struct SolvedShare {
  int pairs = 0, solved = 0;

  double Share() const { return static_cast<double>(solved) / pairs; }
  SolvedShare& operator+=(const SolvedShare& other) {
    pairs += other.pairs;
    solved += other.solved;
    return *this;
  }
};

/// Random pairs in all placements. Each answer that the method calls optimal must be certified; others are counted.
/// @param make   Makes the two sets; the poses are not its.
/// @param solve  Answers them.
template <class Make, class Solve>
SolvedShare SolvePlacedPairs(dgd_test::Random& random, int pairs_each, const Make& make, const Solve& solve,
                             const Demands& demands) {
  SolvedShare share;
  for (int k = 0; k < pairs_each * dgd_test::kPlacementCount && !::testing::Test::HasFatalFailure(); ++k) {
    dgd_test::PairNumbers pair = make();
    Place(random, static_cast<dgd_test::Placement>(k % dgd_test::kPlacementCount), pair);
    const dgd::Result<double> result = solve(pair);
    ++share.pairs;
    if (result.status != dgd::Status::kOptimal) continue;
    ++share.solved;
    [&] { ASSERT_TRUE(TextbookPair(pair).IsCertified(result, demands)); }();
  }
  return share;
}

}  // namespace dgd_bench
