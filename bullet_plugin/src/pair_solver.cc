#include "pair_solver.h"

#include "pair_visit.h"

namespace dgd_bullet {

dgd::Result<double> SolvePair(const PosedShape& shape_a, const PosedShape& shape_b,
                              const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start) {
  return VisitPair(shape_a, shape_b, settings,
                   [&](const auto& set_a, const auto& set_b, const dgd::Settings<double>& for_pair) {
                     return dgd::GrowthDistance(set_a, shape_a.pose, set_b, shape_b.pose, for_pair, &warm_start);
                   });
}

}  // namespace dgd_bullet
