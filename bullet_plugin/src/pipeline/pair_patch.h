// The contact patch of a solved pair.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/facing_faces.h"
#include "dgd/query_types.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/pair_motion.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What the shapes show each other along the result's normal.
void FindFacingFaces(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                     double angular_tolerance, dgd::FacingFaces<double>& facing);

/// The points that belong to the patch by `settings`, and those that `motion` makes touch.
dgd::ContactPatch<double> FindPatch(const dgd::Result<double>& result, const dgd::FacingFaces<double>& facing,
                                    const dgd::PatchSettings<double>& settings, const PairMotion& motion);

/// A cylinder that wobbles on a face, as a spun coin does, touches it at another point of its rim in each step,
/// centimetres on; a prism of many sides alike. Where only the lowest one of now is held, the rim sinks in there, is
/// pushed out at a speed, and gains by that: it wobbles for ever. So of a face with more corners than may be kept the
/// one that will be the deepest at the end of the step joins the patch, if it will be in overlap, in the place of the
/// last point if need be. By that the wobble loses energy, the faster the longer the step: a disc 0.8 m across, spun
/// as steadily as one can at a tilt of 0.6 rad, lies after 2.2 s in steps of 1/240 s, after 0.7 s in steps of 1/60 s.
/// @param facing  Along the result's normal, with its overlap.
void AddRimPoint(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Result<double>& result,
                 const dgd::FacingFaces<double>& facing, const dgd::PatchSettings<double>& settings,
                 const PairMotion& motion, dgd::ContactPatch<double>& patch);

/// As above, of a shape on a plane.
void AddRimPoint(const PosedShape& shape, const dgd::Result<double>& result, const dgd::FacingFaces<double>& facing,
                 const dgd::PatchSettings<double>& settings, const PairMotion& motion,
                 dgd::ContactPatch<double>& patch);

/// The witness point alone: what Bullet's own algorithm would report.
dgd::ContactPatch<double> WitnessOnly(const dgd::Result<double>& result);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
