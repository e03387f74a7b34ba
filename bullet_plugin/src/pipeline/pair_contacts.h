// What a step asks of a pair's contacts, and how they are handed over: the same whatever has found them.
#pragma once

#include <algorithm>

#include "algorithms/pair_manifold.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "pipeline/manifold_writer.h"
#include "pipeline/pair_motion.h"
#include "shapes/solver_types.h"

class btManifoldResult;
struct btDispatcherInfo;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Up to which separation bodies are in contact.
///
/// A point ahead of touching carries nothing unless the step closes its gap, but by other bodies' impacts it may: so
/// bodies are in contact within Bullet's own breaking threshold. Where bodies approach each other, though, only if they
/// really meet, since a contact would act on bodies that pass each other; and bodies that rebound only where they touch
/// or will within the step, since a gap over the time step would be taken from the speed at which they part.
struct ContactRange {
  double touching =
      0;             ///< Metres: not farther apart, bodies are in contact however they move. Negative for an overlap.
  double limit = 0;  ///< Metres: farther apart, they are not, even if they will be by the end of the step.
  bool is_rebound = false;  ///< Whether the bodies rebound.
};

/// The motion that contacts may be ahead of; none where contacts are no step's, or go into a manifold that others
/// refresh.
PairMotion MotionOfStep(const PairManifold& manifold, const BodyReach& body_a, const BodyReach& body_b,
                        const btDispatcherInfo& info);

ContactRange RangeOfContacts(const Options& options, const PairManifold& manifold, const PairMotion& motion,
                             const btManifoldResult& output);

/// Bodies that are farther apart have no contacts in this step, so that no query needs to go on; metres.
inline double SeparationLimit(const ContactRange& range, const PairMotion& motion) {
  return std::max(range.touching, std::min(motion.MaxApproach(), range.limit));
}

/// Whether contacts may be kept from step to step, so that they come from other poses than this step's.
bool MayKeepContacts(const Options& options, const PairManifold& manifold);

/// @param is_asked  By an app, for the contacts themselves.
dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           const ContactRange& range, bool is_asked);

/// What becomes of the points that the manifold of a call's bodies holds.
ManifoldUpdate ManifoldUpdateOf(const Options& options, const btManifoldResult& output);

/// Makes the manifold's points those of the patch, through the output.
/// @param normal  Unit, from A to B, of which A is the manifold's first body, or the call's where it is shared.
/// @param motion  Of A and B.
void WriteContacts(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                   const Options& options, const PairManifold& manifold, btManifoldResult& output);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
