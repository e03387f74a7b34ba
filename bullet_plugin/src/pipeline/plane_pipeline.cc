#include "pipeline/plane_pipeline.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <limits>
#include <stdexcept>

#include "conditioning/rim_points.h"
#include "conditioning/speculative_contacts.h"
#include "dgd/assert.h"
#include "dgd/half_space_patch.h"
#include "pipeline/contact_range.h"
#include "pipeline/pair_motion.h"
#include "pipeline/pair_patch.h"
#include "pipeline/shared_stages.h"
#include "pipeline/user_query.h"
#include "shapes/bullet_conversions.h"
#include "shapes/shape_adapter.h"

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

/// Against planes, Bullet's boxes have sharp edges.
GeometryMode GeometryAgainstPlanes(const btConvexShape& shape, GeometryMode mode) {
  return shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? GeometryMode::kSharp : mode;
}

dgd::ContactPatch<double> FindPatchOnPlane(const PosedShape& shape, const Contact& contact,
                                           const dgd::PatchSettings<double>& settings, const PairMotion& motion,
                                           const Options& options) {
  if (!options.contact_patch) return WitnessOnly(contact);
  const auto facing = dgd::FindFacingFaces(shape.set, shape.pose, dgd::HalfSpace<double>(), contact);
  dgd::ContactPatch<double> patch = FindPatch(contact, facing, settings, motion);
  if (options.rim_damping) AddRimPointOnPlane(shape, contact, facing, settings, motion, patch);
  return patch;
}

/// The second and third stages: the bounding box is out of reach; or the closed form of the distance.
PairOutcome FindContacts(PairState& pair, std::shared_ptr<const CachedHull>& hull, const PairCall& call,
                         PairContacts& contacts) {
  const Options& options = pair.options();
  const PairManifold& manifold = pair.manifold;
  const btCollisionObjectWrapper& convex = call.bodies.first;
  const btCollisionObject &body = *convex.getCollisionObject(), &ground = *call.bodies.second.getCollisionObject();
  const auto& shape = *static_cast<const btConvexShape*>(convex.getCollisionShape());
  const bool is_user_query = IsUserQuery(call.output);
  const Border border = BorderOf(call.bodies.second);
  PairMotion& motion = contacts.motion;
  if (pair.is_for_step) motion = MotionOfStep(manifold, BoundedBody(body), BoundedBody(ground), call.info);
  const ContactRange range = RangeOfContacts(options, manifold, motion, call.output);
  const auto is_out_of_reach = [&](double height) {
    return height > range.touching && (height > range.limit || !motion.MayApproachBy(height, -border.up));
  };
  PairOutcome outcome{.stage = PairOutcome::Stage::kSeparated};
  pair.had_contact = false;
  // A plane has no end, so that all bodies of a world are paired with it, most of them far above.
  if (manifold.IsOwn() && manifold.IsEmpty() && !is_user_query && is_out_of_reach(HeightOfBox(body, border))) {
    return outcome;
  }

  const PosedShape posed =
      AdaptShape(shape, convex.getWorldTransform(), GeometryAgainstPlanes(shape, options.geometry_mode),
                 pair.narrowphase.hulls(), hull, pair.narrowphase.HullUseFor(is_user_query));
  const Pose pose_of_plane{dgd::FrameAlong<double>(border.up), border.point};
  const Contact contact = dgd::GrowthDistance(posed.set, posed.pose, dgd::HalfSpace<double>(), pose_of_plane);
  // Sets without an interior have a separation all the same.
  if (contact.status == dgd::Status::kInvalidInput) return {.fallback = Fallback::kInvalid};
  DGD_ASSERT(IsUnit(contact.normal));
  contacts.normal = contact.normal;
  outcome.iterations = contact.iterations;
  if (is_out_of_reach(contact.separation)) return outcome;

  outcome.stage = PairOutcome::Stage::kSolved;
  const double flush = NegligibleDistance(manifold.BreakingThreshold());
  // As with two convex shapes; a point of the plane is enough of it.
  const PosedShape point_of_plane{dgd::RoundedSet{dgd::Point<double>(), 0.0}, pose_of_plane};
  contacts.is_passing = contact.separation > flush && TurnsClear(posed, point_of_plane, motion, contact.normal, flush);
  const bool may_be_knocked = contact.separation <= range.touching && !range.is_rebound;
  if (!contacts.is_passing || may_be_knocked) {
    const auto settings = PatchSettingsOf(options, manifold, range, is_user_query);
    contacts.patch = FindPatchOnPlane(posed, contact, settings, motion, options);
  }
  if (contacts.is_passing) LetPass(contacts.patch, contact.normal, motion, flush);
  outcome.patch_size = contacts.patch.size;
  DGD_ASSERT(outcome.patch_size <= options.patch_size);
  return outcome;
}

}  // namespace

PairOutcome RunPlanePipeline(PairState& pair, std::shared_ptr<const CachedHull>& hull, const PairCall& call) {
  if (const auto outcome = TryRecycledContacts(pair, {call.bodies.first, hull}, {call.bodies.second, nullptr}, call))
    return *outcome;
  PairContacts contacts;
  const PairOutcome outcome = CatchFailures([&] { return FindContacts(pair, hull, call, contacts); });
  if (outcome.fallback) return SolveByBullet(pair, call, *outcome.fallback);
  // The plane's own face is the contacts' reference face.
  return WriteContacts(pair, call, contacts, false, dgd::FaceHolder::kSet2, outcome);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
