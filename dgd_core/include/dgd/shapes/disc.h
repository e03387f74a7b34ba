// Discs orthogonal to the z axis: the caps of cylinders and the base of cones.
#pragma once

#include <cmath>
#include <limits>

#include "dgd/contact/supporting_face.h"
#include "dgd/types.h"

namespace dgd {

/// Directions with a smaller part in the disc's plane are orthogonal to it. Their squares keep all digits.
/// Test: Cylinder.Support_StaysOnDiscWhereSquaresUnderflow.
template <class S>
inline constexpr S kSmallestLateral = sizeof(S) == 8 ? S(1e-145) : S(1e-15);

/// The point of the disc of `radius` about (0, 0, z) farthest along `direction`; its centre's +x side if the direction
/// has no part in the disc's plane.
template <class S>
Vector3<S> DiscSupport(const Vector3<S>& direction, S radius, S z) {
  const S lateral = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
  // False for NaN, and where squaring underflows and loses digits: any rim point is as high as another then.
  if (!(lateral > kSmallestLateral<S>)) return {radius, 0, z};
  const S scale = radius / lateral;
  return {direction.x() * scale, direction.y() * scale, z};
}

/// DiscSupport() as a smooth piece. A disc of radius 0 is a point, which does not move with the direction; along the
/// axis the rim has no derivative: it is NaN there.
template <class S>
CurvedPoint<S> RimSupport(const Vector3<S>& direction, S radius, S z) {
  CurvedPoint<S> rim{{radius, 0, z}, Matrix3<S>::Zero()};
  if (radius == 0) return rim;
  const S lateral = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
  if (!(lateral > kSmallestLateral<S>)) {
    rim.derivative.template topLeftCorner<2, 2>().setConstant(std::numeric_limits<S>::quiet_NaN());
    return rim;
  }
  const S scale = radius / lateral;
  rim.point.x() = direction.x() * scale;
  rim.point.y() = direction.y() * scale;
  // radius / lateral * (I - n n^T), whose diagonal is the other coordinate's square.
  const S x = direction.x() / lateral, y = direction.y() / lateral;
  rim.derivative.template topLeftCorner<2, 2>() << scale * y * y, -scale * x * y, -scale * x * y, scale * x * x;
  return rim;
}

/// Points of the inscribed polygon that stands for a disc in a contact patch.
inline constexpr int kDiscPoints = 8;

/// Adds the disc's inscribed polygon: one of its corners is the support point along `direction`, unless that is all but
/// the disc's axis. Whoever stands on the disc must not have its points turned around by the last digits of its tilt.
template <class S>
void AddDisc(const Vector3<S>& direction, S radius, S z, SupportingFace<S>& face) {
  static_assert(kDiscPoints <= SupportingFace<S>::kMaxPoints);
  static const S kCosine = std::cos(S(2 * EIGEN_PI / kDiscPoints));
  static const S kSine = std::sin(S(2 * EIGEN_PI / kDiscPoints));
  // The rim is then less than 1e-4 of the radius lower than the polygon.
  constexpr S kUprightTangent = S(1e-3);
  const bool upright = std::hypot(direction.x(), direction.y()) < kUprightTangent * std::abs(direction.z());
  Vector3<S> corner = upright ? Vector3<S>(radius, 0, z) : DiscSupport(direction, radius, z);
  for (int i = 0; i < kDiscPoints; ++i) {
    face.Add(corner);
    corner = Vector3<S>(kCosine * corner.x() - kSine * corner.y(), kSine * corner.x() + kCosine * corner.y(), z);
  }
}

}  // namespace dgd
