#include "pair/least_translation.h"

#include <algorithm>

#include "dgd/any_set.h"
#include "dgd/assert.h"

namespace dgd_bullet {
namespace {

/// Growth distance below which shapes are deep in each other. With 0.5 and 0.25 one of eight bodies of an app's own
/// falls through a mesh at 60 Hz (physics_truth, rest); fifty polytopes never get so deep.
constexpr double kDeep = 0.75;

/// Least gain of separation that is worth turning the normal, as a part of the tolerance.
constexpr double kMinGain = 0.1;

}  // namespace

bool IsDeep(const Contact& contact) {
  return contact.status == dgd::Status::kCoincidentCenters || contact.upper_bound < kDeep;
}

void TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            const dgd::WarmStart<double>& warm_start, Contact& contact) {
  const dgd::SignedDistanceResult<double> turned =
      dgd::SignedDistance(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, contact, &warm_start, settings);
  if (turned.status == dgd::Status::kInvalidInput) return;
  // Regardless of the status, the separation along a normal is certain. A gain within the roundoff of the shapes is
  // none: it would cost the witness points more.
  const double tolerance = std::max({settings.relative_tolerance, shape_a.set.Accuracy(), shape_b.set.Accuracy()});
  const double radius = shape_a.set.Radius() + shape_b.set.Radius();
  const double size = shape_a.set.CoreInradius() + shape_b.set.CoreInradius() + radius;
  const double negligible = kMinGain * tolerance * size;
  DGD_ASSERT(radius >= 0 && negligible >= 0);
  if (!(turned.separation > contact.separation + negligible)) return;
  DGD_ASSERT(IsUnit(turned.normal));
  contact.normal = turned.normal;
  contact.separation = turned.separation;
  contact.witness_1 = turned.witness_1;
  contact.witness_2 = turned.witness_2;
}

}  // namespace dgd_bullet
