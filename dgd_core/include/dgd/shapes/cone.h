// A cone about the z axis: apex up, base down, the frame's origin half way between them.
#pragma once

#include <algorithm>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/disc.h"

namespace dgd {

template <class S>
class Cone {
 public:
  using Scalar = S;

  /// @param radius  Of the base disc at z = -height / 2; metres, >= 0.
  /// @param height  Base to apex (0, 0, height / 2); metres, >= 0. A zero makes a disc, a segment or a point.
  Cone(S radius, S height)
      : radius_(RequireLength(radius, true, "cone radius")),
        height_(RequireLength(height, true, "cone height")),
        inradius_(InradiusAtCenter()) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    // The apex beats the rim where height * d_z > radius * |d_xy|.
    const S lateral = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    if (height_ * direction.z() > radius_ * lateral) return {Apex(), 0};
    return {DiscSupport(direction, radius_, -height_ / 2), 1};
  }
  /// Piece 0 is the apex, piece 1 the base's rim.
  CurvedPoint<S> PieceSupport(FeatureId piece, const Vector3<S>& direction) const {
    if (piece == 0) return {Apex(), Matrix3<S>::Zero()};
    return RimSupport(direction, radius_, -height_ / 2);
  }
  FeatureId PieceCount() const { return 2; }
  /// See FacedCore: the rim bounds the base.
  FlatDisc<S> Face(FeatureId piece) const {
    return piece == 0 ? FlatDisc<S>() : FlatDisc<S>{{0, 0, -1}, {0, 0, -height_ / 2}, radius_};
  }

  /// The centroid, a quarter of the height above the base.
  Vector3<S> Center() const { return {0, 0, -height_ / 4}; }
  S Inradius() const { return inradius_; }
  /// See SpreadCore.
  auto Spread() const { return SpreadOfExtents<S, 3>({radius_, radius_, height_ / 2}); }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    const S at_apex = height_ / 2 * direction.z();
    return std::max(at_apex, radius_ * std::hypot(direction.x(), direction.y()) - at_apex);
  }

  /// Distance of `point` to the core, metres; 0 inside. In the half plane through the axis the cone is a triangle.
  S Distance(const Vector3<S>& point) const {
    const S lateral = std::hypot(point.x(), point.y());
    const S above_base = point.z() + height_ / 2;
    const S slant_sq = radius_ * radius_ + height_ * height_;
    // Distance to the side, the segment from the rim (radius, 0) to the apex (0, height).
    const S along =
        slant_sq > 0 ? std::clamp(((radius_ - lateral) * radius_ + above_base * height_) / slant_sq, S(0), S(1)) : S(0);
    const S to_side = std::hypot(lateral - radius_ * (1 - along), above_base - height_ * along);
    const bool below_side = height_ * lateral + radius_ * above_base <= height_ * radius_;
    // The last two decide for discs and segments, whose side is no plane.
    if (below_side && above_base >= 0 && above_base <= height_ && lateral <= radius_) return 0;
    const S to_base = std::hypot(std::max(lateral - radius_, S(0)), above_base);
    return std::min(to_side, to_base);
  }

  /// The base, or the line on the side, that is nearer to facing `direction`.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
    const S lateral = std::hypot(direction.x(), direction.y());
    const S slant = std::hypot(radius_, height_);
    const S facing_side = slant > 0 ? (height_ * lateral + radius_ * direction.z()) / slant : S(0);
    if (-direction.z() >= facing_side) {
      AddDisc(direction, radius_, -height_ / 2, face);
    } else {
      face.Add(Apex());
      face.Add(DiscSupport(direction, radius_, -height_ / 2));
    }
  }

 private:
  Vector3<S> Apex() const { return {0, 0, height_ / 2}; }
  S InradiusAtCenter() const {
    const S slant = std::hypot(radius_, height_);
    return slant > 0 ? std::min(height_ / 4, height_ * S(0.75) * radius_ / slant) : S(0);
  }

  S radius_;
  S height_;
  S inradius_;
};

}  // namespace dgd
