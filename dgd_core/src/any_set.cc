#include "dgd/any_set.h"

#include <algorithm>
#include <type_traits>

#include "dgd/contact/half_space_patch.h"
#include "dgd/half_space_distance.h"
#include "pair_solver.h"

namespace dgd {
namespace {

/// The set behind a function pointer; refers to it.
CustomSet Erase(const CustomSet& set) { return set; }
template <class Set>
CustomSet Erase(const Set& set) {
  return {CustomCore(set.core), set.radius};
}
CustomSet Erase(const AnySet& set) {
  return set.Visit([](const auto& rounded) { return Erase(rounded); });
}

/// Calls query(set_1, set_2, settings) with the sets as pair_solver.h has them. What meets a custom core is called
/// through a function pointer, too, and the tolerance is raised to what that is accurate to.
template <class Query>
auto Dispatch(const AnySet& set_1, const AnySet& set_2, const Settings<double>& settings, const Query& query) {
  if (set_1.IsCustom() || set_2.IsCustom()) {
    Settings<double> raised = settings;
    raised.relative_tolerance = std::max({settings.relative_tolerance, set_1.Accuracy(), set_2.Accuracy()});
    return query(Erase(set_1), Erase(set_2), raised);
  }
  const auto dispatch = [&]<class Set1, class Set2>(const Set1& a, const Set2& b) { return query(a, b, settings); };
  const PolytopeSet *polytope_1 = set_1.AsPolytope(), *polytope_2 = set_2.AsPolytope();
  const CurvedSet *curved_1 = set_1.AsCurved(), *curved_2 = set_2.AsCurved();
  if (polytope_1 != nullptr) {
    return polytope_2 != nullptr ? dispatch(*polytope_1, *polytope_2) : dispatch(*polytope_1, *curved_2);
  }
  return polytope_2 != nullptr ? dispatch(*curved_1, *polytope_2) : dispatch(*curved_1, *curved_2);
}

}  // namespace

Result<double> GrowthDistance(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                              const Pose<double>& pose_2, const Settings<double>& settings,
                              WarmStart<double>* warm_start) {
  return Dispatch(set_1, set_2, settings, [&](const auto& a, const auto& b, const auto& for_pair) {
    return dgd::GrowthDistance(a, pose_1, b, pose_2, for_pair, warm_start);
  });
}

CollisionResult<double> DetectCollision(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                        const Pose<double>& pose_2, const Settings<double>& settings,
                                        WarmStart<double>* warm_start) {
  return Dispatch(set_1, set_2, settings, [&](const auto& a, const auto& b, const auto& for_pair) {
    return dgd::DetectCollision(a, pose_1, b, pose_2, for_pair, warm_start);
  });
}

SignedDistanceResult<double> SignedDistance(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                            const Pose<double>& pose_2, const Result<double>& growth,
                                            const WarmStart<double>* warm_start, const Settings<double>& settings,
                                            WarmStart<double>* follow) {
  return Dispatch(set_1, set_2, settings, [&](const auto& a, const auto& b, const auto& for_pair) {
    return dgd::SignedDistance(a, pose_1, b, pose_2, growth, warm_start, for_pair, follow);
  });
}

SignedDistanceResult<double> SignedDistance(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                            const Pose<double>& pose_2, const Settings<double>& settings,
                                            WarmStart<double>* follow) {
  return Dispatch(set_1, set_2, settings, [&](const auto& a, const auto& b, const auto& for_pair) {
    return dgd::SignedDistance(a, pose_1, b, pose_2, for_pair, follow);
  });
}

SignedDistanceResult<double> UpdateDistance(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                            const Pose<double>& pose_2, const Settings<double>& settings,
                                            WarmStart<double>& state) {
  return Dispatch(set_1, set_2, settings, [&](const auto& a, const auto& b, const auto& for_pair) {
    return dgd::UpdateDistance(a, pose_1, b, pose_2, for_pair, state);
  });
}

Gradient<double> GrowthDistanceGradient(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                        const Pose<double>& pose_2, const Result<double>& result) {
  return GrowthDistanceGradient(Erase(set_1), pose_1, Erase(set_2), pose_2, result);
}

Gradient<double> SignedDistanceGradient(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2,
                                        const Pose<double>& pose_2, const SignedDistanceResult<double>& result) {
  return SignedDistanceGradient(Erase(set_1), pose_1, Erase(set_2), pose_2, result);
}

void FindFacingFaces(const AnySet& set_1, const Pose<double>& pose_1, const AnySet& set_2, const Pose<double>& pose_2,
                     const Result<double>& result, FacingFaces<double>& facing) {
  facing.Clear();
  facing.frame = PatchFrame<double>(result);
  set_1.Visit([&](const auto& set) { FindFace(set, pose_1, result.normal, facing.frame, facing.face_1); });
  set_2.Visit([&](const auto& set) { FindFace(set, pose_2, -result.normal, facing.frame, facing.face_2); });
  facing.FindOverlap();
}

TimeOfImpactResult<double> TimeOfImpact(const AnySet& set_1, const Motion<double>& motion_1, const AnySet& set_2,
                                        const Motion<double>& motion_2, const SweepSettings<double>& settings) {
  WarmStart<double> warm_start;
  const auto plane_between = [&](const Pose<double>& pose_1, const Pose<double>& pose_2) {
    return PlaneBetween(set_1, pose_1, set_2, pose_2, warm_start);
  };
  // Planes are swept along one set at a time: through a function pointer, which is compiled once.
  return TimeOfImpact(Erase(set_1), motion_1, Erase(set_2), motion_2, settings, plane_between);
}

Result<double> GrowthDistance(const AnySet& set, const Pose<double>& pose, const HalfSpace<double>& half_space,
                              const Pose<double>& half_space_pose) {
  return set.Visit([&](const auto& rounded) { return GrowthDistance(rounded, pose, half_space, half_space_pose); });
}

FacingFaces<double> FindFacingFaces(const AnySet& set, const Pose<double>& pose, const HalfSpace<double>& half_space,
                                    const Result<double>& result) {
  return set.Visit([&](const auto& rounded) { return FindFacingFaces(rounded, pose, half_space, result); });
}

}  // namespace dgd
