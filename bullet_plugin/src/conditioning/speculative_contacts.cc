#include "conditioning/speculative_contacts.h"

#include <algorithm>
#include <limits>

#include "dgd/assert.h"
#include "pipeline/pair_distance.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// After so many, bodies count as meeting: two are usual.
constexpr int kMaxPlanes = 8;

/// How deep the shapes are moved beyond a plane before their distance is computed, in units of the flush overlap:
/// shapes that meet overlap there, so that one distance is enough for most (with 1 in its place, six were needed).
constexpr double kProbe = 32;

/// Least cosine between the contact's normal now and when the bodies meet: about 18 degrees.
constexpr double kMinAlignment = 0.95;

}  // namespace

void MovingPair::MoveTo(double time) {
  time_ = time;
  a_.pose = way_a_.At(time);
  b_.pose = way_b_.At(time);
}

double MovingPair::SeparationAlong(const Vector3& normal) const {
  return normal.dot(SupportPoint(b_, -normal) - SupportPoint(a_, normal));
}

dgd::Result<double> MovingPair::Distance(const dgd::Settings<double>& settings, bool follows,
                                         dgd::WarmStart<double>& warm_start) const {
  dgd::Result<double> result;
  if (follows && FollowDistance(a_, b_, settings, warm_start, result)) return result;
  result = dgd::GrowthDistance(a_.set, a_.pose, b_.set, b_.pose, settings, &warm_start);
  TurnToLeastTranslation(a_, b_, settings, warm_start, result);
  return result;
}

dgd::Result<double> MovingPair::AtStart(dgd::Result<double> contact) const {
  const Vector3& normal = contact.normal;
  const auto way_of = [&](const dgd::Motion<double>& motion, const Vector3& point) -> Vector3 {
    return time_ * (motion.translation + motion.rotation.cross(point - motion.CenterAt(time_)));
  };
  contact.separation += normal.dot(way_of(way_a_, contact.witness_1) - way_of(way_b_, contact.witness_2));
  const Vector3 on_a = contact.witness_1 - time_ * way_a_.translation;
  const Vector3 on_b = contact.witness_2 - time_ * way_b_.translation;
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
  for (int i = 0; i < patch.size; ++i) {
    dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    point.separation = std::max(point.separation, motion.Approach(point.on_2, normal) + flush);
    point.on_1 = point.on_2 - point.separation * normal;
  }
}

PredictedEncounter PredictEncounter(MovingPair& pair, const dgd::Settings<double>& settings,
                                    dgd::WarmStart<double> warm_start, bool follows, const dgd::Result<double>& result,
                                    double at_end, double flush) {
  dgd::Settings<double> of_planes = settings;
  of_planes.separation_limit = std::numeric_limits<double>::infinity();
  dgd::Result<double> plane = result, contact = result;
  double time = 0;
  for (int planes = 1; planes <= kMaxPlanes; ++planes) {
    const double entered = std::max(at_end, -kProbe * flush);
    time += (1 - time) * (plane.separation - entered) / (plane.separation - at_end);
    pair.MoveTo(time);
    plane = pair.Distance(of_planes, follows, warm_start);
    if (!(plane.separation > -flush)) break;
    contact = pair.AtStart(plane);
    pair.MoveTo(1);
    at_end = pair.SeparationAlong(plane.normal);
    if (at_end > -flush) return {Encounter::kPass, contact};
  }
  if (plane.normal.dot(result.normal) >= kMinAlignment) return {Encounter::kMeet, result};
  pair.MoveTo(time);
  return {Encounter::kMeetAside, pair.AtStart(plane)};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
