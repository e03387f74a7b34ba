#include "contact_range.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include <algorithm>
#include <limits>

#include "lengths.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

namespace {

/// Whether Bullet's own algorithm has no contacts before the bodies touch: that of two boxes or of two spheres.
bool TouchFirstWithBullet(const btManifoldResult& output) {
  const int type = output.getBody0Wrap()->getCollisionShape()->getShapeType();
  return (type == BOX_SHAPE_PROXYTYPE || type == SPHERE_SHAPE_PROXYTYPE) &&
         type == output.getBody1Wrap()->getCollisionShape()->getShapeType();
}

}  // namespace

bool Rebounds(const btManifoldResult& output) {
  return gCalculateCombinedRestitutionCallback(output.getBody0Internal(), output.getBody1Internal()) > 0;
}

PairMotion MotionOfStep(const PairManifold& manifold, const BoundedBody& body_a, const BoundedBody& body_b,
                        const btDispatcherInfo& info) {
  if (!manifold.IsOwn() || !(info.m_timeStep > 0)) return {};
  return {body_a, body_b, double(info.m_timeStep)};
}

ContactRange RangeOfContacts(const Options& options, const PairManifold& manifold, const PairMotion& motion,
                             const btDispatcherInfo& info, const btManifoldResult& output) {
  const double breaking_threshold = manifold.BreakingThreshold();
  // Nothing keeps a sensor apart from others: it overlaps them first, in a step or without. A query gets what is near.
  const bool has_response =
      output.getBody0Internal()->hasContactResponse() && output.getBody1Internal()->hasContactResponse();
  const bool is_step = info.m_timeStep > 0;
  const bool touch_first = !IsUserQuery(output) && (!has_response || (!is_step && TouchFirstWithBullet(output)));
  if (touch_first || !motion.IsKnown()) {
    const double distance = touch_first ? double(output.m_closestPointDistanceThreshold)
                                        : ContactDistance(options, breaking_threshold, output);
    return {distance, distance};
  }
  double touching = options.contact_distance > 0 ? options.contact_distance : breaking_threshold;
  const bool is_rebound = Rebounds(output);
  if (is_rebound) {
    // Bodies that only touch must not share an impact that one of them is about to take: it passes on from each to the
    // next.
    const bool is_loaded = !manifold.IsEmpty() && IsLoaded(*manifold);
    touching = (is_loaded ? 1 : -1) * NegligibleDistance(breaking_threshold);
  }
  const double limit =
      options.speculative_contacts ? std::numeric_limits<double>::infinity() : std::max(touching, breaking_threshold);
  return {touching, limit, is_rebound};
}

dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           const ContactRange& range, bool is_user_query) {
  const double breaking_threshold = manifold.BreakingThreshold();
  return {.contact_distance = range.touching,
          .spacing = breaking_threshold,
          .equal_depth = (is_user_query ? kNoDepthPart : kEqualDepthPart) * breaking_threshold,
          .max_points = options.patch_size};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
