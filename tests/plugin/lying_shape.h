// A user's convex shape whose support function lies: what a narrowphase must survive, and must not hand on as NaN.
#pragma once

#include <array>

#include "plugin/shape_zoo.h"

namespace dgd_test {

enum class Lie {
  kNone,
  kNaN,           ///< Every point is NaN.
  kSometimesNaN,  ///< For half of all directions.
  kInfinite,
  kHuge,       ///< The last number before infinity.
  kNearest,    ///< The point that is nearest along the direction, not farthest.
  kConcave,    ///< Of a body with a dent: points farther in than its hull.
  kRestless,   ///< Another one each time.
  kOutOfReach  ///< Of a body that is somewhere else, depending on the direction.
};
inline constexpr std::array kLies = {Lie::kNaN,     Lie::kSometimesNaN, Lie::kInfinite, Lie::kHuge,
                                     Lie::kNearest, Lie::kConcave,      Lie::kRestless, Lie::kOutOfReach};
const char* NameOf(Lie lie);

/// An ellipsoid but for the lie. Not for several threads at once.
class LyingShape : public Ellipsoid {
 public:
  explicit LyingShape(Lie lie, double size = 0.5);

  void Tell(Lie lie) { lie_ = lie; }
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;
  /// Bounding boxes are honest: a broadphase has no remedy.
  void getAabb(const btTransform& pose, btVector3& low, btVector3& high) const override;
  const char* getName() const override { return "LyingShape"; }

 private:
  Lie lie_;
  btScalar size_;
  mutable int calls_ = 0;
};

}  // namespace dgd_test
