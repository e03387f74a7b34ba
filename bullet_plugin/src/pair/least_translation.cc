#include "pair/least_translation.h"

#include "dgd/any_set.h"
#include "dgd/assert.h"

namespace dgd_bullet {
namespace {

/// Growth distance below which shapes are deep in each other. With 0.5 and 0.25 one of eight bodies of an app's own
/// falls through a mesh at 60 Hz (physics_truth, rest); fifty polytopes never get so deep.
constexpr double kDeep = 0.75;

}  // namespace

bool IsDeep(const Contact& contact) {
  return contact.status == dgd::Status::kCoincidentCenters || contact.upper_bound < kDeep;
}

void TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            const dgd::WarmStart<double>& warm_start, Contact& contact) {
  const dgd::SignedDistanceResult<double> turned =
      dgd::SignedDistance(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, contact, &warm_start, settings);
  if (turned.status == dgd::Status::kInvalidInput) return;
  // Regardless of the status, the separation along a normal is certain.
  DGD_ASSERT(IsUnit(turned.normal));
  contact.normal = turned.normal;
  contact.separation = turned.separation;
  contact.witness_1 = turned.witness_1;
  contact.witness_2 = turned.witness_2;
  if (contact.status != dgd::Status::kInvalidInput) return;
  contact.status = turned.status;
  contact.iterations = turned.iterations;
  contact.lower_bound =
      (turned.witness_1 - shape_a.pose.translation).norm() + (turned.witness_2 - shape_b.pose.translation).norm();
  contact.upper_bound = contact.lower_bound + (turned.upper_bound - turned.separation);
}

}  // namespace dgd_bullet
