// The pairs of types of MakeSpeedPair(); for its translation units, one for each dimension.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "bench/typed_speed_pair.h"
#include "support/pairs/with_core.h"

namespace dgd_bench {

/// Types that all meet each other, in the order in which they come first in a pair.
template <dgd_test::SetType... kTypes>
struct TypeList {
  static constexpr std::array kAll{kTypes...};

  static constexpr bool HasPair(dgd_test::SetType type_1, dgd_test::SetType type_2) {
    const auto first = std::find(kAll.begin(), kAll.end(), type_1);
    return std::find(first, kAll.end(), type_2) != kAll.end();
  }
};

/// A type and those that it meets.
template <dgd_test::SetType kFirst, dgd_test::SetType... kSeconds>
struct TypeAndPartners {
  static constexpr bool HasPair(dgd_test::SetType type_1, dgd_test::SetType type_2) {
    return type_1 == kFirst && ((type_2 == kSeconds) || ...);
  }
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
/// @tparam Lists  TypeList or TypeAndPartners each.
template <int L, class... Lists>
std::unique_ptr<SpeedPair<L>> MakeOf(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) {
  using dgd_test::SetType;
  using Made = std::unique_ptr<SpeedPair<L>>;
  return dgd_test::WithType<L>(set_1.type, [&]<SetType kType1>() -> Made {
    return dgd_test::WithType<L>(set_2.type, [&]<SetType kType2>() -> Made {
      if constexpr ((Lists::HasPair(kType1, kType2) || ...)) {
        return std::make_unique<TypedSpeedPair<kType1, kType2>>(set_1, set_2);
      } else if constexpr ((Lists::HasPair(kType2, kType1) || ...)) {
        return std::make_unique<SwappedSpeedPair<L>>(std::make_unique<TypedSpeedPair<kType2, kType1>>(set_2, set_1));
      } else {
        return nullptr;
      }
    });
  });
}

}  // namespace dgd_bench
