#include "conditioning/speculative_contacts.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "dgd/assert.h"
#include "pipeline/pair_distance.h"
#include "pipeline/pair_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Planes after which bodies count as meeting: two are usual.
constexpr int kMaxPlanes = 8;

/// How deep the shapes are moved beyond a plane before their distance is computed, in units of the flush overlap:
/// shapes that meet overlap there, so that one distance is enough for most (with 1 in its place, six were needed).
constexpr double kProbe = 32;

/// Least cosine between the contact's normal now and when the bodies meet: about 18 degrees.
constexpr double kMinAlignment = 0.95;

}  // namespace

void MovingPair::MoveTo(double time) {
  DGD_ASSERT(!(time < -1e-6 || time > 1 + 1e-6));
  time_ = time;
  a_.pose = way_a_.At(time);
  b_.pose = way_b_.At(time);
}

double MovingPair::SeparationAlong(const Vector3& normal) const {
  DGD_ASSERT(IsUnit(normal));
  return normal.dot(SupportPoint(b_, -normal) - SupportPoint(a_, normal));
}

Contact MovingPair::Distance(const dgd::Settings<double>& settings, bool can_update,
                             dgd::WarmStart<double>& warm_start) const {
  if (can_update) {
    if (const std::optional<Contact> contact = UpdateDistance(a_, b_, settings, warm_start)) return *contact;
  }
  Contact contact = dgd::GrowthDistance(a_.set, a_.pose, b_.set, b_.pose, settings, &warm_start);
  TurnToLeastTranslation(a_, b_, settings, warm_start, contact);
  return contact;
}

Contact MovingPair::AtStart(Contact contact) const {
  const Vector3& normal = contact.normal;
  const auto way_of = [&](const dgd::Motion<double>& motion, const Vector3& point) -> Vector3 {
    return time_ * (motion.translation + motion.rotation.cross(point - motion.CenterAt(time_)));
  };
  contact.separation += normal.dot(way_of(way_a_, contact.witness_1) - way_of(way_b_, contact.witness_2));
  const Vector3 on_a = contact.witness_1 - time_ * way_a_.translation;
  const Vector3 on_b = contact.witness_2 - time_ * way_b_.translation;
  DGD_ASSERT(share_of_a_ >= 0 && share_of_a_ <= 1);
  // One place for both: the arm that counts is that of the body that gives way.
  const Vector3 place = share_of_a_ * on_a + (1 - share_of_a_) * on_b;
  contact.witness_1 = place + normal.dot(on_a - place) * normal;
  contact.witness_2 = contact.witness_1 + contact.separation * normal;
  return contact;
}

bool TurnsClear(const PosedShape& shape_a, const PosedShape& shape_b, const PairMotion& motion, const Vector3& normal,
                double flush) {
  if (!(motion.MaxArc() > flush)) return false;
  DGD_ASSERT(motion.IsKnown() && flush >= 0);
  MovingPair pair(shape_a, shape_b, motion);
  for (const double time : {0.5, 1.0}) {
    pair.MoveTo(time);
    if (pair.SeparationAlong(normal) <= 0) return false;
  }
  return true;
}

void LetPass(dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion, double flush) {
  DGD_ASSERT(IsUnit(normal) && !(flush < 0));
  for (int i = 0; i < patch.size; ++i) {
    dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    point.separation = std::max(point.separation, motion.Approach(point.on_2, normal) + flush);
    point.on_1 = point.on_2 - point.separation * normal;
  }
}

PredictedEncounter PredictEncounter(MovingPair& pair, const dgd::Settings<double>& settings,
                                    dgd::WarmStart<double> warm_start, bool can_update, const Contact& start,
                                    double at_end, double flush) {
  dgd::Settings<double> of_planes = settings;
  of_planes.separation_limit = std::numeric_limits<double>::infinity();
  Contact plane = start, contact = start;
  double time = 0;
  DGD_ASSERT(!(at_end > -flush));
  for (int planes = 1; planes <= kMaxPlanes; ++planes) {
    const double entered = std::max(at_end, -kProbe * flush);
    time += (1 - time) * (plane.separation - entered) / (plane.separation - at_end);
    pair.MoveTo(time);
    plane = pair.Distance(of_planes, can_update, warm_start);
    if (!(plane.separation > -flush)) break;
    contact = pair.AtStart(plane);
    pair.MoveTo(1);
    at_end = pair.SeparationAlong(plane.normal);
    if (at_end > -flush) return {Encounter::kPass, contact};
  }
  if (plane.normal.dot(start.normal) >= kMinAlignment) return {Encounter::kMeet, start};
  pair.MoveTo(time);
  return {Encounter::kMeetAside, pair.AtStart(plane)};
}

SpeculativeKind ClassifySpeculative(PairQuery& query, Contact& contact) {
  const PairMotion& motion = query.motion;
  DGD_ASSERT(IsUnit(contact.normal) && !(query.flush < 0));
  const bool is_touching = contact.separation <= query.range.touching;
  // What the motion closes is judged along the normal of the contacts.
  if (is_touching) query.TurnNormal(contact);
  if (!motion.MayApproachBy(contact.separation, contact.normal)) {
    return is_touching ? SpeculativeKind::kPatch : SpeculativeKind::kNone;
  }
  if (!is_touching && contact.separation > query.range.limit) return SpeculativeKind::kNone;
  query.TurnNormal(contact);
  query.FindFacing(contact);
  // Impacts of other bodies may change a motion that does not make them meet. A contact that has no effect otherwise
  // keeps them apart then; but a rebound would act on it, and in a mesh the next triangle is what they pass to.
  const bool may_be_knocked = is_touching && !query.is_triangle && !query.range.is_rebound;
  const double flush = query.flush;
  if (contact.separation > flush && TurnsClear(query.shape_a, query.shape_b, motion, contact.normal, flush)) {
    return may_be_knocked ? SpeculativeKind::kPassingPatch : SpeculativeKind::kNone;
  }
  const Vector3 middle = (contact.witness_1 + contact.witness_2) / 2;
  if (query.facing.IsInset(flush + motion.Passing(middle, contact.normal))) return SpeculativeKind::kPatch;
  // Weight is left out: what supports the bodies takes it up, and would seem to let them sink into each other.
  MovingPair pair(query.shape_a, query.shape_b, motion.WithoutForces());
  pair.MoveTo(1);
  const double at_end = pair.SeparationAlong(contact.normal);
  if (at_end > -flush) return is_touching ? SpeculativeKind::kPatch : SpeculativeKind::kNone;
  PairCache& cache = query.cache;
  const PredictedEncounter predicted =
      PredictEncounter(pair, query.settings, cache.warm_start(), cache.CanUpdateDistance(), contact, at_end, flush);
  if (predicted.encounter == Encounter::kMeet) return SpeculativeKind::kPatch;
  const double separation = predicted.contact.separation;
  if (predicted.encounter == Encounter::kPass) {
    const bool is_plane_between = separation > -flush && separation <= query.range.touching;
    if (!may_be_knocked || !is_plane_between) return SpeculativeKind::kNone;
  }
  contact = predicted.contact;
  if (predicted.encounter == Encounter::kPass) contact.separation = std::max(separation, 0.0);
  query.DropReferenceFace();
  return SpeculativeKind::kPoint;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
