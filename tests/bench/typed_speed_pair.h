// SpeedPair for one pair of types.
#pragma once

#include <type_traits>
#include <utility>

#include "bench/speed_pair.h"
#include "bench/stopwatch.h"
#include "bench/textbook/plain_algorithm.h"
#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "support/extent.h"

namespace dgd_bench {

/// Where a core lives: large ones beside the set, as an app's shared meshes do.
template <class Core>
class CoreHolder {
 public:
  using Set = dgd::RoundedSet<std::conditional_t<std::is_trivially_copyable_v<Core>, Core, dgd::CoreReference<Core>>>;

  CoreHolder(Core core, double radius) : core_(std::move(core)), radius_(radius) {}
  Set MakeSet() const { return Set{core_, radius_}; }
  double Extent() const { return dgd_test::Extent(core_, radius_); }

 private:
  Core core_;
  double radius_;
};

template <class Core1, class Core2>
class TypedSpeedPair final : public SpeedPair<dgd::kDimension<Core1>> {
 public:
  static constexpr int L = dgd::kDimension<Core1>;
  using Pose = dgd::Pose<double, L>;
  using Result = dgd::Result<double, L>;

  TypedSpeedPair(Core1 core_1, double radius_1, Core2 core_2, double radius_2)
      : holder_1_(std::move(core_1), radius_1), holder_2_(std::move(core_2), radius_2) {}

  double Extent() const override { return holder_1_.Extent() + holder_2_.Extent(); }

  void MoveTo(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& last_pose_2,
              const dgd_test::PoseNumbers& pose_2) override {
    pose_1_ = PoseFrom(pose_1);
    pose_2_ = PoseFrom(last_pose_2);
    warm_start_ = {};
    dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, {}, &warm_start_);
    plain_state_ = {};
    PlainGrowthDistance(plain_1_, pose_1_, plain_2_, pose_2_, &plain_state_);
    pose_2_ = PoseFrom(pose_2);
  }

  double Time(SpeedMethod method, int repeats) const override {
    return Ask(method, [&](const auto& ask) { return MeanMicroseconds(repeats, [&] { Keep(ask()); }); });
  }

  SpeedAnswer Judge(SpeedMethod method) const override {
    return Ask(method, [&](const auto& ask) { return Judge(ask()); });
  }

 private:
  static Pose PoseFrom(const dgd_test::PoseNumbers& pose) {
    return {pose.rotation.topLeftCorner<L, L>(), pose.translation.head<L>()};
  }

  template <class Use>
  auto Ask(SpeedMethod method, const Use& use) const {
    switch (method) {
      case SpeedMethod::kCold:
        return use([this] { return Cold(); });
      case SpeedMethod::kPlainCold:
        return use([this] { return PlainGrowthDistance(plain_1_, pose_1_, plain_2_, pose_2_); });
      case SpeedMethod::kWarm:
        return use([this] {
          dgd::WarmStart<double, L> warm_start = warm_start_;  // Each repeat is the second query again, not a third.
          const Result result = dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_, {}, &warm_start);
          Keep(warm_start);
          return result;
        });
      case SpeedMethod::kPlainWarm:
        return use([this] {
          PlainState<L> state = plain_state_;
          const Result result = PlainGrowthDistance(plain_1_, pose_1_, plain_2_, pose_2_, &state);
          Keep(state);
          return result;
        });
      case SpeedMethod::kCheck:
        return use([this] { return dgd::DetectCollision(set_1_, pose_1_, set_2_, pose_2_).status; });
      case SpeedMethod::kPlainCheck:
        break;
    }
    return use([this] { return PlainCollision(plain_1_, pose_1_, plain_2_, pose_2_); });
  }

  Result Cold() const { return dgd::GrowthDistance(set_1_, pose_1_, set_2_, pose_2_); }

  SpeedAnswer Judge(const Result& result) const {
    const dgd::Certificate certificate = dgd::Certify(set_1_, pose_1_, set_2_, pose_2_, result);
    const double between = (pose_2_ * set_2_.core.Center() - pose_1_ * set_1_.core.Center()).norm();
    return {result.iterations, certificate.relative_gap, certificate.primal_infeasibility / (Extent() + between),
            result.status != dgd::Status::kOptimal};
  }

  SpeedAnswer Judge(dgd::Status status) const {
    const Result truth = Cold();
    constexpr double kTouch = 2 * dgd::kSqrtEpsilon<double>;  // Both checks' tolerance, and that of the truth.
    const bool may_touch = truth.lower_bound <= 1 + kTouch && truth.upper_bound >= 1 - kTouch;
    const bool is_right = status == dgd::Status::kSeparated   ? truth.upper_bound > 1
                          : status == dgd::Status::kColliding ? truth.lower_bound <= 1
                                                              : status == dgd::Status::kTouching && may_touch;
    return {.is_failure = !is_right};
  }

  CoreHolder<Core1> holder_1_;
  CoreHolder<Core2> holder_2_;
  typename CoreHolder<Core1>::Set set_1_ = holder_1_.MakeSet();
  typename CoreHolder<Core2>::Set set_2_ = holder_2_.MakeSet();
  SupportFunctionOf<typename CoreHolder<Core1>::Set::Core> plain_1_{set_1_};
  SupportFunctionOf<typename CoreHolder<Core2>::Set::Core> plain_2_{set_2_};
  Pose pose_1_, pose_2_;
  dgd::WarmStart<double, L> warm_start_;
  PlainState<L> plain_state_;
};

}  // namespace dgd_bench
