// A frustum of a cone about the z axis: base down, top up, the frame's origin half way between them.
#pragma once

#include <algorithm>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/disc.h"

namespace dgd {

template <class S>
class Frustum {
 public:
  using Scalar = S;

  /// @param base_radius  Of the disc at z = -height / 2; metres, >= 0.
  /// @param top_radius   Of the disc at z = height / 2; metres, >= 0, larger or smaller than the base's.
  /// @param height       Metres, >= 0. Zeros make a cone, a disc, a segment or a point.
  Frustum(S base_radius, S top_radius, S height)
      : base_radius_(RequireLength(base_radius, true, "frustum base radius")),
        top_radius_(RequireLength(top_radius, true, "frustum top radius")),
        height_(RequireLength(height, true, "frustum height")),
        slant_(std::hypot(height, top_radius - base_radius)),
        center_z_(CentroidHeight() - height / 2),
        inradius_(InradiusAt(CentroidHeight())) {}

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    // The top's rim beats the base's where height * d_z + (top_radius - base_radius) * |d_xy| > 0.
    const S lateral = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
    if (height_ * direction.z() > (base_radius_ - top_radius_) * lateral) {
      return {DiscSupport(direction, top_radius_, height_ / 2), 1};
    }
    return {DiscSupport(direction, base_radius_, -height_ / 2), 0};
  }
  /// Piece 0 is the base's rim, piece 1 the top's.
  CurvedPoint<S> PieceSupport(FeatureId piece, const Vector3<S>& direction) const {
    if (piece == 0) return RimSupport(direction, base_radius_, -height_ / 2);
    return RimSupport(direction, top_radius_, height_ / 2);
  }
  FeatureId PieceCount() const { return 2; }
  /// See FacedCore: both rims bound discs, unless they are a point.
  FlatDisc<S> Face(FeatureId piece) const {
    const S side = piece == 0 ? S(-1) : S(1), radius = piece == 0 ? base_radius_ : top_radius_;
    if (radius == 0) return {};
    return {{0, 0, side}, {0, 0, side * (height_ / 2)}, radius};
  }

  /// The centroid.
  Vector3<S> Center() const { return {0, 0, center_z_}; }
  S Inradius() const { return inradius_; }
  /// See SpreadCore.
  auto Spread() const {
    const S radius = std::max(base_radius_, top_radius_);
    return SpreadOfExtents<S, 3>({radius, radius, height_ / 2});
  }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    const S lateral = std::hypot(direction.x(), direction.y());
    const S rise = height_ / 2 * direction.z();
    return std::max(base_radius_ * lateral - rise, top_radius_ * lateral + rise);
  }

  /// Distance of `point` to the core, metres; 0 inside. In the half plane through the axis the frustum is a trapezoid.
  S Distance(const Vector3<S>& point) const {
    const S lateral = std::hypot(point.x(), point.y());
    const S above_base = point.z() + height_ / 2;
    const S below_top = height_ / 2 - point.z();
    const S growth = top_radius_ - base_radius_;
    // The last decides for discs and segments, whose side is no plane.
    const bool within_side = height_ * (lateral - base_radius_) <= growth * above_base;
    if (within_side && above_base >= 0 && below_top >= 0 && lateral <= std::max(base_radius_, top_radius_)) return 0;

    // The side is the segment from (base_radius, 0) to (top_radius, height).
    const S slant_sq = slant_ * slant_;
    const S along = slant_sq > 0
                        ? std::clamp(((lateral - base_radius_) * growth + above_base * height_) / slant_sq, S(0), S(1))
                        : S(0);
    const S to_side = std::hypot(lateral - (base_radius_ + growth * along), above_base - height_ * along);
    const S to_base = std::hypot(std::max(lateral - base_radius_, S(0)), above_base);
    const S to_top = std::hypot(std::max(lateral - top_radius_, S(0)), below_top);
    return std::min({to_side, to_base, to_top});
  }

  /// The base or the top, or the line on the side, whichever of those with the support point faces `direction` more.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const {
    const S lateral = std::hypot(direction.x(), direction.y());
    const S facing_side =
        slant_ > 0 ? (height_ * lateral + (base_radius_ - top_radius_) * direction.z()) / slant_ : S(0);
    // The disc is the one that the support point is on: the other may face `direction` and yet lie lower.
    const bool is_top = Support(direction).feature == 1;
    const S radius = is_top ? top_radius_ : base_radius_;
    // A tip is not flat: the line from it down the side stands for it.
    if (radius > 0 && (is_top ? direction.z() : -direction.z()) >= facing_side) {
      AddDisc(direction, radius, is_top ? height_ / 2 : -height_ / 2, face);
    } else {
      face.Add(DiscSupport(direction, base_radius_, -height_ / 2));
      face.Add(DiscSupport(direction, top_radius_, height_ / 2));
    }
  }

 private:
  /// Height of the centroid above the base. Radii count as parts of the larger one, whose square may underflow.
  S CentroidHeight() const {
    const S larger = std::max(base_radius_, top_radius_);
    if (!(larger > 0)) return height_ / 2;
    const S base = base_radius_ / larger, top = top_radius_ / larger;
    return height_ / 4 * (base * base + 2 * base * top + 3 * top * top) / (base * base + base * top + top * top);
  }

  /// Distance of the axis' point at this height above the base to the nearest of base, top and side.
  S InradiusAt(S above_base) const {
    if (!(slant_ > 0 && height_ > 0)) return 0;
    const S part = above_base / height_;
    const S radius = base_radius_ * (1 - part) + top_radius_ * part;
    constexpr S kSafety = 1 - 16 * std::numeric_limits<S>::epsilon();
    return kSafety * std::min({above_base, height_ - above_base, radius * (height_ / slant_)});
  }

  S base_radius_;
  S top_radius_;
  S height_;
  S slant_;
  S center_z_;
  S inradius_;
};

}  // namespace dgd
