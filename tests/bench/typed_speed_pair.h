// SpeedPair for one pair of types.
#pragma once

#include <limits>
#include <type_traits>
#include <utility>

#include "bench/speed_pair.h"
#include "bench/stopwatch.h"
#include "bench/yardsticks.h"
#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "support/extent.h"
#include "support/pairs/with_core.h"

namespace dgd_bench {

/// Where a core lives: large ones beside the set, as an app's shared meshes do.
template <class Core>
class CoreHolder {
 public:
  using Scalar = typename Core::Scalar;
  using Set = dgd::RoundedSet<std::conditional_t<std::is_trivially_copyable_v<Core>, Core, dgd::CoreReference<Core>>>;
  static constexpr int L = dgd::kDimension<Core>;

  CoreHolder(Core core, double radius) : core_(std::move(core)), radius_(static_cast<Scalar>(radius)) {}

  Set MakeSet() const { return Set{core_, radius_}; }
  double Extent() const { return dgd_test::Extent(core_, radius_); }

 private:
  Core core_;
  Scalar radius_;
};

/// The sets of one scalar in their poses, asked by the solver.
template <class Scalar, dgd_test::SetType kType1, dgd_test::SetType kType2>
class SolverSide {
 public:
  using S = Scalar;
  using Holder1 = CoreHolder<dgd_test::CoreOf<S, kType1>>;
  using Holder2 = CoreHolder<dgd_test::CoreOf<S, kType2>>;
  using Set1 = typename Holder1::Set;
  using Set2 = typename Holder2::Set;
  static constexpr int L = Holder1::L;
  using Pose = dgd::Pose<S, L>;

  SolverSide(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2)
      : holder_1_(dgd_test::MakeCore<S, kType1>(set_1), set_1.radius),
        holder_2_(dgd_test::MakeCore<S, kType2>(set_2), set_2.radius) {}

  const Set1& set_1() const { return set_1_; }
  const Set2& set_2() const { return set_2_; }
  const Pose& pose_1() const { return pose_1_; }
  const Pose& pose_2() const { return pose_2_; }
  double Extent() const { return holder_1_.Extent() + holder_2_.Extent(); }

  void MoveTo(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& pose_2) {
    pose_1_ = PoseFrom(pose_1);
    pose_2_ = PoseFrom(pose_2);
  }
  /// Warm starts come from here.
  void Remember() {
    warm_start_ = {};
    dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, {}, &warm_start_);
  }

  dgd::Result<S, L> Cold(const dgd::Settings<S>& settings) const {
    return dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, settings);
  }
  dgd::Result<S, L> Warm(const dgd::Settings<S>& settings) const {
    dgd::WarmStart<S, L> warm_start = warm_start_;  // Each repeat is the second query again, not a third.
    const dgd::Result<S, L> result = dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, settings, &warm_start);
    Keep(warm_start);
    return result;
  }
  dgd::Status Check() const { return dgd::DetectCollision(set_1_, pose_1_, set_2_, pose_2_).status; }

 private:
  static Pose PoseFrom(const dgd_test::PoseNumbers& pose) {
    return {pose.rotation.topLeftCorner<L, L>().template cast<S>(), pose.translation.head<L>().template cast<S>()};
  }

  Holder1 holder_1_;
  Holder2 holder_2_;
  Set1 set_1_ = holder_1_.MakeSet();
  Set2 set_2_ = holder_2_.MakeSet();
  Pose pose_1_, pose_2_;
  dgd::WarmStart<S, L> warm_start_;
};

template <dgd_test::SetType kType1, dgd_test::SetType kType2>
class TypedSpeedPair final : public SpeedPair<dgd_test::InfoOf(kType1).dimension> {
 public:
  static constexpr int L = dgd_test::InfoOf(kType1).dimension;
  using Result = dgd::Result<double, L>;

  TypedSpeedPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2)
      : ours_(set_1, set_2), ours_float_(set_1, set_2) {}

  double Extent() const override { return ours_.Extent(); }

  void MoveTo(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& last_pose_2,
              const dgd_test::PoseNumbers& pose_2) override {
    ours_.MoveTo(pose_1, last_pose_2);
    ours_.Remember();
    ours_float_.MoveTo(pose_1, last_pose_2);
    ours_float_.Remember();
    yardsticks_.Remember(ours_.pose_1(), ours_.pose_2());
    ours_.MoveTo(pose_1, pose_2);
    ours_float_.MoveTo(pose_1, pose_2);
  }

  bool Takes(const SpeedQuestion& question) const override {
    switch (question.method) {
      case SpeedMethod::kOurs:
        return true;
      case SpeedMethod::kOursFloat:
        return !question.is_check;
      default:
        return yardsticks_.Takes(question);
    }
  }

  double Time(const SpeedQuestion& question, int repeats) const override {
    return Ask(question, [&](const auto& ask) { return MeanMicroseconds(repeats, [&] { Keep(ask()); }); });
  }

  SpeedAnswer Judge(const SpeedQuestion& question) const override {
    return Ask(question, [&](const auto& ask) { return Judge(ask()); });
  }

 private:
  template <class Use>
  auto Ask(const SpeedQuestion& question, const Use& use) const {
    switch (question.method) {
      case SpeedMethod::kOurs:
        if (question.is_check) return use([this] { return ours_.Check(); });
        return AskSolver(ours_, question, use);
      case SpeedMethod::kOursFloat:
        return AskSolver(ours_float_, question, use);
      default:
        return yardsticks_.Ask(question, ours_.pose_1(), ours_.pose_2(), use);
    }
  }

  template <class Side, class Use>
  static auto AskSolver(const Side& side, const SpeedQuestion& question, const Use& use) {
    using S = typename Side::S;
    dgd::Settings<S> settings;
    if (question.tolerance > 0) settings.relative_tolerance = static_cast<S>(question.tolerance);
    settings.second_order = question.second_order;
    settings.rounding = question.rounding;
    if (question.start == SpeedQuestion::Start::kWarm) return use([&side, settings] { return side.Warm(settings); });
    return use([&side, settings] { return side.Cold(settings); });
  }

  /// Of the sets in double, whatever the answer is of.
  template <class S>
  SpeedAnswer Judge(const dgd::Result<S, L>& result) const {
    const dgd::Certificate certificate =
        dgd::Certify(ours_.set_1(), ours_.pose_1(), ours_.set_2(), ours_.pose_2(), InDouble(result));
    return {.iterations = result.iterations,
            .relative_gap = certificate.relative_gap,
            .primal_infeasibility = certificate.primal_infeasibility,
            .dual_infeasibility = certificate.dual_infeasibility,
            .is_failure = result.status != dgd::Status::kOptimal,
            .lower_bound = double(result.lower_bound),
            .upper_bound = double(result.upper_bound)};
  }

  template <class S>
  static Result InDouble(const dgd::Result<S, L>& result) {
    Result in_double;
    in_double.status = result.status;
    in_double.iterations = result.iterations;
    in_double.lower_bound = result.lower_bound;
    in_double.upper_bound = result.upper_bound;
    in_double.normal = result.normal.template cast<double>();
    in_double.separation = result.separation;
    in_double.witness_1 = result.witness_1.template cast<double>();
    in_double.witness_2 = result.witness_2.template cast<double>();
    return in_double;
  }

  SpeedAnswer Judge(dgd::Status status) const {
    const Result truth = ours_.Cold({});
    constexpr double kTouch = 2 * dgd::kSqrtEpsilon<double>;  // Both checks' tolerance, and that of the truth.
    const bool may_touch = truth.lower_bound <= 1 + kTouch && truth.upper_bound >= 1 - kTouch;
    const bool is_right = status == dgd::Status::kSeparated   ? truth.upper_bound > 1
                          : status == dgd::Status::kColliding ? truth.lower_bound <= 1
                                                              : status == dgd::Status::kTouching && may_touch;
    return {.is_failure = !is_right};
  }

  using Ours = SolverSide<double, kType1, kType2>;

  Ours ours_;
  SolverSide<float, kType1, kType2> ours_float_;
  Yardsticks<typename Ours::Set1::Core, typename Ours::Set2::Core> yardsticks_{ours_.set_1(), ours_.set_2()};
};

}  // namespace dgd_bench
