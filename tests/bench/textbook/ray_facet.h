// Points of C = (C1 - p1) - (C2 - p2), in the world, and the facets that they span: what all algorithms of this folder
// that ask support functions approximate C by from inside.
#pragma once

#include <cmath>
#include <numbers>

#include "dgd/solver/minkowski_difference.h"

namespace dgd_bench {

/// A point of C, and the point of set 1 about its centre that it comes from; metres.
template <int L>
struct RayPoint {
  dgd::Vector<double, L> of_c, of_1;
};

/// As many of them as span a facet, as columns.
template <int L>
struct RayFacet {
  dgd::SquareMatrix<double, L> of_c, of_1;

  void SetCorner(int i, const RayPoint<L>& point) {
    of_c.col(i) = point.of_c;
    of_1.col(i) = point.of_1;
  }
};

/// Alg. 1: a facet across the ray along p with its corners on the ball of the inradius; counterclockwise seen along -p.
template <int L>
RayFacet<L> InitialFacet(const dgd::Vector<double, L>& p, double inradius_1, double inradius_2) {
  const double inradius = inradius_1 + inradius_2;
  const dgd::SquareMatrix<double, L> frame = dgd::FrameAlong<double>(dgd::Vector<double, L>(p.normalized()));
  const double sine = std::sqrt(3.0) / 2;
  RayFacet<L> facet;
  for (int i = 0; i < L; ++i) {
    dgd::Vector<double, L> corner = dgd::Vector<double, L>::Constant(0.5);
    const double turn = 2 * std::numbers::pi * i / L;
    corner[0] = sine * std::cos(turn);
    if constexpr (L == 3) corner[1] = sine * std::sin(turn);
    facet.of_c.col(i) = inradius * (frame * corner);
    facet.of_1.col(i) = inradius_1 / inradius * facet.of_c.col(i);
  }
  return facet;
}

}  // namespace dgd_bench
