#include <concepts>
#include <stdexcept>

#include "bench/solver_set.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes/one_of.h"

namespace dgd_bench {

template <>
SolverSet<2> MakeSolverSet<2>(const dgd_test::SetNumbers& numbers) {
  return WithStoredSet<2>(
      numbers, []<class Core, class Set>(const std::shared_ptr<const Core>& core, const Set& set) -> SolverSet<2> {
        auto plain = std::make_unique<SupportFunctionOf<typename Set::Core>>(set);
        const double extent = dgd_test::Extent(*core, set.radius);
        if constexpr (std::convertible_to<typename Set::Core, PlanePolygon>) {
          return {core, dgd::RoundedSet<PlanePolygon>{set.core, set.radius}, nullptr, std::move(plain), extent};
        } else if constexpr (std::same_as<Core, dgd::Ellipse<double>>) {
          return {core, set, nullptr, std::move(plain), extent};
        } else {
          throw std::invalid_argument("no benchmark of such a set of the plane");
        }
      });
}

template <>
dgd::Result<double, 2> SolveGrowth<2>(const SolverSet<2>& set_1, const dgd::Pose<double, 2>& pose_1,
                                      const SolverSet<2>& set_2, const dgd::Pose<double, 2>& pose_2,
                                      const dgd::Settings<double>& settings, dgd::WarmStart<double, 2>* warm_start) {
  return std::visit(
      [&](const auto& a, const auto& b) { return dgd::GrowthDistance(a, pose_1, b, pose_2, settings, warm_start); },
      set_1.set, set_2.set);
}

template <>
dgd::Status CheckCollision<2>(const SolverSet<2>& set_1, const dgd::Pose<double, 2>& pose_1, const SolverSet<2>& set_2,
                              const dgd::Pose<double, 2>& pose_2) {
  return std::visit([&](const auto& a, const auto& b) { return dgd::DetectCollision(a, pose_1, b, pose_2).status; },
                    set_1.set, set_2.set);
}

}  // namespace dgd_bench
