#include "bench/growth_pair.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "bench/solver_set.h"
#include "bench/stopwatch.h"
#include "bench/textbook/plain_algorithm.h"
#include "support/lp_oracle.h"

namespace dgd_bench {
namespace {

using dgd_test::PoseNumbers;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;

bool IsSharpPolytope(const SetNumbers& set) {
  return (set.type == SetType::kPolytope || set.type == SetType::kMesh) && set.radius == 0;
}

std::vector<Vector3d> InWorld(const SetNumbers& set, const PoseNumbers& pose) {
  std::vector<Vector3d> points(set.points.size());
  std::ranges::transform(set.points, points.begin(),
                         [&](const Vector3d& point) -> Vector3d { return pose.rotation * point + pose.translation; });
  return points;
}

/// A linear program for sharp polytopes in space, its optimal basis solved for in extended precision (correct to about
/// 1e-13, support/lp_oracle.h); the closed form for two balls. Nothing for other sets, or where the linear program
/// fails.
/// @param center_1, center_2  Of the sets, world, metres.
std::optional<double> ExactDistance(const dgd_test::PairNumbers& pair, const Vector3d& center_1,
                                    const Vector3d& center_2) try {
  const auto& [set_1, set_2, pose_1, pose_2] = pair;
  if (set_1.type == SetType::kPoint && set_2.type == SetType::kPoint) {
    return (center_2 - center_1).norm() / (set_1.radius + set_2.radius);
  }
  if (!IsSharpPolytope(set_1) || !IsSharpPolytope(set_2)) return std::nullopt;
  return dgd_test::GrowthDistanceByLp(InWorld(set_1, pose_1), center_1, InWorld(set_2, pose_2), center_2);
} catch (const std::runtime_error&) {
  return std::nullopt;
}

template <int L>
class SolverPair final : public GrowthPair {
 public:
  using Result = dgd::Result<double, L>;
  using Pose = dgd::Pose<double, L>;

  SolverPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2)
      : numbers_{set_1, set_2, {}, {}},
        set_1_(MakeSolverSet<L>(set_1)),
        set_2_(MakeSolverSet<L>(set_2)),
        judge_(numbers_) {}

  double Extent() const override { return set_1_.extent + set_2_.extent; }

  void MoveTo(const PairPoses& poses) override {
    pose_1_ = PoseFrom(poses.pose_1);
    pose_2_ = PoseFrom(poses.last_pose_2);
    warm_start_ = {};
    SolveGrowth<L>(set_1_, pose_1_, set_2_, pose_2_, {}, &warm_start_);
    plain_state_ = {};
    PlainGrowthDistance(*set_1_.plain, pose_1_, *set_2_.plain, pose_2_, &plain_state_);
    pose_2_ = PoseFrom(poses.pose_2);
    numbers_.pose_1 = poses.pose_1;
    numbers_.pose_2 = poses.pose_2;
    judge_.MoveTo(poses.pose_1, poses.pose_2);
  }

  bool Takes(const GrowthQuery& query) const override { return query.algorithm <= GrowthAlgorithm::kPlain; }

  double Time(const GrowthQuery& query, int repeats) const override {
    return Run(query, [repeats](const auto& solve) { return MeanMicroseconds(repeats, [&] { Keep(solve()); }); });
  }
  GrowthAnswer Solve(const GrowthQuery& query) const override {
    return Run(query, [this](const auto& solve) { return this->Judge(solve()); });
  }

  std::optional<double> ExactGrowthDistance() const override {
    if constexpr (L == 3) {
      return ExactDistance(numbers_, judge_.Center(dgd_test::Which::kFirst), judge_.Center(dgd_test::Which::kSecond));
    }
    return std::nullopt;
  }

 private:
  static Pose PoseFrom(const dgd_test::PoseNumbers& pose) {
    return {pose.rotation.topLeftCorner<L, L>(), pose.translation.head<L>()};
  }

  /// @param use  Called with a function that solves the query.
  template <class Use>
  auto Run(const GrowthQuery& query, const Use& use) const {
    const bool is_ours = query.algorithm == GrowthAlgorithm::kOurs;
    if (!Takes(query)) throw std::logic_error("a query to an algorithm that does not take it");
    if (query.is_check && is_ours) return use([this] { return CheckCollision<L>(set_1_, pose_1_, set_2_, pose_2_); });
    if (query.is_check) {
      return use([this] { return PlainCollision(*set_1_.plain, pose_1_, *set_2_.plain, pose_2_); });
    }
    dgd::Settings<double> settings;
    if (query.tolerance > 0) settings.relative_tolerance = query.tolerance;
    if (query.max_iterations > 0) settings.max_iterations = query.max_iterations;
    // Each repeat is the second query again, not a third.
    if (is_ours) {
      return use(
          [this, settings, start = query.is_warm ? warm_start_ : dgd::WarmStart<double, L>(), is_warm = query.is_warm] {
            if (!is_warm) return SolveGrowth<L>(set_1_, pose_1_, set_2_, pose_2_, settings, nullptr);
            dgd::WarmStart<double, L> state = start;
            const Result result = SolveGrowth<L>(set_1_, pose_1_, set_2_, pose_2_, settings, &state);
            Keep(state);
            return result;
          });
    }
    return use([this, settings, is_warm = query.is_warm] {
      PlainState<L> state;
      if (is_warm) state = plain_state_;
      const Result result =
          PlainGrowthDistance(*set_1_.plain, pose_1_, *set_2_.plain, pose_2_, is_warm ? &state : nullptr, settings);
      Keep(state);
      return result;
    });
  }

  GrowthAnswer Judge(const Result& result) const { return CertifiedAnswer(judge_, result); }

  GrowthAnswer Judge(dgd::Status status) const {
    const Result truth = SolveGrowth<L>(set_1_, pose_1_, set_2_, pose_2_, {}, nullptr);
    constexpr double kTouch = 2 * dgd::kSqrtEpsilon<double>;  // Both checks' tolerance, and that of the truth.
    const bool may_touch = truth.lower_bound <= 1 + kTouch && truth.upper_bound >= 1 - kTouch;
    const bool is_right = status == dgd::Status::kSeparated   ? truth.upper_bound > 1
                          : status == dgd::Status::kColliding ? truth.lower_bound <= 1
                                                              : status == dgd::Status::kTouching && may_touch;
    GrowthAnswer answer;
    answer.sample.is_failure = !is_right;
    return answer;
  }

  dgd_test::PairNumbers numbers_;
  SolverSet<L> set_1_, set_2_;
  Pose pose_1_, pose_2_;
  dgd::WarmStart<double, L> warm_start_;
  PlainState<L> plain_state_;
  dgd_test::AnyPair<double, L> judge_;
};

}  // namespace

std::unique_ptr<GrowthPair> MakeGrowthPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  if (dgd_test::InfoOf(set_1.type).dimension == 2) return std::make_unique<SolverPair<2>>(set_1, set_2);
  return std::make_unique<SolverPair<3>>(set_1, set_2);
}

}  // namespace dgd_bench
