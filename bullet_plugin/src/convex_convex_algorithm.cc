#include "convex_convex_algorithm.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "friction_anchors.h"
#include "manifold_writer.h"
#include "pair_distance.h"
#include "pair_impact.h"
#include "pair_motion.h"
#include "pair_patch.h"
#include "pair_solver.h"

namespace dgd_bullet {
namespace {

/// Bounds that rounding keeps farther apart than the tolerance still prove a result if they agree to this: 5
/// micrometres in half a metre, a thousandth of what Bullet's float pairs are off by. Beyond it, Bullet answers.
constexpr double kCertifiedGap = 1e-5;

bool IsCertified(const dgd::Result<double>& result) {
  switch (result.status) {
    case dgd::Status::kOptimal:
    case dgd::Status::kCoincidentCenters:
      return true;
    case dgd::Status::kStalled:
    case dgd::Status::kIterationLimit:
      return result.RelativeGap() <= kCertifiedGap;
    default:
      return false;
  }
}

const btConvexShape& ShapeOf(const btCollisionObjectWrapper* body) {
  return *static_cast<const btConvexShape*>(body->getCollisionShape());
}

}  // namespace

ConvexConvexAlgorithm::ConvexConvexAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase,
                                             bool speculative)
    : btCollisionAlgorithm(info), narrowphase_(narrowphase), manifold_(info.m_manifold), speculative_(speculative) {}

ConvexConvexAlgorithm::~ConvexConvexAlgorithm() {
  if (owns_manifold_) m_dispatcher->releaseManifold(manifold_);
}

void ConvexConvexAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                             const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                             btManifoldResult* output) {
  if (!HasManifold(body_0, body_1)) return;
  output->setPersistentManifold(manifold_);
  if (const std::optional<dgd::Status> failure = FindContacts(body_0, body_1, info, *output)) {
    narrowphase_.CountFallback(*failure);
    // Bullet has no answer to what is no shape or no pose either: it reads points that a hull has not, and keeps NaN.
    if (*failure == dgd::Status::kInvalidInput) {
      if (owns_manifold_) manifold_->clearManifold();
      return;
    }
    narrowphase_.FallBack(*m_dispatcher, body_0, body_1, info, *output);
    if (owns_manifold_) output->refreshContactPoints();
  }
}

bool ConvexConvexAlgorithm::HasManifold(const btCollisionObjectWrapper* body_0,
                                        const btCollisionObjectWrapper* body_1) {
  if (manifold_ == nullptr) {
    manifold_ = m_dispatcher->getNewManifold(body_0->getCollisionObject(), body_1->getCollisionObject());
    owns_manifold_ = manifold_ != nullptr;
  }
  return manifold_ != nullptr;
}

std::optional<dgd::Status> ConvexConvexAlgorithm::FindContacts(const btCollisionObjectWrapper* body_0,
                                                               const btCollisionObjectWrapper* body_1,
                                                               const btDispatcherInfo& info,
                                                               btManifoldResult& output) try {
  const Options& options = narrowphase_.options();
  const auto adapt = [&](const btCollisionObjectWrapper* body, std::shared_ptr<const CachedHull>& hull) {
    return AdaptShape(ShapeOf(body), body->getWorldTransform(), options.geometry_mode, narrowphase_.hulls(), hull);
  };
  PosedShape shape_a = adapt(body_0, hull_0_);
  PosedShape shape_b = adapt(body_1, hull_1_);
  MoveCentersTogether(shape_a, shape_b);
  const PairMotion motion = MotionToMeet(*body_0->getCollisionObject(), *body_1->getCollisionObject(), info);
  const double breaking_threshold = double(manifold_->getContactBreakingThreshold());
  const double contact_distance = (options.contact_distance > 0 ? options.contact_distance : breaking_threshold) +
                                  double(output.m_closestPointDistanceThreshold);

  dgd::Settings<double> settings;
  settings.relative_tolerance = options.relative_tolerance;
  settings.max_iterations = options.max_iterations;
  settings.separation_limit = std::max(contact_distance, motion.MaxApproach());
  dgd::Result<double> result;
  const bool has_followed = can_follow_ && FollowDistance(shape_a, shape_b, settings, warm_start_, result);
  if (!has_followed) result = SolvePair(shape_a, shape_b, settings, warm_start_);
  can_follow_ = has_followed && result.status == dgd::Status::kOptimal;

  dgd::ContactPatch<double> patch;
  if (result.status != dgd::Status::kSeparated) {
    if (!IsCertified(result)) return result.status;
    const bool is_near = result.separation <= contact_distance;
    if (is_near || TouchWithinStep(shape_a, shape_b, result, motion)) {
      if (options.normal_mode == NormalMode::kLeastTranslation && !has_followed) {
        can_follow_ = TurnToLeastTranslation(shape_a, shape_b, settings, warm_start_, result);
      }
      const dgd::PatchSettings<double> of_patch{.contact_distance = contact_distance,
                                                .spacing = breaking_threshold,
                                                .angular_tolerance = options.angular_tolerance,
                                                .max_points = options.patch_size};
      patch = options.contact_patch ? FindPatch(shape_a, shape_b, result, of_patch, motion) : WitnessOnly(result);
    }
  }
  WriteContacts(patch, result.normal, output);
  return std::nullopt;
} catch (const std::exception&) {
  // A shape that is not one: NaN or infinite sizes, no points, no memory for its hull.
  return dgd::Status::kInvalidInput;
}

PairMotion ConvexConvexAlgorithm::MotionToMeet(const btCollisionObject& object_0, const btCollisionObject& object_1,
                                               const btDispatcherInfo& info) const {
  // A shared manifold is refreshed by whoever shares it, and loses far points there. A contact that is met early takes
  // its part of the step from the speed of the rebound.
  const bool meets =
      speculative_ && owns_manifold_ && !(btManifoldResult::calculateCombinedRestitution(&object_0, &object_1) > 0);
  return meets ? PairMotion(object_0, object_1, double(info.m_timeStep)) : PairMotion();
}

void ConvexConvexAlgorithm::WriteContacts(const dgd::ContactPatch<double>& patch, const Vector3& normal,
                                          btManifoldResult& output) {
  if (!owns_manifold_) {
    WritePatch(patch, normal, output);
    return;
  }
  if (patch.size == 0 && manifold_->getNumContacts() == 0) return;  // As most pairs of a broadphase, step after step.
  const Options& options = narrowphase_.options();
  if (options.contact_patch) DropStalePoints(*manifold_, patch);
  // Bullet refuses points beyond the breaking threshold: speculative ones need it raised until they have passed.
  const btScalar breaking_threshold = manifold_->getContactBreakingThreshold();
  for (int i = 0; i < patch.size; ++i) {
    const btScalar separation = btScalar(patch.points[static_cast<std::size_t>(i)].separation);
    // Rounding to float must not put the point beyond its own threshold, nor its distance after a refresh.
    constexpr btScalar kSlack = btScalar(1.001);
    if (separation * kSlack > manifold_->getContactBreakingThreshold()) {
      manifold_->setContactBreakingThreshold(separation * kSlack);
    }
  }
  std::optional<FrictionAnchors> anchors;
  if (options.friction_anchors && options.contact_patch) anchors.emplace(*manifold_);
  WritePatch(patch, normal, output);
  if (anchors) anchors->Restore(*manifold_);
  output.refreshContactPoints();
  OrderByImpulse(*manifold_);
  manifold_->setContactBreakingThreshold(breaking_threshold);
}

btScalar ConvexConvexAlgorithm::calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                                      btManifoldResult*) {
  return btScalar(1);
}

void ConvexConvexAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  if (owns_manifold_) manifolds.push_back(manifold_);
}

}  // namespace dgd_bullet
