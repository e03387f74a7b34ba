#include "pair_impact.h"

#include "pair_solver.h"

namespace dgd_bullet {
namespace {

/// Enough for polytopes that tumble freely; what turns faster is met when it touches, as without speculation.
constexpr int kMaxAdvances = 8;

/// Distance, relative to the first one, at which bodies count as touching.
constexpr double kTouching = 0.01;

/// Least cosine between the contact's normal now and when the bodies meet: about 18 degrees.
constexpr double kMinAlignment = 0.95;

}  // namespace

bool TouchWithinStep(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     const PairMotion& motion) {
  PosedShape moved_a = shape_a, moved_b = shape_b;
  dgd::Result<double> apart = result;
  dgd::WarmStart<double> warm_start;
  double part = 0;  // Of the step that has passed.
  for (int i = 0; i < kMaxAdvances; ++i) {
    const double approach = motion.MaxApproach(apart.normal);
    if (!(apart.separation <= approach * (1 - part))) return false;
    part += apart.separation / approach;
    moved_a.pose = motion.MovedA(shape_a.pose, part);
    moved_b.pose = motion.MovedB(shape_b.pose, part);
    apart = SolvePair(moved_a, moved_b, {}, warm_start);
    if (apart.status != dgd::Status::kOptimal) return false;
    if (apart.separation <= kTouching * result.separation) return apart.normal.dot(result.normal) >= kMinAlignment;
  }
  return false;
}

}  // namespace dgd_bullet
