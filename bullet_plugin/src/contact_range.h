// The distance up to which bodies have contacts.
#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "lengths.h"
#include "pair_manifold.h"
#include "pair_motion.h"
#include "solver_types.h"

struct btDispatcherInfo;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Distance up to which bodies have contacts, with what a user's query adds; metres.
inline double ContactDistance(const Options& options, double breaking_threshold, const btManifoldResult& output) {
  return (options.contact_distance > 0 ? options.contact_distance : breaking_threshold) +
         double(output.m_closestPointDistanceThreshold);
}

/// The separations at which bodies are in contact.
///
/// A point ahead of touching carries nothing unless the step closes its gap, but by other bodies' impacts it may: so
/// bodies are in contact within Bullet's own breaking threshold. Where bodies approach each other, though, only if they
/// really meet, since a contact would act on bodies that pass each other; and bodies that rebound only where they touch
/// or will within the step, since a gap over the time step would be taken from the speed at which they part.
/// Bodies without a contact response meet no solver, and are in contact when they overlap. So are two boxes or spheres
/// where no world steps, as with Bullet's own algorithms: apps take any contact for a collision.
struct ContactRange {
  /// Separation up to which bodies are in contact however they move; metres, negative for an overlap.
  double touching = 0;
  /// Separation beyond which they are not, even if they will be by the end of the step; metres.
  double limit = 0;
  /// Whether the bodies rebound.
  bool is_rebound = false;
};

/// Whether a result's bodies have a restitution.
bool Rebounds(const btManifoldResult& output);

/// The motion that a step's contacts may be ahead of; none for a manifold that others refresh.
PairMotion MotionOfStep(const PairManifold& manifold, const BoundedBody& body_a, const BoundedBody& body_b,
                        const btDispatcherInfo& info);

ContactRange RangeOfContacts(const Options& options, const PairManifold& manifold, const PairMotion& motion,
                             const btDispatcherInfo& info, const btManifoldResult& output);

/// Distance beyond which bodies have no contacts in this step, so that no query needs to go on; metres.
inline double SeparationLimit(const ContactRange& range, const PairMotion& motion) {
  return std::max(range.touching, std::min(motion.MaxApproach(), range.limit));
}

/// The settings of a patch.
/// @param is_user_query  Whether a user queries the contacts themselves.
dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           const ContactRange& range, bool is_user_query);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
