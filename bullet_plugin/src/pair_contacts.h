// What a step asks of a pair's contacts, and how they are handed over: the same whatever has found them.
#pragma once

#include <algorithm>

#include "dgd/contact_patch.h"
#include "dgd_bullet/options.h"
#include "pair_manifold.h"
#include "pair_motion.h"
#include "solver_types.h"

class btManifoldResult;
struct btDispatcherInfo;

namespace dgd_bullet {

/// Up to which separation bodies are in contact.
///
/// A point that is handed over ahead of touching takes its gap over the time step from the speed at which the bodies
/// part, and acts on bodies that pass each other. So a pair that is apart has contacts only if the motion of this step
/// closes the gap. What has been in contact keeps its points within Bullet's own breaking threshold: they carry
/// nothing unless the gap closes.
struct ContactRange {
  double touching;  ///< Metres: not farther apart, bodies are in contact however they move. Negative for an overlap.
  double limit;     ///< Metres: farther apart, they are not, even if they will be by the end of the step.
};

/// The motion that contacts may be ahead of; none where contacts are no step's, or go into a manifold that others
/// refresh.
PairMotion MotionOfStep(const PairManifold& manifold, const BodyReach& body_a, const BodyReach& body_b,
                        const btDispatcherInfo& info);

/// @param was_in_contact  In the last step.
ContactRange RangeOfContacts(const Options& options, const PairManifold& manifold, const PairMotion& motion,
                             bool was_in_contact, const btManifoldResult& output);

/// Separation of a pair of which nothing needs to be known but that it is apart; metres.
inline double SeparationLimit(const ContactRange& range, const PairMotion& motion) {
  return std::max(range.touching, std::min(motion.MaxApproach(), range.limit));
}

/// Overlap that does not count when bodies pass each other: metres, for a manifold with this breaking threshold.
constexpr double FlushOverlap(double breaking_threshold) { return 1e-3 * breaking_threshold; }

/// Whether contacts may be kept from step to step, so that they come from other poses than this step's.
bool MayKeepContacts(const Options& options, const PairManifold& manifold);

/// @param is_asked  By an app, for the contacts themselves.
dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           const ContactRange& range, const PairMotion& motion, bool is_asked,
                                           const btManifoldResult& output);

/// Makes the manifold's points those of the patch, through the output.
/// @param normal  Unit, from A to B, of which A is the manifold's first body, or the call's where it is shared.
/// @param motion  Of A and B.
void WriteContacts(const dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion,
                   const Options& options, const PairManifold& manifold, btManifoldResult& output);

}  // namespace dgd_bullet
