// The differentiable support function over a point set: a polytope with rounded vertices, edges and facets.
//
// Lee et al. 2023, "Uncertain Pose Estimation during Contact Tasks using Differentiable Contact Features". About an
// inner point c, the polytope's support function is the largest of the heights <d, v_j - c>; the p-norm of the positive
// ones stands for it here. It is twice differentiable for p > 2, and the set contains the polytope, since the p-norm is
// at least the largest height.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/shapes/hull_queries.h"
#include "dgd/shapes/support_distance.h"
#include "dgd/supporting_face.h"

namespace dgd {

/// Makes the hull once, when it is made; immutable after. Computes in double whatever S is.
template <class S>
class Dsf {
 public:
  using Scalar = S;

  /// @param points    Metres; all finite, in any order, not in one plane; inner and duplicate points are dropped.
  /// @param exponent  p > 2, finite. The set is within a factor of n^(1/p) of the polytope of n vertices.
  /// Throws std::invalid_argument otherwise.
  Dsf(std::span<const Eigen::Vector3d> points, double exponent) : Dsf(BuildConvexHull(points), exponent) {}
  Dsf(const ConvexHull& hull, double exponent)
      : exponent_(exponent),
        origin_(hull.center),
        inradius_(InradiusOfRounded<S>(hull)),
        spread_(SpreadOfVertices(hull).template cast<S>()) {
    if (!(std::isfinite(exponent) && exponent > 2)) {
      throw std::invalid_argument("dsf exponent must be finite and > 2; got " + std::to_string(exponent));
    }
    if (hull.dimension < 3 || !(hull.inradius > 0)) {
      throw std::invalid_argument(
          "dsf points must not be in one plane: its support function is about an inner point;"
          " their hull has dimension " +
          std::to_string(hull.dimension));
    }
    for (const Eigen::Vector3d& vertex : hull.vertices) offsets_.push_back(vertex - origin_);
  }

  SupportPoint<S> Support(const Vector3<S>& direction) const {
    return {InDouble{*this}.Support(direction.template cast<double>()).point.template cast<S>(), 0};
  }
  /// The one piece is all of it. No derivative, NaN, for direction 0.
  CurvedPoint<S> PieceSupport(FeatureId piece, const Vector3<S>& direction) const {
    const CurvedPoint<double> curved = InDouble{*this}.PieceSupport(piece, direction.template cast<double>());
    return {curved.point.template cast<S>(), curved.derivative.template cast<S>()};
  }
  FeatureId PieceCount() const { return 1; }

  /// The polytope's centroid.
  Vector3<S> Center() const { return origin_.template cast<S>(); }
  S Inradius() const { return inradius_; }
  /// See SpreadCore.
  const Matrix3<S>& Spread() const { return spread_; }

  /// Largest <direction, x> over the core.
  S SupportValue(const Vector3<S>& direction) const {
    const Eigen::Vector3d d = direction.template cast<double>();
    double highest = 0;
    for (const Eigen::Vector3d& offset : offsets_) highest = std::max(highest, d.dot(offset));
    if (!(highest > 0)) return static_cast<S>(d.dot(origin_));
    double sum = 0;
    for (const Eigen::Vector3d& offset : offsets_) {
      sum += std::pow(std::max(d.dot(offset), 0.0) / highest, exponent_);
    }
    return static_cast<S>(highest * std::pow(sum, 1 / exponent_) + d.dot(origin_));
  }

  /// Distance of `point` to the core, metres; 0 inside. By iteration; never too large but for rounding.
  S Distance(const Vector3<S>& point) const {
    const InDouble core{*this};
    return static_cast<S>(SupportDistance<3, InDouble>(core, point.template cast<double>()).Find());
  }

  /// The support point: no face is flat.
  void SupportFace(const Vector3<S>& direction, SupportingFace<S>& face) const { face.Add(Support(direction).point); }

 private:
  /// The same set for directions in double.
  struct InDouble {
    using Scalar = double;

    const Dsf& dsf;

    SupportPoint<double> Support(const Eigen::Vector3d& direction) const {
      return {dsf.template Curve<false>(direction).point, 0};
    }
    CurvedPoint<double> PieceSupport(FeatureId, const Eigen::Vector3d& direction) const {
      return dsf.template Curve<true>(direction);
    }
    FeatureId PieceCount() const { return 1; }
    const Eigen::Vector3d& Center() const { return dsf.origin_; }
    double Inradius() const { return static_cast<double>(dsf.inradius_); }
  };

  /// Gradient of the p-norm of the heights and, if asked for, its Hessian. With r_j the heights as parts of the largest
  /// one, m, so that no power overflows, and q = sum r_j^p, the support value is s = m q^(1/p) and the gradient
  /// g = q^(1/p - 1) sum r_j^(p-1) w_j. The Hessian is (p - 1) / (q s) sum r_j^(p-2) z_j z_j^T with
  /// z_j = q^(1/p) w_j - r_j g: a sum of squares, so semidefinite also when rounded.
  template <bool kWithDerivative>
  CurvedPoint<double> Curve(const Eigen::Vector3d& direction) const {
    CurvedPoint<double> curved{origin_, Matrix3<double>::Constant(std::numeric_limits<double>::quiet_NaN())};
    const double length = direction.cwiseAbs().maxCoeff();
    if (!(length > 0)) return curved;
    const Eigen::Vector3d d = direction / length;
    double highest = 0;
    for (const Eigen::Vector3d& offset : offsets_) highest = std::max(highest, d.dot(offset));
    if (!(highest > 0)) return curved;

    double sum = 0;
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    [[maybe_unused]] std::array<double, kMostKeptPowers> powers;
    for (std::size_t j = 0; j < offsets_.size(); ++j) {
      const double part = d.dot(offsets_[j]) / highest;
      if (!(part > 0)) continue;
      const double power = std::pow(part, exponent_ - 2);
      if constexpr (kWithDerivative) {
        if (j < kMostKeptPowers) powers[j] = power;
      }
      sum += power * part * part;
      weighted += power * part * offsets_[j];
    }
    const double root = std::pow(sum, 1 / exponent_);
    const Eigen::Vector3d gradient = root / sum * weighted;
    curved.point = origin_ + gradient;
    if constexpr (!kWithDerivative) return curved;

    curved.derivative.setZero();
    for (std::size_t j = 0; j < offsets_.size(); ++j) {
      const double part = d.dot(offsets_[j]) / highest;
      if (!(part > 0)) continue;
      const double power = j < kMostKeptPowers ? powers[j] : std::pow(part, exponent_ - 2);
      const Eigen::Vector3d z = root * offsets_[j] - part * gradient;
      curved.derivative += power * (z * z.transpose());
    }
    curved.derivative *= (exponent_ - 1) / (sum * highest * root) / length;
    return curved;
  }

  /// Powers, most of the cost, are not computed twice: they stay on the stack, of twice as many points as the paper's
  /// sets have (4 to 30). Those of further points are.
  static constexpr std::size_t kMostKeptPowers = 64;

  double exponent_;
  Eigen::Vector3d origin_;
  S inradius_;
  Matrix3<S> spread_;
  std::vector<Eigen::Vector3d> offsets_;
};

}  // namespace dgd
