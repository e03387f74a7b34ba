// A cylinder about the z axis, centred.
#pragma once

#include <algorithm>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/disc.h"

namespace dgd {

template <class S>
class Cylinder {
 public:
  using Scalar = S;

  /// @param radius       Metres, >= 0.
  /// @param half_height  Metres, >= 0. A zero makes a disc, a segment or a point.
  Cylinder(S radius, S half_height)
      : radius_(RequireLength(radius, true, "cylinder radius")),
        half_height_(RequireLength(half_height, true, "cylinder half height")) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    return {DiscSupport(direction, radius_, std::copysign(half_height_, direction.z())),
            FeatureId(std::signbit(direction.z()))};
  }
  /// Piece 0 is the top cap's rim, piece 1 the bottom cap's.
  CurvedPoint<S> PieceSupport(FeatureId piece, const Vector3<S>& direction) const {
    return RimSupport(direction, radius_, piece == 0 ? half_height_ : -half_height_);
  }
  FeatureId PieceCount() const { return 2; }
  /// See FacedCore: both rims bound caps.
  FlatDisc<S> Face(FeatureId piece) const {
    const S side = piece == 0 ? S(1) : S(-1);
    return {{0, 0, side}, {0, 0, side * half_height_}, radius_};
  }
  const Vector3<S>& Center() const { return center_; }
  S Inradius() const { return std::min(radius_, half_height_); }
  /// See SpreadCore.
  auto Spread() const { return SpreadOfExtents<S, 3>({radius_, radius_, half_height_}); }
  /// See CenteredCore.
  void MoveCenterNear(const Vector3<S>& point) {
    const S reach_z = half_height_ - Inradius(), reach = radius_ - Inradius();
    const S lateral = std::hypot(point.x(), point.y());
    const S scale = lateral > reach ? reach / lateral : S(1);
    center_ = {scale * point.x(), scale * point.y(), std::clamp(point.z(), -reach_z, reach_z)};
  }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    return radius_ * std::hypot(direction.x(), direction.y()) + half_height_ * std::abs(direction.z());
  }

  /// Distance of `point` to the core, metres; 0 inside.
  S Distance(const Vector3<S>& point) const {
    const S outside_side = std::max(std::hypot(point.x(), point.y()) - radius_, S(0));
    const S outside_cap = std::max(std::abs(point.z()) - half_height_, S(0));
    return std::hypot(outside_side, outside_cap);
  }

  /// The cap or the line on the side that is nearer to facing `direction`; the support point first.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
    if (std::abs(direction.z()) >= std::hypot(direction.x(), direction.y())) {
      AddDisc(direction, radius_, std::copysign(half_height_, direction.z()), face);
    } else {
      const S near_end = std::copysign(half_height_, direction.z());
      face.Add(DiscSupport(direction, radius_, near_end));
      face.Add(DiscSupport(direction, radius_, -near_end));
      face.radius = radius_;
    }
  }

 private:
  S radius_;
  S half_height_;
  Vector3<S> center_ = Vector3<S>::Zero();
};

}  // namespace dgd
