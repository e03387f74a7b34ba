#include "pair_impact.h"

#include "pair_sweep.h"

namespace dgd_bullet {
namespace {

/// Enough for polytopes that tumble freely; what turns faster is met when it touches, as without speculation.
constexpr int kMaxPlanes = 16;

/// The sweep's own tolerance, of the overlap that is allowed.
constexpr double kTolerance = 0.25;

/// Least cosine between the contact's normal now and when the bodies meet: about 18 degrees.
constexpr double kMinAlignment = 0.95;

/// Where a point that is fixed to a moving pose, and at `point` at `time`, was at the start.
Vector3 AtStart(const Vector3& point, const Motion& motion, double time) {
  const Pose then = motion.At(time);
  return motion.start * Vector3(then.rotation.transpose() * (point - then.translation));
}

}  // namespace

std::optional<PredictedImpact> PredictImpact(const PosedShape& shape_a, const PosedShape& shape_b,
                                             const dgd::Result<double>& result,
                                             const dgd::WarmStart<double>& warm_start, const PairMotion& motion,
                                             double flush) {
  const Motion motion_a = motion.MotionOfA(shape_a.pose), motion_b = motion.MotionOfB(shape_b.pose);
  const dgd::TimeOfImpactResult<double> impact = SweepPair(
      shape_a, motion_a, shape_b, motion_b,
      {.tolerance = kTolerance * flush, .allowed_overlap = flush, .max_planes = kMaxPlanes}, &result, warm_start);
  if (impact.status != dgd::Status::kTouching) return std::nullopt;
  PredictedImpact predicted{impact.normal.dot(result.normal) >= kMinAlignment, result};
  if (predicted.is_along_normal) return predicted;
  dgd::Result<double>& contact = predicted.contact;
  contact.normal = impact.normal;
  contact.witness_1 = AtStart(impact.witness_1, motion_a, impact.time);
  contact.witness_2 = AtStart(impact.witness_2, motion_b, impact.time);
  contact.separation = impact.normal.dot(contact.witness_2 - contact.witness_1);
  return predicted;
}

}  // namespace dgd_bullet
