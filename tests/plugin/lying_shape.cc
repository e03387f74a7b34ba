#include "plugin/lying_shape.h"

#include <cmath>
#include <limits>

namespace dgd_test {
namespace {

using Limits = std::numeric_limits<btScalar>;

btVector3 All(btScalar value) { return {value, value, value}; }

}  // namespace

const char* NameOf(Lie lie) {
  static const char* const kNames[] = {"None",    "NaN",     "SometimesNaN", "Infinite",  "Huge",
                                       "Nearest", "Concave", "Restless",     "OutOfReach"};
  return kNames[static_cast<int>(lie)];
}

LyingShape::LyingShape(Lie lie, double size)
    : Ellipsoid(btScalar(size) * btVector3(1, btScalar(0.8), btScalar(0.6))), lie_(lie), size_(btScalar(size)) {}

btVector3 LyingShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  const btVector3 truth = Ellipsoid::localGetSupportingVertexWithoutMargin(direction);
  switch (lie_) {
    case Lie::kNone:
      return truth;
    case Lie::kNaN:
      return All(Limits::quiet_NaN());
    case Lie::kSometimesNaN:
      return direction.x() > 0 ? All(Limits::quiet_NaN()) : truth;
    case Lie::kInfinite:
      return All(Limits::infinity());
    case Lie::kHuge:
      return All(Limits::max());
    case Lie::kNearest:
      return -truth;
    case Lie::kConcave:
      return truth * (std::abs(direction.z()) > btScalar(0.7) * direction.length() ? btScalar(0.3) : btScalar(1));
    case Lie::kRestless: {
      const int turn = calls_++ % 7;
      return truth * (btScalar(0.4) + btScalar(0.1) * btScalar(turn));
    }
    case Lie::kOutOfReach:
      return truth + 10 * size_ * btVector3(std::sin(9 * direction.y()), std::cos(7 * direction.x()), 0);
  }
  return truth;
}

void LyingShape::getAabb(const btTransform& pose, btVector3& low, btVector3& high) const {
  const btVector3 reach = All(size_ + getMargin());
  low = pose.getOrigin() - reach;
  high = pose.getOrigin() + reach;
}

}  // namespace dgd_test
