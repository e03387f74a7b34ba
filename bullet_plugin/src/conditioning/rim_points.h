// A contact ahead on the rim of what wobbles: Options::rim_damping, off by default.
//
// A cylinder that wobbles on a flat side, as a spun coin does, touches its support at another point of the rim in each
// step, centimetres on; a prism of many sides alike. If only the lowest point of now is a contact, the rim sinks in
// there, is pushed out at a speed, and gains energy by that: it wobbles for ever. So of a face with more corners than a
// patch may have, the corner that will be the deepest at the end of the step joins the patch if it will overlap, and
// replaces the last point if need be.
//
// Physics: this takes energy that theory keeps, the more the longer the step. A disc 0.8 m across, spun as steadily as
// one can at a tilt of 0.6 rad, should spin on; it lies after 2.2 s in steps of 1/240 s, after 0.7 s in steps of 1/60
// s.
#pragma once

#include "dgd/contact/facing_faces.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/pair_motion.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Adds the rim's coming contact to the patch of two shapes, if there is one.
/// @param facing  The faces along the contact's normal, with their overlap.
void AddRimPoint(const PosedShape& shape_a, const PosedShape& shape_b, const Contact& contact,
                 const dgd::FacingFaces<double>& facing, const dgd::PatchSettings<double>& settings,
                 const PairMotion& motion, dgd::ContactPatch<double>& patch);

/// Adds it to the patch of a shape on a plane.
void AddRimPointOnPlane(const PosedShape& shape, const Contact& contact, const dgd::FacingFaces<double>& facing,
                        const dgd::PatchSettings<double>& settings, const PairMotion& motion,
                        dgd::ContactPatch<double>& patch);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
