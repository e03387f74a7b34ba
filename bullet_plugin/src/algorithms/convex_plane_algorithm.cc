#include "algorithms/convex_plane_algorithm.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "conditioning/contact_recycling.h"
#include "conditioning/speculative_contacts.h"
#include "dgd/half_space_patch.h"
#include "pipeline/contact_distance.h"
#include "pipeline/pair_contacts.h"
#include "pipeline/pair_motion.h"
#include "pipeline/pair_patch.h"
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
  // Bullet has made it a unit vector, which is zero or no number if it was given none.
  if (!(normal.squaredNorm() > 0.5)) throw std::invalid_argument("a plane without a normal");
  const Vector3 up = (pose.rotation * normal).normalized();
  return {pose.translation + double(shape.getPlaneConstant()) * up, up};
}

/// Height of a body's bounding box over the plane, as the broadphase has it; metres. No number without one.
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

dgd::ContactPatch<double> FindPatchOnPlane(const PosedShape& shape, const dgd::Result<double>& result,
                                           const dgd::PatchSettings<double>& settings, const PairMotion& motion,
                                           const Options& options) {
  const auto facing = dgd::FindFacingFaces(shape.set, shape.pose, dgd::HalfSpace<double>(), result);
  dgd::ContactPatch<double> patch = FindPatch(result, facing, settings, motion);
  if (options.rim_damping) AddRimPoint(shape, result, facing, settings, motion, patch);
  return patch;
}

}  // namespace

ConvexPlaneAlgorithm::ConvexPlaneAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase,
                                           bool is_for_step)
    : PairAlgorithm(info, narrowphase, is_for_step) {}

void ConvexPlaneAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                            const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                            btManifoldResult* output) {
  const bool is_plane_first = body_0->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE;
  Process(is_plane_first ? Bodies{*body_1, *body_0} : Bodies{*body_0, *body_1}, info, *output);
}

std::optional<Fallback> ConvexPlaneAlgorithm::FindContacts(const Bodies& bodies, const btDispatcherInfo& info,
                                                           btManifoldResult& output) try {
  const btCollisionObjectWrapper &convex = bodies.first, &plane = bodies.second;
  const Options& options = narrowphase_.options();
  const auto& shape = *static_cast<const btConvexShape*>(convex.getCollisionShape());
  const btCollisionObject &body = *convex.getCollisionObject(), &ground = *plane.getCollisionObject();
  const Border border = BorderOf(plane);
  const PairMotion motion =
      is_for_step_ ? MotionOfStep(manifold_, BodyReach(body), BodyReach(ground), info) : PairMotion();
  const ContactRange range = RangeOfContacts(options, manifold_, motion, output);
  const auto is_out_of_reach = [&](double height) {
    return height > range.touching && (height > range.limit || !motion.MayApproachBy(height, -border.up));
  };
  PairOutcome outcome{.way = PairOutcome::Way::kSeparated};
  had_contact_ = false;
  // A plane has no end, so that all bodies of a world are asked about, most of them far above.
  if (manifold_.IsOwn() && manifold_.IsEmpty() && !IsAskedByApp(output) && is_out_of_reach(HeightOfBox(body, border))) {
    Count(outcome, convex);
    return std::nullopt;
  }

  const PosedShape posed =
      AdaptShape(shape, convex.getWorldTransform(), GeometryAgainstPlanes(shape, options.geometry_mode),
                 narrowphase_.hulls(), hull_, narrowphase_.HullUseFor(IsAskedByApp(output)));
  const Pose pose_of_plane{dgd::FrameAlong<double>(border.up), border.point};
  const auto result = dgd::GrowthDistance(posed.set, posed.pose, dgd::HalfSpace<double>(), pose_of_plane);
  // Sets without an interior have a separation all the same.
  if (result.status == dgd::Status::kInvalidInput) return Fallback::kInvalid;
  outcome.iterations = result.iterations;
  dgd::ContactPatch<double> patch;
  bool turns_clear = false;
  if (!is_out_of_reach(result.separation)) {
    outcome.way = PairOutcome::Way::kSolved;
    const double flush = NegligibleDistance(manifold_.BreakingThreshold());
    // As with two convex shapes; a point of the plane is enough of it.
    const PosedShape point_of_plane{dgd::RoundedSet{dgd::Point<double>(), 0.0}, pose_of_plane};
    turns_clear = result.separation > flush && TurnsClear(posed, point_of_plane, motion, result.normal, flush);
    const bool may_be_knocked = result.separation <= range.touching && !range.is_rebound;
    if (!turns_clear || may_be_knocked) {
      const auto settings = PatchSettingsOf(options, manifold_, range, IsAskedByApp(output));
      patch = options.contact_patch ? FindPatchOnPlane(posed, result, settings, motion, options) : WitnessOnly(result);
    }
    if (turns_clear) LetPass(patch, result.normal, motion, flush);
  }
  outcome.patch_size = patch.size;
  Count(outcome, convex);
  if (patch.size == 0 && !manifold_) return std::nullopt;
  if (!EnsureManifold(bodies, output)) return Fallback::kNoMemory;
  had_contact_ = patch.size > 0;
  WriteContacts(patch, result.normal, motion, options, manifold_, output);
  if (MayRecycle() && !turns_clear) {
    // The plane's own face is what holds them.
    const bool has_footing = manifold_->getNumContacts() >= FewestOfFooting(convex, plane);
    RememberRest(bodies, has_footing ? FootingOn(dgd::FaceHolder::kSet2, *manifold_) : Footing(), motion);
  }
  return std::nullopt;
} catch (const std::bad_alloc&) {
  return Fallback::kNoMemory;  // For a hull.
} catch (const std::exception&) {
  return Fallback::kInvalid;  // What is no shape.
}

void ConvexPlaneAlgorithm::Count(const PairOutcome& outcome, const btCollisionObjectWrapper& convex) {
  PairCounters* counters = narrowphase_.pair_counters();
  if (counters != nullptr) counters->Count(convex.getCollisionShape()->getShapeType(), STATIC_PLANE_PROXYTYPE, outcome);
}

bool ConvexPlaneAlgorithm::UpdateRecycledContacts(const Bodies& bodies, double anchor_time_step,
                                                  btManifoldResult& output) {
  return KeepContacts(*resting_, bodies.first, bodies.second, hull_, nullptr, anchor_time_step, *manifold_, output);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
