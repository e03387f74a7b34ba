// From the growth distance's normal to that of the signed distance. Free of Bullet, as posed_shape.h.
#pragma once

#include "dgd/any_set.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {

/// Turns the normal of a solved pair to where the bodies overlap least, or are farthest apart, and the separation and
/// the witness points with it; leaves all as it is if that gains nothing.
/// @param settings, warm_start  As dgd::GrowthDistance() had and left them; the latter is left for FollowDistance() if
/// that can
///                              go on from here.
/// @return whether it can.
bool TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            dgd::WarmStart<double>& warm_start, dgd::Result<double>& result);

/// In the place of dgd::GrowthDistance() and TurnToLeastTranslation(), at less than half their cost, for a pair that
/// the last call of either function here said it of, and for one that was apart or is new. The growth distance stays
/// unknown.
/// @return false, with nothing changed, if the pair's cores are not apart, or it is to be solved first: polytopes that
///         are new, shapes that only Bullet can evaluate.
bool FollowDistance(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                    dgd::WarmStart<double>& warm_start, dgd::Result<double>& result);

/// The same for a pair whose last contact was on a face of one of the shapes, and which most often lies there still:
/// the contact's patch alone is proof of it (dgd::FollowFace()); and for any two boxes (dgd::FollowBoxes()).
/// @param holder  In and out: of that face, if any.
/// @param facing  Out: what the shapes show each other along the normal, if the result is optimal and a face is across
///                it; else without an overlap.
/// @return false, with nothing but `facing` changed, if that does not tell.
bool FollowContact(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                   double angular_tolerance, dgd::FaceHolder& holder, dgd::WarmStart<double>& warm_start,
                   dgd::FacingFaces<double>& facing, dgd::Result<double>& result);

}  // namespace dgd_bullet
