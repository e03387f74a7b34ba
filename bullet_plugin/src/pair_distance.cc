#include "pair_distance.h"

#include "dgd/signed_distance.h"
#include "pair_visit.h"

namespace dgd_bullet {
namespace {

/// Of the tolerance.
constexpr double kLeastGain = 0.1;

}  // namespace

void TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            const dgd::WarmStart<double>& warm_start, dgd::Result<double>& result) {
  VisitPair(shape_a, shape_b, settings,
            [&](const auto& set_a, const auto& set_b, const dgd::Settings<double>& for_pair) {
              const dgd::SignedDistanceResult<double> turned =
                  dgd::SignedDistance(set_a, shape_a.pose, set_b, shape_b.pose, result, &warm_start, for_pair);
              // Whatever its status, the separation along a normal is certain. A gain within the rounding of the
              // shapes is none: it would cost the witness points more.
              const double size = set_a.core.Inradius() + set_a.radius + set_b.core.Inradius() + set_b.radius;
              if (!(turned.separation > result.separation + kLeastGain * for_pair.relative_tolerance * size)) return;
              result.normal = turned.normal;
              result.separation = turned.separation;
              result.witness_1 = turned.witness_1;
              result.witness_2 = turned.witness_2;
            });
}

}  // namespace dgd_bullet
