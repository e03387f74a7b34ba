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

bool StayApart(const PosedShape& shape_a, const PosedShape& shape_b, double limit,
               const dgd::WarmStart<double>& warm_start, dgd::Result<double>& result) {
  if (!dgd::HasNormal(warm_start)) return false;
  return VisitPair(shape_a, shape_b, {}, [&](const auto& set_a, const auto& set_b, const dgd::Settings<double>&) {
    Vector3 top_a;
    return dgd::SeparatedAlong(warm_start.normal_1, set_a, shape_a.pose, set_b, shape_b.pose, limit, result, top_a);
  });
}

}  // namespace dgd_bullet
