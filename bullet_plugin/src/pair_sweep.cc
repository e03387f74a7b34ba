#include "pair_sweep.h"

#include "pair_distance.h"
#include "pair_solver.h"
#include "pair_visit.h"

namespace dgd_bullet {

dgd::TimeOfImpactResult<double> SweepPair(const PosedShape& shape_a, const Motion& motion_a, const PosedShape& shape_b,
                                          const Motion& motion_b, const dgd::SweepSettings<double>& settings) {
  dgd::Settings<double> for_planes;
  for_planes.relative_tolerance = dgd::kPlaneTolerance<double>;
  dgd::WarmStart<double> warm_start;
  PosedShape moved_a = shape_a, moved_b = shape_b;
  const auto plane_between = [&](const Pose& pose_a, const Pose& pose_b) {
    moved_a.pose = pose_a;
    moved_b.pose = pose_b;
    dgd::Result<double> plane = SolvePair(moved_a, moved_b, for_planes, warm_start);
    if (dgd::IsUndecided(plane)) TurnToLeastTranslation(moved_a, moved_b, for_planes, warm_start, plane);
    return plane;
  };
  // Planes are swept along one set at a time, most often twice: through a function pointer, this is compiled once and
  // not for every pair of types.
  return dgd::TimeOfImpact(Erase(shape_a.set), motion_a, Erase(shape_b.set), motion_b, settings, plane_between);
}

}  // namespace dgd_bullet
