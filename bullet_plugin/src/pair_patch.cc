#include "pair_patch.h"

namespace dgd_bullet {

dgd::ContactPatch<double> FindPatch(const PosedShape& shape_a, const PosedShape& shape_b,
                                    const dgd::Result<double>& result, const dgd::PatchSettings<double>& settings,
                                    const PairMotion& motion) {
  const dgd::PatchFrame<double> frame(result);
  const auto face = [&frame](const PosedShape& shape, const Vector3& direction) {
    return std::visit([&](const auto& set) { return dgd::FindFace(set, shape.pose, direction, frame); }, shape.set);
  };
  const auto is_approaching = [&](const Vector3& point, double separation) {
    return separation <= motion.Approach(point, result.normal);
  };
  return dgd::FindContactPatch(result, frame, face(shape_a, result.normal), face(shape_b, -result.normal), settings,
                               is_approaching);
}

dgd::ContactPatch<double> WitnessOnly(const dgd::Result<double>& result) {
  const Vector3 middle = (result.witness_1 + result.witness_2) / 2;
  dgd::ContactPatch<double> patch;
  patch.size = 1;
  patch.points[0] = {middle - result.separation / 2 * result.normal, middle + result.separation / 2 * result.normal,
                     result.separation};
  return patch;
}

}  // namespace dgd_bullet
