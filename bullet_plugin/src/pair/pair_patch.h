// The contact patch of a solved pair.
#pragma once

#include "ahead/meeting.h"
#include "contact_range.h"
#include "dgd/contact/facing_faces.h"
#include "dgd/contact/reference_face.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pair_motion.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The contacts of a solved pair, before they are written anywhere.
struct PairContacts {
  dgd::ContactPatch<double> patch;
  Vector3 normal = Vector3::Zero();  ///< Unit, from the call's first body to the second.
  PairMotion motion;                 ///< Motion of the bodies in the order that their shapes are solved in.
  Moment moment;                     ///< That at which the patch was found.
  /// Whether the next step may recycle the contacts: the bodies are in touch, or do not come nearer. Of those that do,
  /// others may touch next.
  bool may_recycle = false;
  /// The shape with a face across the normal, in the order that the shapes are solved in.
  dgd::ReferenceSide side = dgd::ReferenceSide::kNone;
};

/// What decides which points of a pair count in a step.
struct PatchRules {
  const ContactRange& range;
  const dgd::PatchSettings<double>& settings;
  const PairMotion& motion;  ///< Of the bodies in the order that their shapes are solved in.
  double flush;              ///< NegligibleDistance(), metres.
};

/// What is known of a certified contact before the bodies are moved.
enum class Approach {
  kNone,     ///< The bodies are too far apart for contacts, and will be at the end of the step.
  kInTouch,  ///< They are in touch, or do not approach each other: their contacts are those of where they are.
  kMayMeet,  ///< They approach each other by as much as they are apart.
};
Approach ClassifyApproach(const PatchRules& rules, const Contact& contact);

/// Finds the contacts of two shapes in this step: those of where they are, or of where they meet within it, or will be
/// at its end.
/// @param contact        Certified. In and out: that of where the patch is found.
/// @param plane_between  Contact(const Pose& a, const Pose& b), see FindMeeting().
/// @param find_patch     ContactPatch(const PosedShape& a, const PosedShape& b, const Contact&, const Moment&): the
///                       patch where the shapes are.
/// @param contacts       Out: patch, moment and may_recycle; an empty patch if there are no contacts.
template <class PlaneBetween, class FindPatchAt>
void FindContactsByMotion(const PosedShape& shape_a, const PosedShape& shape_b, const PatchRules& rules,
                          Contact& contact, const PlaneBetween& plane_between, const FindPatchAt& find_patch,
                          PairContacts& contacts) {
  const Approach approach = ClassifyApproach(rules, contact);
  if (approach == Approach::kNone) return;
  const double start = contact.separation;
  contacts.may_recycle = start <= rules.flush || !rules.motion.MayCoastBy(rules.flush, contact.normal);
  if (approach == Approach::kInTouch) {
    contacts.patch = find_patch(shape_a, shape_b, contact, contacts.moment);
    return;
  }
  MovingPair pair(shape_a, shape_b, rules.motion);
  const bool is_impact = FindMeeting(pair, contact, rules.flush, plane_between);
  contacts.may_recycle &= !is_impact;
  if (!is_impact) {
    if (start > rules.range.touching) return;
    contact = plane_between(pair.a().pose, pair.b().pose);
    if (contact.status == dgd::Status::kInvalidInput || contact.separation > rules.range.touching) return;
  }
  contacts.moment = {pair.time(), is_impact};
  contacts.patch = find_patch(pair.a(), pair.b(), contact, contacts.moment);
  pair.MoveToStart(contact.normal, rules.flush, contacts.patch);
}

/// The points of a patch that count: the nearest ones, and what is near and does not come nearer. A corner that lands
/// within the step next to others in touch counts from the next one: until then the others carry the weight. On
/// average, a corner carries from the moment that it lands so, since Bullet's solver takes what a step begins with for
/// half a step before that and half after; to meet it ahead would brake hulls that roll (tests/plugin, RollingHull).
/// At once counts what lands faster than from a fall by the breaking threshold, and what the bodies do not turn over,
/// as a wheel does, but come to lie on: small ones would rock for ever, which fall by much of their size in a step. In
/// an impact all counts that lands. Of bodies that rebound nothing does ahead: each point would take the whole rebound.
dgd::ContactPatch<double> FindPatch(const Contact& contact, const dgd::FacingFaces<double>& facing,
                                    const PatchRules& rules, const Moment& moment);

/// The witness point alone: what Bullet's own algorithm would report.
dgd::ContactPatch<double> WitnessOnly(const Contact& contact);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
