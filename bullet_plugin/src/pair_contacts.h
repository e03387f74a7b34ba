// What a step asks of a pair's contacts, and how they are handed over: the same whatever has found them.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd_bullet/options.h"
#include "pair_manifold.h"
#include "solver_types.h"

class btCollisionObject;
class btManifoldResult;

namespace dgd_bullet {

/// Whether contacts may meet the bodies' motion before they touch.
bool MeetsEarly(const PairManifold& manifold, const btCollisionObject& object_0, const btCollisionObject& object_1);

/// Whether contacts may be kept from step to step, so that they come from other poses than this step's.
bool MayKeepContacts(const Options& options, const PairManifold& manifold);

/// @param contact_distance  Not farther apart, there are contacts; metres.
/// @param is_asked          By an app, for the contacts themselves.
dgd::PatchSettings<double> PatchSettingsOf(const Options& options, const PairManifold& manifold,
                                           double contact_distance, bool is_asked);

/// Makes the manifold's points those of the patch, through the output.
/// @param normal  Unit, from A to B, of which A is the manifold's first body, or the call's where it is shared.
void WriteContacts(const dgd::ContactPatch<double>& patch, const Vector3& normal, const Options& options,
                   const PairManifold& manifold, btManifoldResult& output);

}  // namespace dgd_bullet
