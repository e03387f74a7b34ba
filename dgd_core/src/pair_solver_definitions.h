// What PairSolver's functions do. For the files that instantiate it.
#pragma once

#include "dgd/contact/reference_face.h"
#include "dgd/growth_distance.h"
#include "dgd/signed_distance.h"
#include "pair_solver.h"

namespace dgd {

template <class Set1, class Set2>
Result<double> PairSolver<Set1, Set2>::GrowthDistance(const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2,
                                                      const Pose<double>& pose_2, const Settings<double>& settings,
                                                      WarmStart<double>* warm_start) {
  return dgd::GrowthDistance(set_1, pose_1, set_2, pose_2, settings, warm_start);
}

template <class Set1, class Set2>
CollisionResult<double> PairSolver<Set1, Set2>::DetectCollision(const Set1& set_1, const Pose<double>& pose_1,
                                                                const Set2& set_2, const Pose<double>& pose_2,
                                                                const Settings<double>& settings,
                                                                WarmStart<double>* warm_start) {
  return dgd::DetectCollision(set_1, pose_1, set_2, pose_2, settings, warm_start);
}

template <class Set1, class Set2>
SignedDistanceResult<double> PairSolver<Set1, Set2>::SignedDistance(const Set1& set_1, const Pose<double>& pose_1,
                                                                    const Set2& set_2, const Pose<double>& pose_2,
                                                                    const Result<double>& growth,
                                                                    const WarmStart<double>* warm_start,
                                                                    const Settings<double>& settings,
                                                                    WarmStart<double>* follow) {
  return dgd::SignedDistance(set_1, pose_1, set_2, pose_2, growth, warm_start, settings, follow);
}

template <class Set1, class Set2>
SignedDistanceResult<double> PairSolver<Set1, Set2>::SignedDistance(const Set1& set_1, const Pose<double>& pose_1,
                                                                    const Set2& set_2, const Pose<double>& pose_2,
                                                                    const Settings<double>& settings,
                                                                    WarmStart<double>* follow) {
  return dgd::SignedDistance(set_1, pose_1, set_2, pose_2, settings, follow);
}

template <class Set1, class Set2>
SignedDistanceResult<double> PairSolver<Set1, Set2>::UpdateDistance(const Set1& set_1, const Pose<double>& pose_1,
                                                                    const Set2& set_2, const Pose<double>& pose_2,
                                                                    const Settings<double>& settings,
                                                                    WarmStart<double>& state) {
  return dgd::UpdateDistance(set_1, pose_1, set_2, pose_2, settings, state);
}

template <class Set1, class Set2>
SignedDistanceResult<double> PairSolver<Set1, Set2>::UpdateOnReferenceFace(
    const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2, const Pose<double>& pose_2,
    const Settings<double>& settings, double angular_tolerance, ReferenceSide side, WarmStart<double>& state,
    FacingFaces<double>& facing) {
  return dgd::UpdateOnReferenceFace(set_1, pose_1, set_2, pose_2, settings, angular_tolerance, side, state, facing);
}

}  // namespace dgd
