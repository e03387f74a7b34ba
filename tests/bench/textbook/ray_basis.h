// The inner approximation as the paper has it: as many points of C as there are dimensions, whose cone holds the ray.
#pragma once

#include <Eigen/LU>
#include <limits>

#include "bench/textbook/ray_facet.h"

namespace dgd_bench {

/// The ray goes from 0 along p.
template <int L>
class RayBasis {
 public:
  using Vector = dgd::Vector<double, L>;

  /// @param facet  That the ray meets.
  RayBasis(const Vector& p, const RayFacet<L>& facet) : p_(p), facet_(facet) { Solve(); }

  /// One step of the simplex method: the point comes in, the first that the ratio test names goes out. With all but the
  /// basis pruned, a second step finds nothing to do.
  void Insert(const RayPoint<L>& point) {
    // Its cost is 1: it enters where the basis would pay more for it.
    const Vector of_point = inverse_ * point.of_c;
    if (of_point.sum() <= 1) return;
    int outgoing = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < L; ++i) {
      if (of_point[i] > 0 && weights_[i] / of_point[i] < least) {
        least = weights_[i] / of_point[i];
        outgoing = i;
      }
    }
    if (outgoing < 0) return;
    facet_.SetCorner(outgoing, point);
    Solve();
  }

  /// Of the ray's length in C over |p|.
  double Lower() const { return lower_; }
  /// Eq. (normal-vector), of any length.
  Vector Normal() const { return inverse_.transpose() * Vector::Ones(); }

  const RayFacet<L>& Facet() const { return facet_; }
  /// Conic, of p in the facet's corners.
  const Vector& Weights() const { return weights_; }

 private:
  void Solve() {
    inverse_ = facet_.of_c.inverse();
    weights_ = inverse_ * p_;
    lower_ = 1 / weights_.sum();
  }

  Vector p_;
  RayFacet<L> facet_;
  dgd::SquareMatrix<double, L> inverse_;  // Of the facet's points of C.
  Vector weights_;
  double lower_ = 0;
};

}  // namespace dgd_bench
