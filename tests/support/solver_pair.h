// The solver's sets and poses of a ReferencePair, so that a test can run over all pairs of types.
#pragma once

#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "support/pairs/any_pair.h"
#include "support/reference_set.h"

namespace dgd_test {

template <class S>
AnySet<S, 3> MakeSet(const ReferenceSet& set);

template <class S>
dgd::Pose<S> MakePose(const ReferencePose& pose) {
  return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
}

/// Two sets and their poses, ready to be asked; made from the numbers of a ReferencePair.
template <class S>
struct SolverPair {
  AnySet<S, 3> set_1, set_2;
  dgd::Pose<S> pose_1, pose_2;

  explicit SolverPair(const ReferencePair& pair)
      : set_1(MakeSet<S>(pair.set_1)),
        set_2(MakeSet<S>(pair.set_2)),
        pose_1(MakePose<S>(pair.pose_1)),
        pose_2(MakePose<S>(pair.pose_2)) {}

  dgd::Result<S> GrowthDistance(const dgd::Settings<S>& settings = {}, dgd::WarmStart<S>* warm_start = nullptr) const {
    return Pair().GrowthDistance(settings, warm_start);
  }
  /// As an observer's query is answered: by RayIntersection alone, if the sets are polytopes.
  dgd::Result<S> ObservedGrowthDistance(const dgd::Settings<S>& settings,
                                        dgd::WarmStart<S>* warm_start = nullptr) const {
    return Pair().GrowthDistance(settings, warm_start, [](const dgd::Iterate<S, 3>&) {});
  }
  dgd::CollisionResult<S> DetectCollision(const dgd::Settings<S>& settings = {},
                                          dgd::WarmStart<S>* warm_start = nullptr) const {
    return Pair().DetectCollision(settings, warm_start);
  }
  dgd::Certificate Certify(const dgd::Result<S>& result) const { return Pair().Certify(result); }

  /// Distance of a world point to a set, 0 inside; metres.
  S DistanceTo1(const dgd::Vector3<S>& point) const { return Distance(set_1, pose_1, point); }
  S DistanceTo2(const dgd::Vector3<S>& point) const { return Distance(set_2, pose_2, point); }
  dgd::Vector3<S> Center1() const { return Center(set_1, pose_1); }
  dgd::Vector3<S> Center2() const { return Center(set_2, pose_2); }
  /// Of the cores and the radii.
  S Inradius1() const { return Inradius(set_1); }
  S Inradius2() const { return Inradius(set_2); }

 private:
  AnyPair<S, 3> Pair() const { return {set_1, pose_1, set_2, pose_2}; }
  static S Distance(const AnySet<S, 3>& set, const dgd::Pose<S>& pose, const dgd::Vector3<S>& point);
  static dgd::Vector3<S> Center(const AnySet<S, 3>& set, const dgd::Pose<S>& pose);
  static S Inradius(const AnySet<S, 3>& set);
};

}  // namespace dgd_test
