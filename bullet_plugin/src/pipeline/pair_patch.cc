#include "pipeline/pair_patch.h"

#include <algorithm>
#include <cmath>

#include "conditioning/rim_points.h"
#include "conditioning/speculative_contacts.h"
#include "dgd/assert.h"
#include "pipeline/pair_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Part of the step up to which a coming contact counts as one of this step: where a body that is in contact comes down
/// on another of its corners, that carries it from the beginning of the step or, met later than this, of the next one.
/// Whichever is nearer: always the one before would take energy from what rocks (tests/physics, rocking at 240 Hz: 0.12
/// in place of 0.09).
constexpr double kSoon = 0.5;

}  // namespace

dgd::ContactPatch<double> FindContactPatch(PairQuery& query, Contact& contact, bool& is_passing) {
  if (contact.status == dgd::Status::kSeparated) return {};
  DGD_ASSERT(std::isfinite(contact.separation));
  const bool is_apart = contact.separation > std::min(query.range.touching, 0.0);
  const SpeculativeKind kind = is_apart ? ClassifySpeculative(query, contact) : SpeculativeKind::kPatch;
  if (kind == SpeculativeKind::kNone) return {};
  if (kind == SpeculativeKind::kPoint) return WitnessOnly(contact);
  query.TurnNormal(contact);
  dgd::ContactPatch<double> patch;
  if (query.options.contact_patch) {
    query.FindFacing(contact);
    patch = FindPatch(contact, query.facing, query.patch_settings, query.motion);
    if (query.options.rim_damping) {
      AddRimPoint(query.shape_a, query.shape_b, contact, query.facing, query.patch_settings, query.motion, patch);
    }
  } else {
    patch = WitnessOnly(contact);
  }
  DGD_ASSERT(patch.size <= query.patch_settings.max_points);
  is_passing = kind == SpeculativeKind::kPassingPatch;
  if (is_passing) LetPass(patch, contact.normal, query.motion, query.flush);
  return patch;
}

dgd::ContactPatch<double> FindPatch(const Contact& contact, const dgd::FacingFaces<double>& facing,
                                    const dgd::PatchSettings<double>& settings, const PairMotion& motion) {
  DGD_ASSERT(IsUnit(contact.normal) && settings.max_points <= dgd::ContactPatch<double>::kMaxPoints);
  // Bodies mostly do not approach, and no corner's own speed is looked at then.
  const bool may_meet = motion.MayApproachBy(settings.equal_depth, contact.normal);
  if (!may_meet) return dgd::FindContactPatch(contact, facing, settings, [](const Vector3&, double) { return false; });
  dgd::PatchSettings<double> touching = settings;
  touching.contact_distance = std::min(settings.contact_distance, settings.equal_depth);
  const bool is_in_touch = contact.separation <= touching.contact_distance;
  const auto counts = [&](const Vector3& point, double separation) {
    const double approach = motion.Approach(point, contact.normal);
    if (approach < separation) return separation <= settings.contact_distance;
    return !is_in_touch || separation <= kSoon * approach;
  };
  return dgd::FindContactPatch(contact, facing, touching, counts);
}

dgd::ContactPatch<double> WitnessOnly(const Contact& contact) {
  const Vector3 middle = (contact.witness_1 + contact.witness_2) / 2;
  dgd::ContactPatch<double> patch;
  patch.size = 1;
  patch.points[0] = {middle - contact.separation / 2 * contact.normal, middle + contact.separation / 2 * contact.normal,
                     contact.separation};
  return patch;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
