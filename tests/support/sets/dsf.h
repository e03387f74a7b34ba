// The differentiable support function over a point set: a polytope with rounded vertices, edges and facets.
//
// Lee et al. 2023, "Uncertain Pose Estimation during Contact Tasks using Differentiable Contact Features". About an
// inner point c, the polytope's support function is the largest of the heights <d, v_j - c>; the p-norm of the positive
// ones stands for it here. It is twice differentiable for p > 2, and the set contains the polytope, since the p-norm is
// at least the largest height.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dgd/contact/supporting_face.h"
#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/hull_queries.h"

namespace dgd_test {

namespace dsf_internal {
struct Sums;
}  // namespace dsf_internal

/// The queries of Dsf, computed in double regardless of its scalar.
/// Frame, units and errors are Dsf's.
class DsfInDouble {
 public:
  using Scalar = double;

  DsfInDouble(const dgd::ConvexHull& hull, double exponent);

  dgd::SupportPoint<double> Support(const Eigen::Vector3d& direction) const;
  dgd::CurvedPoint<double> PieceSupport(dgd::FeatureId, const Eigen::Vector3d& direction) const;
  dgd::FeatureId PieceCount() const { return 1; }
  const Eigen::Vector3d& Center() const { return origin_; }
  double Inradius() const { return inradius_; }
  double SupportValue(const Eigen::Vector3d& direction) const;
  double Distance(const Eigen::Vector3d& point) const;

 private:
  dgd::CurvedPoint<double> Curve(const Eigen::Vector3d& direction, bool with_derivative) const;
  /// @param direction  Of which the largest coordinate is 1.
  dsf_internal::Sums SumsAlong(const Eigen::Vector3d& direction, bool with_spread) const;

  double exponent_;
  std::uint32_t whole_power_;  // p - 2 if that is a whole number, else 0.
  double least_part_;          // Heights below this part of the highest one are left out of sums.
  Eigen::Vector3d origin_;
  double inradius_;
  std::vector<double> offsets_;  // Offsets of the vertices from the origin, in blocks.
};

/// Makes the hull once, when it is made; immutable after. Computes in double whatever S is.
template <class S>
class Dsf {
 public:
  using Scalar = S;

  /// @param points    Metres; all finite, in any order, not in one plane; inner and duplicate points are dropped.
  /// @param exponent  p > 2, finite. The set is within a factor of n^(1/p) of the polytope of n vertices.
  /// Throws std::invalid_argument otherwise.
  Dsf(std::span<const Eigen::Vector3d> points, double exponent) : Dsf(dgd::BuildConvexHull(points), exponent) {}
  Dsf(const dgd::ConvexHull& hull, double exponent)
      : in_double_(hull, exponent),
        inradius_(dgd::InradiusOfRounded<S>(hull)),
        spread_(dgd::SpreadOfVertices(hull).template cast<S>()) {}

  dgd::SupportPoint<S> Support(const dgd::Vector3<S>& direction) const {
    return {in_double_.Support(direction.template cast<double>()).point.template cast<S>(), 0};
  }
  /// The one piece is all of it. No derivative, NaN, for direction 0.
  dgd::CurvedPoint<S> PieceSupport(dgd::FeatureId piece, const dgd::Vector3<S>& direction) const {
    const dgd::CurvedPoint<double> curved = in_double_.PieceSupport(piece, direction.template cast<double>());
    return {curved.point.template cast<S>(), curved.derivative.template cast<S>()};
  }
  dgd::FeatureId PieceCount() const { return in_double_.PieceCount(); }

  /// The polytope's centroid.
  dgd::Vector3<S> Center() const { return in_double_.Center().template cast<S>(); }
  S Inradius() const { return inradius_; }
  /// See SpreadCore.
  const dgd::Matrix3<S>& Spread() const { return spread_; }

  /// Largest <direction, x> over the core.
  S SupportValue(const dgd::Vector3<S>& direction) const {
    return static_cast<S>(in_double_.SupportValue(direction.template cast<double>()));
  }
  /// Distance of `point` to the core, metres; 0 inside. By iteration; never too large but for roundoff.
  S Distance(const dgd::Vector3<S>& point) const {
    return static_cast<S>(in_double_.Distance(point.template cast<double>()));
  }

  /// The support point: no face is flat.
  void SupportFace(const dgd::Vector3<S>& direction, dgd::SupportingFace<S>& face) const {
    face.Add(Support(direction).point);
  }

 private:
  DsfInDouble in_double_;
  S inradius_;
  dgd::Matrix3<S> spread_;
};

}  // namespace dgd_test
