// The distance of a point to a set that is known by its support points only: for the shapes without a formula, and for
// certificates, so it is plain rather than fast.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "dgd/convex_set.h"
#include "dgd/invert.h"
#include "dgd/shapes/triangle.h"
#include "dgd/types.h"

namespace dgd_test {

/// Any direction u of length 1 bounds the distance from below by <u, x> minus the support value. This raises the bound:
/// by the support points' tetrahedra, as in Gilbert, Johnson and Keerthi 1988, then, where the set is smooth, by Newton
/// steps of the direction on the sphere.
template <int L, dgd::ConvexCore Core>
class SupportDistance {
 public:
  /// Both outlive this; x in the core's frame, metres.
  SupportDistance(const Core& core, const dgd::Vector<double, L>& x) : core_(core), x_(x) {}

  /// Metres; 0 inside. Never too large but for roundoff. Right to some units of roundoff of the extent, but where the
  /// point is nearer than about 1e-8 of it to a sharp curved edge: there it may be too small by 1e-11 of it.
  double Find() {
    ApproachBySimplices();
    if constexpr (dgd::SmoothCore<Core>) PolishDirection();
    return std::max(bound_, 0.0);
  }

 private:
  using VectorL = dgd::Vector<double, L>;

  /// Planes are lifted to z = 0: then one set of features serves.
  static Eigen::Vector3d Lifted(const VectorL& point) {
    Eigen::Vector3d lifted = Eigen::Vector3d::Zero();
    lifted.template head<L>() = point;
    return lifted;
  }

  dgd::SupportPoint<typename Core::Scalar, L> Support(const VectorL& direction) const {
    return core_.Support(direction.template cast<typename Core::Scalar>());
  }

  /// Takes over a direction if its bound is higher.
  bool Raise(const VectorL& direction, const VectorL& support) {
    const double bound = direction.dot(x_ - support);
    if (!(bound > bound_)) return false;
    bound_ = bound;
    direction_ = direction;
    return true;
  }

  static bool IsInside(const Eigen::Vector3d& x, const std::array<Eigen::Vector3d, 4>& corners) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d& a = corners[(i + 1) % 4];
      const Eigen::Vector3d normal = (corners[(i + 2) % 4] - a).cross(corners[(i + 3) % 4] - a);
      if (!(normal.dot(x - a) * normal.dot(corners[i] - a) > 0)) return false;
    }
    return true;
  }

  void ApproachBySimplices() {
    constexpr int kMaxSteps = 200;
    constexpr double kEnough = 4 * std::numeric_limits<double>::epsilon();
    const Eigen::Vector3d x = Lifted(x_);
    const Eigen::Vector3d center = Lifted(core_.Center().template cast<double>());
    // Three points, the nearest point of whose triangle is as far as got.
    std::array<Eigen::Vector3d, 3> triangle{center, center, center};
    Eigen::Vector3d nearest = center;
    for (int step = 0; step < kMaxSteps; ++step) {
      const double distance = (x - nearest).norm();
      if (!(distance > 0)) {
        bound_ = std::max(bound_, 0.0);
        return;
      }
      const VectorL direction = ((x - nearest) / distance).template head<L>();
      const VectorL support = Support(direction).point.template cast<double>();
      Raise(direction, support);
      if (distance - bound_ <= kEnough * (distance + support.norm())) return;

      const std::array<Eigen::Vector3d, 4> corners{Lifted(support), triangle[0], triangle[1], triangle[2]};
      if (IsInside(x, corners)) return;
      double least = distance;
      for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        const std::array<Eigen::Vector3d, 3> face{corners[(left_out + 1) % 4], corners[(left_out + 2) % 4],
                                                  corners[(left_out + 3) % 4]};
        const Eigen::Vector3d candidate = dgd::ClosestPointOnTriangle(x, face[0], face[1], face[2]);
        if (!((candidate - x).norm() < least)) continue;
        least = (candidate - x).norm();
        nearest = candidate;
        triangle = face;
      }
      if (!(least < distance)) return;
    }
  }

  /// Maximises <u, x> - s(u) over unit u; s'' is the piece's derivative, and the sphere's curvature adds the bound.
  void PolishDirection() requires dgd::SmoothCore<Core> {
    constexpr int kMaxSteps = 50, kMaxHalvings = 12;
    if (direction_.isZero()) return;
    for (int step = 0; step < kMaxSteps; ++step) {
      const VectorL u = direction_;
      const auto d = u.template cast<typename Core::Scalar>().eval();
      const auto curved = core_.PieceSupport(core_.Support(d).feature, d);
      if (!curved.derivative.allFinite()) return;
      const VectorL gap = x_ - curved.point.template cast<double>();
      const VectorL slope = gap - u * u.dot(gap);
      // Along u, where a step makes no difference, the matrix is the identity.
      dgd::SquareMatrix<double, L> curvature = curved.derivative.template cast<double>() + u * u.transpose();
      curvature.diagonal().array() += std::max(u.dot(gap), 0.0);
      dgd::SquareMatrix<double, L> inverse;
      if (!dgd::Invert(curvature, inverse)) return;  // Flat, and x not beyond: the bound stays.
      VectorL move = inverse * slope;
      move -= u * u.dot(move);
      if (!move.allFinite()) return;
      bool rises = false;
      for (int halving = 0; halving < kMaxHalvings && !rises; ++halving, move /= 2) {
        const VectorL moved = (u + move).normalized();
        rises = moved.allFinite() && Raise(moved, Support(moved).point.template cast<double>());
      }
      if (!rises) return;
    }
  }

  const Core& core_;
  VectorL x_;
  VectorL direction_ = VectorL::Zero();
  double bound_ = -std::numeric_limits<double>::infinity();
};

}  // namespace dgd_test
