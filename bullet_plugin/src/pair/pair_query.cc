#include "pair/pair_query.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>

#include "dgd/any_set.h"
#include "dgd/assert.h"
#include "pair/least_translation.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Relative tolerance of a user's own query, as by contactTest() and contactPairTest(); and how many times the
/// evaluations of a step its least translation may take: 64 are an expanding polytope, which may start from scratch.
constexpr double kExact = 1e-12;
constexpr int kPatience = 5;

/// Bounds that roundoff leaves farther apart than the tolerance still prove a result if they agree to this: 5
/// micrometres in half a metre, a thousandth of what Bullet's float pairs are off by. Beyond it, the pair is Bullet's.
constexpr double kCertifiedGap = 1e-5;

bool IsCertified(const Contact& contact) {
  switch (contact.status) {
    case dgd::Status::kOptimal:
    case dgd::Status::kSeparated:
    case dgd::Status::kCoincidentCenters:
      return true;
    case dgd::Status::kStalled:
    case dgd::Status::kIterationLimit:
      return contact.RelativeGap() <= kCertifiedGap;
    default:
      return false;
  }
}

dgd::Settings<double> SettingsOf(const Options& options, const QueryLimits& limits, const PairMotion& motion) {
  return {.relative_tolerance =
              limits.is_user_query ? std::min(kExact, options.relative_tolerance) : options.relative_tolerance,
          .max_iterations = options.max_iterations,
          .separation_limit = SeparationLimit(limits.range, motion)};
}

}  // namespace

PosedShape AdaptBody(SharedState& narrowphase, const btCollisionObjectWrapper& body, PairCache::Hull& hull,
                     bool for_user) {
  return AdaptShape(ConvexShapeOf(body), body.getWorldTransform(), narrowphase.options().geometry_mode,
                    narrowphase.hulls(), hull, narrowphase.HullUseFor(for_user), for_user);
}

PairQuery::PairQuery(const Options& options, const PosedShape& shape_a, const PosedShape& shape_b,
                     const QueryLimits& limits, double flush, const PairMotion& motion,
                     dgd::WarmStart<double>& warm_start)
    : options_(options),
      warm_start_(warm_start),
      shape_a_(shape_a),
      shape_b_(shape_b),
      limits_(limits),
      rules_{limits.range, limits.patch_settings, motion, flush},
      settings_(SettingsOf(options, limits, motion)),
      is_along_centers_(TouchAlongCenters(shape_a, shape_b)) {
  if (!options_.warm_start) warm_start_ = {};
  MoveCentersTogether(shape_a_, shape_b_);
}

Contact PairQuery::FindContact() {
  if (is_along_centers_) {
    const Contact contact = ContactAlongCenters(shape_a_, shape_b_);
    if (IsCertified(contact)) {
      warm_start_ = {};
      warm_start_.normal_1 = (shape_a_.pose.rotation.transpose() * contact.normal).normalized();
      return contact;
    }
  }
  if (limits_.is_user_query && (shape_a_.set.IsCustom() || shape_b_.set.IsCustom())) return FindDistance();
  Contact contact =
      dgd::GrowthDistance(shape_a_.set, shape_a_.pose, shape_b_.set, shape_b_.pose, settings_, &warm_start_);
  if (contact.status == dgd::Status::kNoInterior) {
    const Contact distance = FindDistance();
    return IsCertified(distance) ? distance : contact;
  }
  if (!IsCertified(contact) || contact.status == dgd::Status::kSeparated) return contact;
  if (contact.separation < -rules_.flush) TurnToTriangle(contact);
  if (limits_.is_user_query) {
    settings_.max_iterations *= kPatience;
  } else if (IsDeep(contact)) {
    stage_ = PairOutcome::Stage::kDeep;
  } else {
    return contact;
  }
  TurnToLeastTranslation(shape_a_, shape_b_, settings_, warm_start_, contact);
  return contact;
}

Contact PairQuery::FindDistance() {
  Contact contact;
  if (dgd::HasNormal(warm_start_)) contact.normal = shape_a_.pose.rotation * warm_start_.normal_1;
  settings_.relative_tolerance = options_.relative_tolerance;
  TurnToLeastTranslation(shape_a_, shape_b_, settings_, warm_start_, contact);
  warm_start_ = {.normal_1 = (shape_a_.pose.rotation.transpose() * contact.normal).normalized()};
  return contact;
}

void PairQuery::TurnToTriangle(Contact& contact) const {
  // Of a shape that shows no faces, the deepest point may be over another triangle.
  if (limits_.triangle_normal.isZero(0) || shape_a_.set.IsCustom()) return;
  // A triangle has no depth: of what is larger, its centre is outside of the part that is over it, and the direction
  // from there leans the more the deeper that part is.
  const Vector3 face =
      limits_.triangle_normal.dot(contact.normal) < 0 ? Vector3(-limits_.triangle_normal) : limits_.triangle_normal;
  const Vector3 on_a = SupportPoint(shape_a_, face);
  const double separation = face.dot(SupportPoint(shape_b_, -face) - on_a);
  if (!(separation > contact.separation)) return;
  contact.normal = face;
  contact.separation = separation;
  contact.witness_1 = on_a;
  contact.witness_2 = on_a + separation * face;
}

void PairQuery::FindPatch(Contact& contact, PairContacts& contacts) {
  dgd::WarmStart<double> warm_start = warm_start_;
  const auto plane_between = [&](const Pose& pose_a, const Pose& pose_b) {
    if (is_along_centers_) {
      PosedShape a{shape_a_.set, pose_a}, b{shape_b_.set, pose_b};
      MoveCentersTogether(a, b);
      if (const Contact plane = ContactAlongCenters(a, b); IsCertified(plane)) return plane;
    }
    return dgd::PlaneBetween(shape_a_.set, pose_a, shape_b_.set, pose_b, warm_start);
  };
  const auto patch_of = [&](const PosedShape& a, const PosedShape& b, const Contact& certified, const Moment& moment) {
    if (!options_.contact_patch || is_along_centers_ || limits_.is_nearest_only) return WitnessOnly(certified);
    dgd::FacingFaces<double> facing;
    dgd::FindFacingFaces(a.set, a.pose, b.set, b.pose, certified, facing);
    contacts.side = dgd::ReferenceSideOf(facing);
    return dgd_bullet::FindPatch(certified, facing, rules_, moment);
  };
  FindContactsByMotion(shape_a_, shape_b_, rules_, contact, plane_between, patch_of, contacts);
  DGD_ASSERT(contacts.patch.size <= limits_.patch_settings.max_points);
}

PairOutcome PairQuery::OutcomeOf(const Contact& contact, int patch_size) const {
  PairOutcome outcome{
      .iterations = contact.iterations, .patch_size = static_cast<std::uint8_t>(patch_size), .stage = stage_};
  if (contact.status == dgd::Status::kSeparated) {
    outcome.stage = PairOutcome::Stage::kSeparated;
  } else if (contact.status != dgd::Status::kCoincidentCenters) {
    outcome.gap = contact.RelativeGap();
  }
  return outcome;
}

PairOutcome PairQuery::FindContacts(PairContacts& contacts) {
  Contact contact = FindContact();
  DGD_ASSERT(contact.iterations >= 0);
  if (!IsCertified(contact)) return {.fallback = FallbackOf(contact.status)};
  const Contact solved = contact;
  FindPatch(contact, contacts);
  contacts.normal = contact.normal;
  DGD_ASSERT(contacts.patch.size == 0 || IsUnit(contacts.normal));
  return OutcomeOf(solved, contacts.patch.size);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
