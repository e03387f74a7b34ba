// The bodies of any_pair.h, for the four files that instantiate them: one file with all of them takes the compiler a
// quarter longer, and one processor.
#pragma once

#include <algorithm>

#include "support/extent.h"
#include "support/pairs/any_pair.h"
#include "support/pairs/make_set.h"

namespace dgd_test {
namespace any_pair_internal {

template <class S, int L>
dgd::Pose<S, L> PoseFrom(const PoseNumbers& pose) {
  return {pose.rotation.topLeftCorner<L, L>().template cast<S>(), pose.translation.head<L>().template cast<S>()};
}

}  // namespace any_pair_internal

template <class S, int L>
AnyPair<S, L>::AnyPair(const PairNumbers& numbers)
    : set_1_(MakeSet<S, L>(numbers.set_1)), set_2_(MakeSet<S, L>(numbers.set_2)) {
  MoveTo(numbers.pose_1, numbers.pose_2);
}

template <class S, int L>
void AnyPair<S, L>::MoveTo(const PoseNumbers& pose_1, const PoseNumbers& pose_2) {
  pose_1_ = any_pair_internal::PoseFrom<S, L>(pose_1);
  pose_2_ = any_pair_internal::PoseFrom<S, L>(pose_2);
}

template <class S, int L>
dgd::Result<S, L> AnyPair<S, L>::GrowthDistance(const dgd::Settings<S>& settings, dgd::WarmStart<S, L>* warm_start,
                                                const Observer& observer) const {
  const auto tell = [&observer](const dgd::Iterate<S, L>& iterate) {
    if (observer) observer(iterate);
  };
  return std::visit(
      [&]<class Set1, class Set2>(const Set1& a, const Set2& b) {
        // An observed query is another one, and these alone differ; the others need not be compiled twice.
        if constexpr (dgd::kHasPortalRefinement<Set1, Set2>) {
          if (!observer) return dgd::GrowthDistance(a, pose_1_, b, pose_2_, settings, warm_start);
        }
        return dgd::GrowthDistance(a, pose_1_, b, pose_2_, settings, warm_start, tell);
      },
      set_1_, set_2_);
}

template <class S, int L>
dgd::CollisionResult<S, L> AnyPair<S, L>::DetectCollision(const dgd::Settings<S>& settings,
                                                          dgd::WarmStart<S, L>* warm_start) const {
  return std::visit(
      [&](const auto& a, const auto& b) { return dgd::DetectCollision(a, pose_1_, b, pose_2_, settings, warm_start); },
      set_1_, set_2_);
}

template <class S, int L>
dgd::SignedDistanceResult<S> AnyPair<S, L>::SignedDistance(const dgd::Result<S>& growth,
                                                           const dgd::WarmStart<S>* warm_start,
                                                           const dgd::Settings<S>& settings,
                                                           dgd::WarmStart<S>* follow) const requires(L == 3) {
  if constexpr (L == 3) {  // Clang 14 instantiates this in the plane all the same.
    return std::visit(
        [&](const auto& a, const auto& b) {
          return dgd::SignedDistance(a, pose_1_, b, pose_2_, growth, warm_start, settings, follow);
        },
        set_1_, set_2_);
  } else {
    return {};
  }
}

template <class S, int L>
dgd::SignedDistanceResult<S> AnyPair<S, L>::UpdateDistance(const dgd::Settings<S>& settings,
                                                           dgd::WarmStart<S>& state) const requires(L == 3) {
  if constexpr (L == 3) {  // As above.
    return std::visit(
        [&](const auto& a, const auto& b) { return dgd::UpdateDistance(a, pose_1_, b, pose_2_, settings, state); },
        set_1_, set_2_);
  } else {
    return {};
  }
}

template <class S, int L>
dgd::TimeOfImpactResult<S> AnyPair<S, L>::TimeOfImpact(const dgd::Motion<S>& motion_1, const dgd::Motion<S>& motion_2,
                                                       const dgd::SweepSettings<S>& settings) const requires(L == 3) {
  if constexpr (L == 3) {  // As above.
    return std::visit(
        [&](const auto& a, const auto& b) { return dgd::TimeOfImpact(a, motion_1, b, motion_2, settings); }, set_1_,
        set_2_);
  } else {
    return {};
  }
}

template <class S, int L>
dgd::Certificate AnyPair<S, L>::Certify(const dgd::Result<S, L>& result) const {
  return std::visit([&](const auto& a, const auto& b) { return dgd::Certify(a, pose_1_, b, pose_2_, result); }, set_1_,
                    set_2_);
}

template <class S, int L>
dgd::SignedDistanceCertificate AnyPair<S, L>::Certify(const dgd::SignedDistanceResult<S>& result) const
    requires(L == 3) {
  if constexpr (L == 3) {  // As above.
    return std::visit([&](const auto& a, const auto& b) { return dgd::Certify(a, pose_1_, b, pose_2_, result); },
                      set_1_, set_2_);
  } else {
    return {};
  }
}

template <class S, int L>
auto AnyPair<S, L>::SupportFromCenter(Which which, const Point& direction) const -> Point {
  const dgd::SquareMatrix<double, L> rotation = PoseOf(which).rotation.template cast<double>();
  const Point local_direction = rotation.transpose() * direction;
  return std::visit(
      [&](const auto& set) -> Point {
        const dgd::Vector<S, L> offset = set.core.Support(local_direction.template cast<S>()).point - set.core.Center();
        return rotation * offset.template cast<double>() + double(set.radius) * direction;
      },
      SetOf(which));
}

template <class S, int L>
auto AnyPair<S, L>::Center(Which which) const -> Point {
  const dgd::Vector<S, L> center = std::visit([](const auto& set) { return set.core.Center(); }, SetOf(which));
  return PoseOf(which).rotation.template cast<double>() * center.template cast<double>() +
         PoseOf(which).translation.template cast<double>();
}

template <class S, int L>
double AnyPair<S, L>::Inradii() const {
  const auto inradius = [](const auto& set) { return double(set.core.Inradius()) + double(set.radius); };
  return std::visit(inradius, set_1_) + std::visit(inradius, set_2_);
}

template <class S, int L>
double AnyPair<S, L>::Extent() const {
  const auto extent = [](const auto& set) { return dgd_test::Extent(set.core, double(set.radius)); };
  return std::max(std::visit(extent, set_1_), std::visit(extent, set_2_));
}

template <class S, int L>
double AnyPair<S, L>::Offset() const {
  const auto offset = [](const auto& set) { return double(set.core.Center().cwiseAbs().maxCoeff()); };
  return std::max(std::visit(offset, set_1_), std::visit(offset, set_2_));
}

}  // namespace dgd_test
