#include "pair/pair_patch.h"

#include <algorithm>
#include <cmath>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Whether a contact carries a body: its motion does not close it, and its weight does, or it is closed. What turns
/// about a corner lifts that in each step by the difference of chord and arc.
bool IsSupporting(const PatchRules& rules, const Contact& contact) {
  const Vector3 middle = (contact.witness_1 + contact.witness_2) / 2;
  const double gap = std::max(contact.separation, 0.0);
  return rules.motion.Coasting(middle, contact.normal) < gap + rules.flush &&
         (gap <= rules.flush || gap <= rules.motion.Approach(middle, contact.normal));
}

/// Whether a corner that by itself would overlap by so much at the end of the step lands faster than from a fall by the
/// breaking threshold. The deepest of fifty polytopes (headless_sim sweep) is 0.28 of the built-in's with this, and
/// 0.52 if no such corner counts at once. With half the height and with eight times as much it is 0.33; blocks that
/// rock and hulls that roll (physics_truth, tests/plugin) are the same with half and with twice.
bool IsFastLanding(const PatchRules& rules, const Vector3& normal, double overlap) {
  const double by_weight = rules.motion.TimeStep() * rules.motion.ApproachSpeedGain(normal);
  return overlap * overlap > 2 * rules.settings.spacing * std::max(by_weight, 0.0);
}

}  // namespace

Approach ClassifyApproach(const PatchRules& rules, const Contact& contact) {
  if (contact.status == dgd::Status::kSeparated) return Approach::kNone;
  const double separation = contact.separation;
  DGD_ASSERT(std::isfinite(separation));
  const bool is_touching = separation <= rules.range.touching;
  if (is_touching && separation <= -rules.flush) return Approach::kInTouch;
  if (!is_touching && separation > rules.range.limit) return Approach::kNone;
  const double reach = std::max(separation, 0.0) + (is_touching ? rules.flush : 0);
  if (!rules.motion.MayCoastBy(reach, contact.normal)) return is_touching ? Approach::kInTouch : Approach::kNone;
  return is_touching && IsSupporting(rules, contact) ? Approach::kInTouch : Approach::kMayMeet;
}

dgd::ContactPatch<double> FindPatch(const Contact& contact, const dgd::FacingFaces<double>& facing,
                                    const PatchRules& rules, const Moment& moment) {
  const dgd::PatchSettings<double>& settings = rules.settings;
  DGD_ASSERT(IsUnit(contact.normal) && settings.max_points <= dgd::ContactPatch<double>::kMaxPoints);
  // Bodies mostly do not approach, and no corner's own speed is looked at then.
  const bool may_land = rules.motion.MayApproachBy(settings.equal_depth, contact.normal);
  if (!may_land) return dgd::FindContactPatch(contact, facing, settings, [](const Vector3&, double) { return false; });
  dgd::PatchSettings<double> touching = settings;
  touching.contact_distance = std::min(settings.contact_distance, settings.equal_depth);
  const double nearest = contact.separation + settings.equal_depth;
  const double remaining = 1 - moment.time;
  const auto counts = [&](const Vector3& point, double separation) {
    if (separation <= nearest) return true;
    const double overlap = remaining * rules.motion.Coasting(point, contact.normal) - separation;
    if (overlap < -rules.flush) return separation <= settings.contact_distance;
    if (rules.range.is_rebound) return false;
    return moment.is_impact || IsFastLanding(rules, contact.normal, overlap) ||
           !rules.motion.TurnOver((contact.witness_1 + contact.witness_2) / 2, point, contact.normal);
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
