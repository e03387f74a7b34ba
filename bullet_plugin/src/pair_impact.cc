#include "pair_impact.h"

#include <algorithm>
#include <limits>

#include "pair_distance.h"
#include "pair_solver.h"

namespace dgd_bullet {
namespace {

/// After so many, bodies count as meeting: two are usual.
constexpr int kMaxPlanes = 8;

/// How deep the shapes are moved beyond a plane before their distance is computed, in units of the flush overlap:
/// shapes that meet overlap there, so that one distance is enough for most (with 1 in its place, six were needed).
constexpr double kProbe = 32;

/// Least cosine between the contact's normal now and when the bodies meet: about 18 degrees.
constexpr double kMinAlignment = 0.95;

/// Where a point that is fixed to a moving pose, and at `point` at `time`, was at the start.
Vector3 AtStart(const Vector3& point, const dgd::Motion<double>& motion, double time) {
  const Pose then = motion.At(time);
  return motion.start * Vector3(then.rotation.transpose() * (point - then.translation));
}

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
  result = SolvePair(a_, b_, settings, warm_start);
  TurnToLeastTranslation(a_, b_, settings, warm_start, result);
  return result;
}

dgd::Result<double> MovingPair::AtStart(dgd::Result<double> contact) const {
  contact.witness_1 = dgd_bullet::AtStart(contact.witness_1, way_a_, time_);
  contact.witness_2 = dgd_bullet::AtStart(contact.witness_2, way_b_, time_);
  contact.separation = contact.normal.dot(contact.witness_2 - contact.witness_1);
  return contact;
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

}  // namespace dgd_bullet
