// A core set of any type behind one name, so that a test can run over all pairs of types. Instantiates the solver for
// every pair once, in any_set.cc.
#pragma once

#include <variant>

#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polytope.h"
#include "dgd/shapes/segment.h"
#include "dgd/shapes/triangle.h"
#include "support/reference_set.h"

namespace dgd_test {

template <class S>
using AnySet =
    std::variant<dgd::RoundedSet<dgd::Point<S>>, dgd::RoundedSet<dgd::Segment<S>>, dgd::RoundedSet<dgd::Triangle<S>>,
                 dgd::RoundedSet<dgd::Box<S>>, dgd::RoundedSet<dgd::Cylinder<S>>, dgd::RoundedSet<dgd::Cone<S>>,
                 dgd::RoundedSet<dgd::Polytope<S>>>;

template <class S>
AnySet<S> MakeSet(const ReferenceSet& set);

template <class S>
dgd::Pose<S> MakePose(const ReferencePose& pose) {
  return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
}

/// Two sets and their poses, ready to be asked; made from the numbers of a ReferencePair.
template <class S>
struct SolverPair {
  AnySet<S> set_1, set_2;
  dgd::Pose<S> pose_1, pose_2;

  explicit SolverPair(const ReferencePair& pair)
      : set_1(MakeSet<S>(pair.set_1)),
        set_2(MakeSet<S>(pair.set_2)),
        pose_1(MakePose<S>(pair.pose_1)),
        pose_2(MakePose<S>(pair.pose_2)) {}

  dgd::Result<S> GrowthDistance(const dgd::Settings<S>& settings = {}, dgd::WarmStart<S>* warm_start = nullptr) const;
  dgd::CollisionResult<S> DetectCollision(const dgd::Settings<S>& settings = {},
                                          dgd::WarmStart<S>* warm_start = nullptr) const;
  dgd::Certificate Certify(const dgd::Result<S>& result) const;

  /// Distance of a world point to a set, 0 inside; metres.
  S DistanceTo1(const dgd::Vector3<S>& point) const { return Distance(set_1, pose_1, point); }
  S DistanceTo2(const dgd::Vector3<S>& point) const { return Distance(set_2, pose_2, point); }
  dgd::Vector3<S> Center1() const { return Center(set_1, pose_1); }
  dgd::Vector3<S> Center2() const { return Center(set_2, pose_2); }
  /// Of the cores and the radii.
  S Inradius1() const { return Inradius(set_1); }
  S Inradius2() const { return Inradius(set_2); }

 private:
  static S Distance(const AnySet<S>& set, const dgd::Pose<S>& pose, const dgd::Vector3<S>& point);
  static dgd::Vector3<S> Center(const AnySet<S>& set, const dgd::Pose<S>& pose);
  static S Inradius(const AnySet<S>& set);
};

}  // namespace dgd_test
