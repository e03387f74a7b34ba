#include "pair_impact.h"

#include "pair_sweep.h"

namespace dgd_bullet {
namespace {

/// Enough for polytopes that tumble freely; what turns faster is met when it touches, as without speculation.
constexpr int kMaxPlanes = 8;

/// Distance, relative to the first one, at which bodies count as touching.
constexpr double kTouching = 0.01;

/// Least cosine between the contact's normal now and when the bodies meet: about 18 degrees.
constexpr double kMinAlignment = 0.95;

}  // namespace

bool TouchWithinStep(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     const dgd::WarmStart<double>& warm_start, const PairMotion& motion) {
  if (!(result.separation <= motion.MaxApproach(result.normal))) return false;
  const dgd::TimeOfImpactResult<double> impact =
      SweepPair(shape_a, motion.MotionOfA(shape_a.pose), shape_b, motion.MotionOfB(shape_b.pose),
                {.tolerance = kTouching * result.separation, .max_planes = kMaxPlanes}, &result, warm_start);
  return impact.status == dgd::Status::kTouching && impact.normal.dot(result.normal) >= kMinAlignment;
}

}  // namespace dgd_bullet
