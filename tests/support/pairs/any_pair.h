// Two sets of any types and their poses behind one interface, for which the solver is compiled once and not in every
// test that asks.
#pragma once

#include <functional>
#include <utility>

#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/signed_distance.h"
#include "dgd/signed_distance_certificate.h"
#include "dgd/time_of_impact.h"
#include "support/pairs/erased_core.h"
#include "support/pairs/set_numbers.h"

namespace dgd_test {

enum class Which { kFirst, kSecond };

template <class S, int L>
class AnyPair {
 public:
  using Point = dgd::Vector<double, L>;
  using Observer = std::function<void(const dgd::Iterate<S, L>&)>;

  AnyPair(AnySet<S, L> set_1, const dgd::Pose<S, L>& pose_1, AnySet<S, L> set_2, const dgd::Pose<S, L>& pose_2)
      : set_1_(std::move(set_1)), set_2_(std::move(set_2)), pose_1_(pose_1), pose_2_(pose_2) {}
  /// The pair that the numbers say, both of dimension L. Throws std::invalid_argument otherwise.
  explicit AnyPair(const PairNumbers& numbers);

  void MoveTo(const PoseNumbers& pose_1, const PoseNumbers& pose_2);
  void MoveTo(const dgd::Pose<S, L>& pose_1, const dgd::Pose<S, L>& pose_2) {
    pose_1_ = pose_1;
    pose_2_ = pose_2;
  }

  /// @param observer  May be empty: then it costs a comparison in each iteration.
  dgd::Result<S, L> GrowthDistance(const dgd::Settings<S>& settings = {}, dgd::WarmStart<S, L>* warm_start = nullptr,
                                   const Observer& observer = {}) const;
  dgd::CollisionResult<S, L> DetectCollision(const dgd::Settings<S>& settings = {},
                                             dgd::WarmStart<S, L>* warm_start = nullptr) const;
  dgd::SignedDistanceResult<S> SignedDistance(const dgd::Result<S>& growth,
                                              const dgd::WarmStart<S>* warm_start = nullptr,
                                              const dgd::Settings<S>& settings = {},
                                              dgd::WarmStart<S>* follow = nullptr) const requires(L == 3);
  dgd::SignedDistanceResult<S> UpdateDistance(const dgd::Settings<S>& settings, dgd::WarmStart<S>& state) const
      requires(L == 3);
  /// The motions' starts are the poses, whatever MoveTo() said.
  dgd::TimeOfImpactResult<S> TimeOfImpact(const dgd::Motion<S>& motion_1, const dgd::Motion<S>& motion_2,
                                          const dgd::SweepSettings<S>& settings = {}) const requires(L == 3);
  dgd::Certificate Certify(const dgd::Result<S, L>& result) const;
  dgd::SignedDistanceCertificate Certify(const dgd::SignedDistanceResult<S>& result) const requires(L == 3);

  /// A farthest point of the set along a unit vector, in the world, from the set's centre.
  Point SupportFromCenter(Which which, const Point& direction) const;
  /// Of the core, in the world.
  Point Center(Which which) const;
  /// Of the two sets' inradii, metres.
  double Inradii() const;
  /// The longer diagonal of the two sets' bounding boxes in their own frames, metres.
  double Extent() const;
  /// The largest coordinate of the two centres in their own frames, metres.
  double Offset() const;

 private:
  const AnySet<S, L>& SetOf(Which which) const { return which == Which::kFirst ? set_1_ : set_2_; }
  const dgd::Pose<S, L>& PoseOf(Which which) const { return which == Which::kFirst ? pose_1_ : pose_2_; }

  AnySet<S, L> set_1_, set_2_;
  dgd::Pose<S, L> pose_1_, pose_2_;
};

/// Of the supporting planes along a unit vector from the first set to the second, by the support functions alone.
template <class S>
double SeparationAlong(const AnyPair<S, 3>& pair, const Eigen::Vector3d& normal) {
  return normal.dot(pair.Center(Which::kSecond) - pair.Center(Which::kFirst)) -
         normal.dot(pair.SupportFromCenter(Which::kFirst, normal)) +
         normal.dot(pair.SupportFromCenter(Which::kSecond, -normal));
}

}  // namespace dgd_test
