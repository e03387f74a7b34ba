#include "pair_solver.h"

#include <algorithm>

namespace dgd_bullet {
namespace {

using ErasedSet = dgd::RoundedSet<SupportCore>;

template <class Set>
constexpr bool kIsErased = std::is_same_v<Set, ErasedSet>;

template <class Set>
ErasedSet Erase(const Set& set) {
  if constexpr (kIsErased<Set>) {
    return set;
  } else {
    return {SupportCore(set.core), set.radius};
  }
}

dgd::Result<double> SolveErased(const ErasedSet& set_a, const Pose& pose_a, const ErasedSet& set_b, const Pose& pose_b,
                                dgd::Settings<double> settings, dgd::WarmStart<double>& warm_start) {
  settings.relative_tolerance = std::max({settings.relative_tolerance, set_a.core.Accuracy(), set_b.core.Accuracy()});
  return dgd::GrowthDistance(set_a, pose_a, set_b, pose_b, settings, &warm_start);
}

}  // namespace

dgd::Result<double> SolvePair(const PosedShape& shape_a, const PosedShape& shape_b,
                              const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start) {
  return std::visit(
      [&]<class SetA, class SetB>(const SetA& set_a, const SetB& set_b) {
        if constexpr (kIsErased<SetA> || kIsErased<SetB>) {
          return SolveErased(Erase(set_a), shape_a.pose, Erase(set_b), shape_b.pose, settings, warm_start);
        } else {
          return dgd::GrowthDistance(set_a, shape_a.pose, set_b, shape_b.pose, settings, &warm_start);
        }
      },
      shape_a.set, shape_b.set);
}

}  // namespace dgd_bullet
