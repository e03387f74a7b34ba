// The queries of two types of sets, compiled in a file of their own for each pair of types.
#pragma once

#include "dgd/any_set.h"

namespace dgd {

/// See any_set.h. The definitions, which only those files see, are in pair_solver_definitions.h.
template <class Set1, class Set2>
struct PairSolver {
  static Result<double> GrowthDistance(const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2,
                                       const Pose<double>& pose_2, const Settings<double>& settings,
                                       WarmStart<double>* warm_start);
  static CollisionResult<double> DetectCollision(const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2,
                                                 const Pose<double>& pose_2, const Settings<double>& settings,
                                                 WarmStart<double>* warm_start);
  static SignedDistanceResult<double> SignedDistance(const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2,
                                                     const Pose<double>& pose_2, const Result<double>& growth,
                                                     const WarmStart<double>* warm_start,
                                                     const Settings<double>& settings, WarmStart<double>* follow);
  static SignedDistanceResult<double> SignedDistance(const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2,
                                                     const Pose<double>& pose_2, const Settings<double>& settings,
                                                     WarmStart<double>* follow);
  static SignedDistanceResult<double> UpdateDistance(const Set1& set_1, const Pose<double>& pose_1, const Set2& set_2,
                                                     const Pose<double>& pose_2, const Settings<double>& settings,
                                                     WarmStart<double>& state);
  static SignedDistanceResult<double> UpdateOnReferenceFace(const Set1& set_1, const Pose<double>& pose_1,
                                                            const Set2& set_2, const Pose<double>& pose_2,
                                                            const Settings<double>& settings, double angular_tolerance,
                                                            ReferenceSide side, WarmStart<double>& state,
                                                            FacingFaces<double>& facing);
};

using PolytopeSet = RoundedSet<PolytopeCore>;
using CurvedSet = RoundedSet<CurvedCore>;
using CustomSet = RoundedSet<CustomCore>;

extern template struct PairSolver<PolytopeSet, PolytopeSet>;
extern template struct PairSolver<PolytopeSet, CurvedSet>;
extern template struct PairSolver<CurvedSet, PolytopeSet>;
extern template struct PairSolver<CurvedSet, CurvedSet>;
extern template struct PairSolver<CustomSet, CustomSet>;

}  // namespace dgd
