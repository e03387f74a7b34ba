#include "pair_contacts.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "manifold_writer.h"

namespace dgd_bullet {
namespace {

/// Depths that make no difference to a simulation, of the breaking threshold: 20 micrometres for large bodies. And to
/// anybody: picometres.
constexpr double kEqualDepth = 1e-3, kNoDepth = 1e-10;

}  // namespace

bool MeetsEarly(const PairManifold& manifold, const btCollisionObject& object_0, const btCollisionObject& object_1) {
  // A shared manifold is refreshed by whoever shares it, and loses far points there. A contact that is met early takes
  // its part of the step from the speed of the rebound.
  return manifold.IsOwn() && !(btManifoldResult::calculateCombinedRestitution(&object_0, &object_1) > 0);
}

bool MayKeepContacts(const Options& options, const PairManifold& manifold) {
  return options.keep_resting_contacts && manifold.IsOwn() && options.contact_patch && options.warm_start;
}

dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           double contact_distance, bool is_asked) {
  const double breaking_threshold = manifold.BreakingThreshold();
  return {.contact_distance = contact_distance,
          .spacing = breaking_threshold,
          .equal_depth = (is_asked ? kNoDepth : kEqualDepth) * breaking_threshold,
          .max_points = options.patch_size};
}

void WriteContacts(const dgd::ContactPatch<double>& patch, const Vector3& normal, const Options& options,
                   const PairManifold& manifold, btManifoldResult& output) {
  if (!manifold.IsOwn()) return AddToShared(patch, normal, kEqualDepth * manifold.BreakingThreshold(), output);
  if (patch.size == 0 && manifold.IsEmpty()) return;  // As most pairs of a broadphase, step after step.
  UpdateManifold(patch, normal, {.drop_stale = options.contact_patch, .hold_stuck = options.friction_anchors}, output);
}

}  // namespace dgd_bullet
