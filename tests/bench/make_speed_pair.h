// The pairs of types of MakeSpeedPair(); for its translation units, one for each dimension.
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

#include "bench/typed_speed_pair.h"
#include "support/pairs/with_core.h"

namespace dgd_bench {

/// Types that all meet each other, in the order in which they come first in a pair.
template <class... Cores>
struct CoreList {
  template <class Core>
  static constexpr std::size_t PlaceOf() {
    std::size_t place = 0;
    const bool is_in_list = ((std::same_as<Core, Cores> || (++place, false)) || ...);
    return is_in_list ? place : sizeof...(Cores);
  }

  template <class Core1, class Core2>
  static constexpr bool kHasPair = PlaceOf<Core1>() <= PlaceOf<Core2>() && PlaceOf<Core2>() < sizeof...(Cores);
};

/// A type and those that it meets.
template <class First, class... Seconds>
struct CoreAndPartners {
  template <class Core1, class Core2>
  static constexpr bool kHasPair = std::same_as<Core1, First> && (std::same_as<Core2, Seconds> || ...);
};

/// A pair with its sets in the other order.
template <int L>
class SwappedSpeedPair final : public SpeedPair<L> {
 public:
  explicit SwappedSpeedPair(std::unique_ptr<SpeedPair<L>> pair) : pair_(std::move(pair)) {}

  double Extent() const override { return pair_->Extent(); }
  void MoveTo(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& last_pose_2,
              const dgd_test::PoseNumbers& pose_2) override {
    // Seen from set 2, it is set 1 that has moved.
    const Eigen::Matrix3d turn = pose_2.rotation * last_pose_2.rotation.transpose();
    const dgd_test::PoseNumbers last_pose_1{turn * pose_1.rotation,
                                            pose_2.translation + turn * (pose_1.translation - last_pose_2.translation)};
    pair_->MoveTo(pose_2, last_pose_1, pose_1);
  }
  bool Takes(const SpeedQuestion& question) const override { return pair_->Takes(question); }
  double Time(const SpeedQuestion& question, int repeats) const override { return pair_->Time(question, repeats); }
  SpeedAnswer Judge(const SpeedQuestion& question) const override { return pair_->Judge(question); }

 private:
  std::unique_ptr<SpeedPair<L>> pair_;
};

/// Null for types that are in none of the lists.
/// @tparam Lists  CoreList or CoreAndPartners each.
template <int L, class... Lists>
std::unique_ptr<SpeedPair<L>> MakeOf(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using Made = std::unique_ptr<SpeedPair<L>>;
  // Only their types count here.
  return dgd_test::WithCore<double, L>(set_1, [&]<class Core1>(const Core1&) -> Made {
    return dgd_test::WithCore<double, L>(set_2, [&]<class Core2>(const Core2&) -> Made {
      if constexpr ((Lists::template kHasPair<Core1, Core2> || ...)) {
        return std::make_unique<TypedSpeedPair<Core1, Core2>>(set_1, set_2);
      } else if constexpr ((Lists::template kHasPair<Core2, Core1> || ...)) {
        return std::make_unique<SwappedSpeedPair<L>>(std::make_unique<TypedSpeedPair<Core2, Core1>>(set_2, set_1));
      } else {
        return nullptr;
      }
    });
  });
}

}  // namespace dgd_bench
