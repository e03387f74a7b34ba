// A cone about the z axis: apex up, base down, the frame's origin half way between them.
#pragma once

#include "dgd/shapes/frustum.h"

namespace dgd {

/// A frustum without a top.
template <class S>
class Cone : public Frustum<S> {
 public:
  /// @param radius  Of the base disc at z = -height / 2; metres, >= 0.
  /// @param height  Base to apex (0, 0, height / 2); metres, >= 0. A zero makes a disc, a segment or a point.
  Cone(S radius, S height)
      : Frustum<S>(RequireLength(radius, true, "cone radius"), 0, RequireLength(height, true, "cone height")) {}
};

}  // namespace dgd
