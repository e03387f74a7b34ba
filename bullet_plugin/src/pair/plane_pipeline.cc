#include "pair/plane_pipeline.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <limits>
#include <stdexcept>

#include "bullet_conversions.h"
#include "contact_range.h"
#include "dgd/assert.h"
#include "dgd/contact/half_space_patch.h"
#include "pair/pair_patch.h"
#include "pair/shared_stages.h"
#include "pair_motion.h"
#include "shapes/shape_adapter.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// A plane's point and upward unit normal; world.
struct Border {
  Vector3 point, up;
};

/// Throws std::invalid_argument where the plane has no normal.
Border BorderOf(const btCollisionObjectWrapper& plane) {
  const auto& shape = *static_cast<const btStaticPlaneShape*>(plane.getCollisionShape());
  const Pose pose = FromBullet(plane.getWorldTransform());
  const Vector3 normal = FromBullet(shape.getPlaneNormal());
  // Bullet has made it a unit vector, which is zero or NaN if it was given none.
  if (!(normal.squaredNorm() > 0.5)) throw std::invalid_argument("a plane without a normal");
  const Vector3 up = (pose.rotation * normal).normalized();
  return {pose.translation + double(shape.getPlaneConstant()) * up, up};
}

/// Height of a body's bounding box over the plane, as the broadphase has it; metres. NaN without one.
double HeightOfBox(const btCollisionObject& body, const Border& border) {
  const btBroadphaseProxy* box = body.getBroadphaseHandle();
  if (box == nullptr) return std::numeric_limits<double>::quiet_NaN();
  const Vector3 lower = FromBullet(box->m_aabbMin), upper = FromBullet(box->m_aabbMax);
  return border.up.dot((upper + lower) / 2 - border.point) - border.up.cwiseAbs().dot((upper - lower) / 2);
}

/// Whether a body at a height over a plane has no contact, and will have none in the step.
bool IsOutOfReach(double height, const Border& border, const ContactRange& range, const PairMotion& motion) {
  return height > range.touching && (height > range.limit || !motion.MayApproachBy(height, -border.up));
}

/// The third stage: the closed form of the distance, and the patch.
PairOutcome SolveDistance(PairState& pair, std::shared_ptr<const CachedHull>& hull, const PairCall& call,
                          const Border& border, const ContactRange& range, PairContacts& contacts) {
  const Options& options = pair.options();
  const bool is_user_query = IsUserQuery(call.output);
  const btCollisionObjectWrapper& body = call.bodies.first;
  const btConvexShape& shape = ConvexShapeOf(body);
  const PosedShape posed = AdaptShape(shape, body.getWorldTransform(), options.geometry_mode, pair.narrowphase.hulls(),
                                      hull, pair.narrowphase.HullUseFor(is_user_query));
  const Pose pose_of_plane{dgd::FrameAlong<double>(border.up), border.point};
  Contact contact = dgd::GrowthDistance(posed.set, posed.pose, dgd::HalfSpace<double>(), pose_of_plane);
  // Sets without an interior have a separation all the same.
  if (contact.status == dgd::Status::kInvalidInput) return {.fallback = Fallback::kInvalid};
  DGD_ASSERT(IsUnit(contact.normal));
  const int iterations = contact.iterations;  // Of where the bodies are; a meeting's contact counts none.
  const auto settings = PatchSettingsOf(options, pair.manifold, range, is_user_query);
  const PatchRules rules{range, settings, contacts.motion, NegligibleDistance(pair.manifold.BreakingThreshold())};
  // A sweep along the plane's normal needs no more of the plane than a point.
  const PosedShape point_of_plane{dgd::RoundedSet{dgd::Point<double>(), 0.0}, pose_of_plane};
  const auto plane_between = [&](const Pose& pose, const Pose& plane) {
    return dgd::GrowthDistance(posed.set, pose, dgd::HalfSpace<double>(), plane);
  };
  const auto patch_of = [&](const PosedShape& moved, const PosedShape&, const Contact& certified,
                            const Moment& moment) {
    if (!options.contact_patch || GetsNearestOnly(call, pair.is_for_step)) return WitnessOnly(certified);
    const auto facing = dgd::FindFacingFaces(moved.set, moved.pose, dgd::HalfSpace<double>(), certified);
    return FindPatch(certified, facing, rules, moment);
  };
  FindContactsByMotion(posed, point_of_plane, rules, contact, plane_between, patch_of, contacts);
  contacts.normal = contact.normal;
  // The plane's own face is the contacts' reference face.
  contacts.side = dgd::ReferenceSide::kSet2;
  DGD_ASSERT(contacts.patch.size <= options.patch_size);
  return {.iterations = iterations,
          .patch_size = static_cast<std::uint8_t>(contacts.patch.size),
          .stage = contacts.patch.size > 0 ? PairOutcome::Stage::kSolved : PairOutcome::Stage::kSeparated};
}

/// The second stage: the body's bounding box is out of reach; and else the third. A plane has no end, so that all
/// bodies of a world are paired with it, most of them far above.
PairOutcome FindContacts(PairState& pair, std::shared_ptr<const CachedHull>& hull, const PairCall& call,
                         PairContacts& contacts) {
  const PairManifold& manifold = pair.manifold;
  const btCollisionObject& body = *call.bodies.first.getCollisionObject();
  const btCollisionObject& ground = *call.bodies.second.getCollisionObject();
  const Border border = BorderOf(call.bodies.second);
  if (pair.is_for_step) contacts.motion = MotionOfStep(manifold, BoundedBody(body), BoundedBody(ground), call.info);
  const ContactRange range = RangeOfContacts(pair.options(), manifold, contacts.motion, call.info, call.output);
  pair.had_contact = false;
  if (manifold.IsOwn() && manifold.IsEmpty() && !IsUserQuery(call.output) &&
      IsOutOfReach(HeightOfBox(body, border), border, range, contacts.motion)) {
    return {.stage = PairOutcome::Stage::kSeparated};
  }
  return SolveDistance(pair, hull, call, border, range, contacts);
}

}  // namespace

PairOutcome RunPlanePipeline(PairState& pair, std::shared_ptr<const CachedHull>& hull, const PairCall& call) {
  if (const auto outcome = TryRecycledContacts(pair, {call.bodies.first, hull}, {call.bodies.second, nullptr}, call))
    return *outcome;
  PairContacts contacts;
  const PairOutcome outcome = CatchFailures([&] { return FindContacts(pair, hull, call, contacts); });
  if (outcome.fallback) return SolveByBullet(pair, call, *outcome.fallback);
  return WriteContacts(pair, call, contacts, false, outcome);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
