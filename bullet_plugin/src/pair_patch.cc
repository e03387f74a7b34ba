#include "pair_patch.h"

namespace dgd_bullet {

void FindFacingFaces(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     double angular_tolerance, dgd::FacingFaces<double>& facing) {
  facing.Clear();
  facing.frame = dgd::PatchFrame<double>(result);
  const auto find = [&](const PosedShape& shape, const Vector3& direction, dgd::SupportingFace<double>& face) {
    std::visit([&](const auto& set) { dgd::FindFace(set, shape.pose, direction, facing.frame, face); }, shape.set);
  };
  find(shape_a, result.normal, facing.face_1);
  find(shape_b, -result.normal, facing.face_2);
  facing.FindOverlap(angular_tolerance);
}

dgd::ContactPatch<double> FindPatch(const dgd::Result<double>& result, const dgd::FacingFaces<double>& facing,
                                    const dgd::PatchSettings<double>& settings, const PairMotion& motion) {
  // Most often not, and then no corner's own speed is looked at.
  const bool may_meet = motion.MayApproachBy(settings.contact_distance, result.normal);
  const auto is_approaching = [&](const Vector3& point, double separation) {
    return may_meet && separation <= motion.Approach(point, result.normal);
  };
  return dgd::FindContactPatch(result, facing, settings, is_approaching);
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
