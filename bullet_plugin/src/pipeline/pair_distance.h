// The signed distance of two shapes: from the growth distance, or updated from the last query's. Free of Bullet, like
// posed_shape.h.
#pragma once

#include <optional>

#include "dgd/any_set.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {

/// Turns the normal of a solved pair to where the bodies overlap least, or are farthest apart, with the separation and
/// the witness points; leaves the contact as it is if that gains nothing.
/// @param settings, warm_start  Those that dgd::GrowthDistance() had. The warm start is left for UpdateDistance() if
///                              the cores are apart, or polytopes.
/// @return whether UpdateDistance() can start from it.
bool TurnToLeastTranslation(const PosedShape& shape_a, const PosedShape& shape_b, const dgd::Settings<double>& settings,
                            dgd::WarmStart<double>& warm_start, Contact& contact);

/// Replaces dgd::GrowthDistance() and TurnToLeastTranslation(), at less than half their cost, for a pair whose warm
/// start one of the functions here has left, and for a pair that was apart or is new. The growth distance stays
/// unknown.
/// @return nothing, with the warm start unchanged, if curved cores are not apart, or the pair is to be solved from
///         scratch: new polytopes, and shapes that only Bullet can evaluate.
std::optional<Contact> UpdateDistance(const PosedShape& shape_a, const PosedShape& shape_b,
                                      const dgd::Settings<double>& settings, dgd::WarmStart<double>& warm_start);

/// Replaces them for a pair whose last contact was on a face of one of the shapes, on which it most often still is: the
/// contact's patch alone proves the distance (dgd::UpdateOnReferenceFace()).
/// @param side    The shape that has that face.
/// @param facing  Out: the faces along the normal, if the contact is optimal and a face is across it; else without an
///                overlap.
/// @return nothing, with nothing but `facing` changed, if the face does not prove the distance.
std::optional<Contact> UpdateOnReferenceFace(const PosedShape& shape_a, const PosedShape& shape_b,
                                             const dgd::Settings<double>& settings, double angular_tolerance,
                                             dgd::ReferenceSide side, dgd::WarmStart<double>& warm_start,
                                             dgd::FacingFaces<double>& facing);

}  // namespace dgd_bullet
