#include <concepts>

#include "bench/solver_set.h"
#include "dgd/growth_distance.h"

namespace dgd_bench {
namespace {

/// The templates for two cores of known types, as users write them: the one pair for which AnySet knows less, since to
/// it a differentiable support function is any custom core, without derivatives.
using DsfSet = dgd::RoundedSet<dgd::CoreReference<dgd_test::Dsf<double>>>;

DsfSet AsDsf(const SolverSet<3>& set) { return {*set.dsf, set.set.Radius()}; }

}  // namespace

template <>
SolverSet<3> MakeSolverSet<3>(const dgd_test::SetNumbers& numbers) {
  return WithStoredSet<3>(
      numbers, []<class Core, class Set>(const std::shared_ptr<const Core>& core, const Set& set) -> SolverSet<3> {
        const dgd_test::Dsf<double>* dsf = nullptr;
        if constexpr (std::same_as<Core, dgd_test::Dsf<double>>) dsf = core.get();
        auto plain = std::make_unique<SupportFunctionOf<typename Set::Core>>(set);
        const double extent = dgd_test::Extent(*core, set.radius);
        if constexpr (std::constructible_from<dgd::AnySet, Set>) {
          return {core, dgd::AnySet(set), dsf, std::move(plain), extent};
        } else {
          const dgd::RoundedSet<dgd::CustomCore> custom{dgd::CustomCore(*core), set.radius};
          return {core, dgd::AnySet(custom), dsf, std::move(plain), extent};
        }
      });
}

template <>
dgd::Result<double> SolveGrowth<3>(const SolverSet<3>& set_1, const dgd::Pose<double>& pose_1,
                                   const SolverSet<3>& set_2, const dgd::Pose<double>& pose_2,
                                   const dgd::Settings<double>& settings, dgd::WarmStart<double>* warm_start) {
  if (set_1.dsf != nullptr && set_2.dsf != nullptr) {
    return dgd::GrowthDistance(AsDsf(set_1), pose_1, AsDsf(set_2), pose_2, settings, warm_start);
  }
  return dgd::GrowthDistance(set_1.set, pose_1, set_2.set, pose_2, settings, warm_start);
}

template <>
dgd::Status CheckCollision<3>(const SolverSet<3>& set_1, const dgd::Pose<double>& pose_1, const SolverSet<3>& set_2,
                              const dgd::Pose<double>& pose_2) {
  if (set_1.dsf != nullptr && set_2.dsf != nullptr) {
    return dgd::DetectCollision(AsDsf(set_1), pose_1, AsDsf(set_2), pose_2).status;
  }
  return dgd::DetectCollision(set_1.set, pose_1, set_2.set, pose_2).status;
}

}  // namespace dgd_bench
