#include "pipeline/pair_distance.h"

#include <algorithm>

#include "dgd/assert.h"

namespace dgd_bullet {
namespace {

/// Least gain of separation that is worth turning the normal, as a part of the tolerance.
constexpr double kMinGain = 0.1;

void Set(const dgd::SignedDistanceResult<double>& distance, Contact& contact) {
  contact.normal = distance.normal;
  contact.separation = distance.separation;
  contact.witness_1 = distance.witness_1;
  contact.witness_2 = distance.witness_2;
}

/// The contact of a signed distance that is certain.
std::optional<Contact> CertainContact(const dgd::SignedDistanceResult<double>& distance) {
  if (distance.status != dgd::Status::kOptimal && distance.status != dgd::Status::kSeparated) return std::nullopt;
  DGD_ASSERT(std::isfinite(distance.separation) && IsUnit(distance.normal));
  std::optional<Contact> contact(std::in_place);
  contact->status = distance.status;
  contact->iterations = distance.iterations;
  Set(distance, *contact);
  return contact;
}

bool IsCustom(const PosedShape& shape_a, const PosedShape& shape_b) {
  return shape_a.set.IsCustom() || shape_b.set.IsCustom();
}

bool ArePolytopes(const PosedShape& shape_a, const PosedShape& shape_b) {
  return shape_a.set.AsPolytope() != nullptr && shape_b.set.AsPolytope() != nullptr;
}

}  // namespace

bool TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            dgd::WarmStart<double>& warm_start, Contact& contact) {
  dgd::WarmStart<double> follow;
  const dgd::SignedDistanceResult<double> turned = dgd::SignedDistance(
      shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, contact, &warm_start, settings, &follow);
  if (turned.status == dgd::Status::kInvalidInput) return false;
  // Regardless of the status, the separation along a normal is certain. A gain within the roundoff of the shapes is
  // none: it would cost the witness points more.
  const double tolerance = std::max({settings.relative_tolerance, shape_a.set.Accuracy(), shape_b.set.Accuracy()});
  const double radius = shape_a.set.Radius() + shape_b.set.Radius();
  const double size = shape_a.set.CoreInradius() + shape_b.set.CoreInradius() + radius;
  const double negligible = kMinGain * tolerance * size;
  DGD_ASSERT(radius >= 0 && negligible >= 0);
  DGD_ASSERT(!(turned.separation > contact.separation) || IsUnit(turned.normal));
  if (turned.separation > contact.separation + negligible) Set(turned, contact);
  if (IsCustom(shape_a, shape_b)) return false;
  if (turned.status != dgd::Status::kOptimal) return false;
  const bool are_apart = turned.separation + radius > negligible;
  if (!are_apart && !ArePolytopes(shape_a, shape_b)) return false;
  warm_start = follow;
  return true;
}

std::optional<Contact> UpdateDistance(const PosedShape& shape_a, const PosedShape& shape_b,
                                      const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start) {
  if (IsCustom(shape_a, shape_b)) return std::nullopt;
  if (ArePolytopes(shape_a, shape_b)) {
    // The growth distance shows sooner that new polytopes are apart.
    if (warm_start.size == 0) return std::nullopt;
  } else if (!(shape_a.set.Radius() + shape_b.set.Radius() > 0)) {
    return std::nullopt;  // Sharp bodies in contact overlap.
  }
  return CertainContact(
      dgd::UpdateDistance(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, settings, warm_start));
}

std::optional<Contact> UpdateOnReferenceFace(const PosedShape& shape_a, const PosedShape& shape_b,
                                             const dgd::Settings<double>& settings, double angular_tolerance,
                                             dgd::ReferenceSide side, dgd::WarmStart<double>& warm_start,
                                             dgd::FacingFaces<double>& facing) {
  // Shapes that only Bullet can evaluate show no faces.
  if (IsCustom(shape_a, shape_b)) return std::nullopt;
  return CertainContact(dgd::UpdateOnReferenceFace(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, settings,
                                                   angular_tolerance, side, warm_start, facing));
}

}  // namespace dgd_bullet
