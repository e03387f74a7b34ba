// Cores as a user may bring them: a support function, a centre and an inradius, and no features. The solver then has no
// warm start from a basis, and no second-order steps.
#pragma once

#include <cmath>
#include <utility>

#include "dgd/convex_set.h"
#include "dgd/shapes/box.h"
#include "support/sets/support_distance.h"

namespace dgd_test {

/// A box whose corners have no names.
template <class S>
class PlainBox {
 public:
  using Scalar = S;

  explicit PlainBox(const dgd::Vector3<S>& half_extents) : box_(half_extents) {}

  dgd::SupportPoint<S> Support(const dgd::Vector3<S>& direction) const { return {box_.Support(direction).point}; }
  dgd::Vector3<S> Center() const { return box_.Center(); }
  S Inradius() const { return box_.Inradius(); }
  S SupportValue(const dgd::Vector3<S>& direction) const { return box_.SupportValue(direction); }
  S Distance(const dgd::Vector3<S>& point) const { return box_.Distance(point); }

 private:
  dgd::Box<S> box_;
};

/// All x with sum |x_i / a_i|^p <= 1; in the plane, a superellipse. Its support function is the dual norm of A d, whose
/// exponent is q = p / (p - 1); in double whatever S is.
template <class S, int L>
class Superellipsoid {
 public:
  using Scalar = S;

  /// @param semi_axes  a, metres, each > 0.
  /// @param exponent   p >= 2: an ellipsoid, and towards a box the larger it is.
  Superellipsoid(const dgd::Vector<S, L>& semi_axes, double exponent)
      : semi_axes_(semi_axes.template cast<double>()), dual_exponent_(exponent / (exponent - 1)) {}

  dgd::SupportPoint<S, L> Support(const dgd::Vector<S, L>& direction) const {
    return {InDouble{*this}.Support(direction.template cast<double>()).point.template cast<S>()};
  }
  dgd::Vector<S, L> Center() const { return dgd::Vector<S, L>::Zero(); }
  /// It holds the ellipsoid of the same semi-axes.
  S Inradius() const { return static_cast<S>(semi_axes_.minCoeff()); }

  S SupportValue(const dgd::Vector<S, L>& direction) const {
    const Point stretched = semi_axes_.cwiseProduct(direction.template cast<double>());
    const double largest = stretched.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return 0;
    const double sum = (stretched / largest).cwiseAbs().array().pow(dual_exponent_).sum();
    return static_cast<S>(largest * std::pow(sum, 1 / dual_exponent_));
  }
  S Distance(const dgd::Vector<S, L>& point) const {
    const InDouble core{*this};
    return static_cast<S>(SupportDistance<L, InDouble>(core, point.template cast<double>()).Find());
  }

 private:
  using Point = dgd::Vector<double, L>;

  /// The same set for directions in double.
  struct InDouble {
    using Scalar = double;
    const Superellipsoid& set;

    dgd::SupportPoint<double, L> Support(const Point& direction) const {
      const Point stretched = set.semi_axes_.cwiseProduct(direction);
      const double largest = stretched.cwiseAbs().maxCoeff();
      if (!(largest > 0)) return {Point(Point::Zero())};
      const Point parts = (stretched / largest).cwiseAbs();
      const double sum = parts.array().pow(set.dual_exponent_).sum();
      const double scale = std::pow(sum, 1 / set.dual_exponent_ - 1);
      Point point;
      for (int axis = 0; axis < L; ++axis) {
        const double part = std::pow(parts[axis], set.dual_exponent_ - 1);
        point[axis] = std::copysign(scale * part * set.semi_axes_[axis], direction[axis]);
      }
      return {point};
    }
    Point Center() const { return Point::Zero(); }
    double Inradius() const { return set.semi_axes_.minCoeff(); }
  };

  Point semi_axes_;
  double dual_exponent_;
};

}  // namespace dgd_test
