// All shapes, and those of them that are a core and a radius by nature. Only the header of a shape that is used is
// needed; this one is for convenience.
#pragma once

#include "dgd/convex_set.h"
#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/ellipsoid.h"
#include "dgd/shapes/frustum.h"
#include "dgd/shapes/half_space.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/polygon.h"
#include "dgd/shapes/polytope.h"
#include "dgd/shapes/segment.h"
#include "dgd/shapes/triangle.h"

namespace dgd {

/// Centred. @param radius  Metres, > 0. Throws std::invalid_argument otherwise, as all below.
template <class S>
RoundedSet<Point<S>> Sphere(S radius) {
  return {Point<S>(), RequireLength(radius, false, "sphere radius")};
}

/// All points within `radius` > 0 of a segment along z, from -half_length to half_length >= 0; metres.
template <class S>
RoundedSet<Segment<S>> Capsule(S radius, S half_length) {
  return {Segment<S>(RequireLength(half_length, true, "capsule half length")),
          RequireLength(radius, false, "capsule radius")};
}

/// Of the plane, centred. @param radius  Metres, > 0.
template <class S>
RoundedSet<Point<S, 2>> Circle(S radius) {
  return {Point<S, 2>(), RequireLength(radius, false, "circle radius")};
}

/// A stadium of the plane: all points within `radius` > 0 of a segment along y, from -half_length to half_length >= 0;
/// metres.
template <class S>
RoundedSet<Segment<S, 2>> Stadium(S radius, S half_length) {
  return {Segment<S, 2>(RequireLength(half_length, true, "stadium half length")),
          RequireLength(radius, false, "stadium radius")};
}

}  // namespace dgd
