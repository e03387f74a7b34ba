#include "pair_solver.h"

#include <limits>

namespace dgd_bullet {

double ReachableTolerance(const PosedShape& shape_a, const PosedShape& shape_b) {
  using ThroughBullet = dgd::RoundedSet<BulletCore>;
  const bool through_bullet =
      std::holds_alternative<ThroughBullet>(shape_a.set) || std::holds_alternative<ThroughBullet>(shape_b.set);
  return through_bullet ? 16 * double(std::numeric_limits<btScalar>::epsilon()) : 0.0;
}

dgd::Result<double> SolvePair(const PosedShape& shape_a, const PosedShape& shape_b,
                              const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start) {
  return std::visit(
      [&](const auto& set_a, const auto& set_b) {
        return dgd::GrowthDistance(set_a, shape_a.pose, set_b, shape_b.pose, settings, &warm_start);
      },
      shape_a.set, shape_b.set);
}

dgd::ContactPatch<double> FindPatch(const PosedShape& shape_a, const PosedShape& shape_b,
                                    const dgd::Result<double>& result, double contact_distance, double spacing,
                                    const PairMotion& motion) {
  const dgd::PatchFrame<double> frame(result);
  const auto face = [&frame](const PosedShape& shape, const Vector3& direction) {
    return std::visit([&](const auto& set) { return dgd::FindFace(set, shape.pose, direction, frame); }, shape.set);
  };
  const auto is_approaching = [&](const Vector3& point, double separation) {
    return separation <= motion.Approach(point, result.normal);
  };
  return dgd::FindContactPatch(result, frame, face(shape_a, result.normal), face(shape_b, -result.normal),
                               contact_distance, spacing, is_approaching);
}

}  // namespace dgd_bullet
