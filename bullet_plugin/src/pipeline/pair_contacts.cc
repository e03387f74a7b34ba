#include "pipeline/pair_contacts.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <limits>

#include "conditioning/just_touching.h"
#include "pipeline/contact_distance.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Depths that make no difference to a simulation, of the breaking threshold: 20 micrometres for large bodies. And to
/// anybody: picometres.
constexpr double kEqualDepth = 1e-3, kNoDepth = 1e-10;

bool Rebounds(const btManifoldResult& output) {
  return gCalculateCombinedRestitutionCallback(output.getBody0Internal(), output.getBody1Internal()) > 0;
}

}  // namespace

PairMotion MotionOfStep(const PairManifold& manifold, const BodyReach& body_a, const BodyReach& body_b,
                        const btDispatcherInfo& info) {
  if (!manifold.IsOwn() || !(info.m_timeStep > 0)) return {};
  return {body_a, body_b, double(info.m_timeStep)};
}

ContactRange RangeOfContacts(const Options& options, const PairManifold& manifold, const PairMotion& motion,
                             const btManifoldResult& output) {
  const double breaking_threshold = manifold.BreakingThreshold();
  if (!motion.IsKnown()) {
    const double distance = ContactDistance(options, breaking_threshold, output);
    return {distance, distance};
  }
  // Nothing is to be kept apart: such bodies, sensors most often, are in contact when they overlap.
  const bool has_response =
      output.getBody0Internal()->hasContactResponse() && output.getBody1Internal()->hasContactResponse();
  if (!has_response) return {0, 0};
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

bool MayKeepContacts(const Options& options, const PairManifold& manifold) {
  return options.keep_resting_contacts && manifold.IsOwn() && options.contact_patch && options.warm_start;
}

dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           const ContactRange& range, bool is_asked) {
  const double breaking_threshold = manifold.BreakingThreshold();
  return {.contact_distance = range.touching,
          .spacing = breaking_threshold,
          .equal_depth = (is_asked ? kNoDepth : kEqualDepth) * breaking_threshold,
          .max_points = options.patch_size};
}

ManifoldUpdate ManifoldUpdateOf(const Options& options, const btManifoldResult& output) {
  // A shape without faces shows a point a step: as with Bullet's own narrowphase, a patch is what steps bring together.
  const bool has_patch = options.contact_patch && ShowsFaces(*output.getBody0Wrap()->getCollisionShape()) &&
                         ShowsFaces(*output.getBody1Wrap()->getCollisionShape());
  return {.drop_stale = has_patch, .hold_stuck = options.friction_anchors};
}

void WriteContacts(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                   const Options& options, const PairManifold& manifold, btManifoldResult& output) {
  if (!manifold.IsOwn()) return WritePatch(patch, normal, output);
  if (patch.size == 0 && manifold.IsEmpty()) return;  // As most pairs of a broadphase, step after step.
  UpdateManifold(patch, normal, motion, ManifoldUpdateOf(options, output), output);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
