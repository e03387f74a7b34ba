// The contact patch of a solved pair.
#pragma once

#include "dgd/contact/facing_faces.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct PairQuery;

/// The contacts of a solved pair, before they are written anywhere.
struct PairContacts {
  dgd::ContactPatch<double> patch;
  Vector3 normal = Vector3::Zero();  ///< Unit, from the call's first body to the second.
  PairMotion motion;                 ///< Motion of the bodies in the order that their shapes are solved in.
  bool is_passing = false;           ///< Whether the patch's separations are not the shapes' (LetPass()).
};

/// The patch of two shapes: none where they are too far apart, and will be at the end of the step.
/// @param contact     Certified. Its normal turns to that of least translation where there is a patch and that is
///                    wanted.
/// @param is_passing  Out: whether the patch is that of bodies that pass each other (LetPass()).
dgd::ContactPatch<double> FindContactPatch(PairQuery& query, Contact& contact, bool& is_passing);

/// The points that belong to the patch by `settings`, and those that `motion` closes.
dgd::ContactPatch<double> FindPatch(const Contact& contact, const dgd::FacingFaces<double>& facing,
                                    const dgd::PatchSettings<double>& settings, const PairMotion& motion);

/// The witness point alone: what Bullet's own algorithm would report.
dgd::ContactPatch<double> WitnessOnly(const Contact& contact);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
