// Checks a result against the two sets alone: support functions for the dual side, membership for the primal side.
// Works in double whatever the sets' scalar, and shares no code with the solver.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dgd/convex_set.h"
#include "dgd/growth_distance.h"
#include "dgd/types.h"

namespace dgd {

/// What a result is worth. Optimal means both infeasibilities and the gap vanish; all are non-negative, and NaN or
/// infinite where the result holds such.
struct Certificate {
  /// Largest of: the distance of the two witness points to each other after scaling by the growth distance (the
  /// constraint of the paper's eq. growth-distance-definition), and of each to its own set. Metres.
  double primal_infeasibility = 0;
  /// How far the normal is from unit length; and 1 more if it points from set 2 to set 1, where it bounds nothing.
  double dual_infeasibility = 0;
  /// The growth distance proven by the normal: no smaller scale makes the sets touch (paper, eq. ray-intersection-
  /// upper-bound, inverted).
  double proven_lower_bound = 0;
  /// growth distance / proven_lower_bound - 1.
  double relative_gap = 0;
  /// |reported separation - separation of the supporting planes along the normal|, metres.
  double separation_error = 0;

  bool Holds(double length_tolerance, double gap_tolerance) const {
    return primal_infeasibility <= length_tolerance && dual_infeasibility <= 1e-3 && relative_gap <= gap_tolerance &&
           separation_error <= length_tolerance;
  }
};

namespace certificate_internal {

/// A set in the world, in double.
template <class Set>
class PosedSet {
 public:
  using S = typename Set::Scalar;
  using Core = typename Set::Core;
  static constexpr int L = kDimension<Core>;
  using Point = Vector<double, L>;

  PosedSet(const Set& set, const PoseOf<Set>& pose)
      : set_(set),
        rotation_(pose.rotation.template cast<double>()),
        translation_(pose.translation.template cast<double>()),
        local_center_(VectorOf<Core>(set.core.Center()).template cast<double>()) {}

  Point Center() const { return rotation_ * local_center_ + translation_; }

  /// Largest <direction, x - center> over the set.
  double SupportAboutCenter(const Point& direction) const {
    const Point local = rotation_.transpose() * direction;
    return double(set_.core.SupportValue(local.template cast<S>())) - local.dot(local_center_) + double(set_.radius);
  }

  /// Distance of a world point from a set, 0 inside.
  double Distance(const Point& point) const {
    if (!point.allFinite()) return std::numeric_limits<double>::quiet_NaN();
    const VectorOf<Core> local = Point(rotation_.transpose() * (point - translation_)).template cast<S>();
    return std::max(0.0, double(set_.core.Distance(local)) - double(set_.radius));
  }

 private:
  const Set& set_;
  SquareMatrix<double, L> rotation_;
  Point translation_;
  Point local_center_;
};

}  // namespace certificate_internal

/// Certificate of `result` for the two sets in their poses, which must be those of the query.
template <class Set1, class Set2>
requires CertifiableCore<typename Set1::Core> && CertifiableCore<typename Set2::Core> Certificate
Certify(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
        const ResultOf<Set1>& result) {
  const certificate_internal::PosedSet<Set1> posed_1(set_1, pose_1);
  const certificate_internal::PosedSet<Set2> posed_2(set_2, pose_2);
  using Point = typename certificate_internal::PosedSet<Set1>::Point;
  const Point center_1 = posed_1.Center();
  const Point center_2 = posed_2.Center();
  const Point witness_1 = result.witness_1.template cast<double>();
  const Point witness_2 = result.witness_2.template cast<double>();
  const Point normal = result.normal.template cast<double>();
  const double growth_distance = double(result.GrowthDistance());

  Certificate certificate;
  const Point scaled_1 = center_1 + growth_distance * (witness_1 - center_1);
  const Point scaled_2 = center_2 + growth_distance * (witness_2 - center_2);
  const double infeasibilities[] = {(scaled_1 - scaled_2).norm(), posed_1.Distance(witness_1),
                                    posed_2.Distance(witness_2)};
  for (const double infeasibility : infeasibilities) {
    // std::max drops a NaN; this stays NaN.
    if (std::isnan(certificate.primal_infeasibility)) break;
    if (!(infeasibility <= certificate.primal_infeasibility)) certificate.primal_infeasibility = infeasibility;
  }

  const double along_ray = normal.dot(center_2 - center_1);
  certificate.dual_infeasibility = std::abs(normal.norm() - 1) + (along_ray >= 0 ? 0 : 1);
  const double support = posed_1.SupportAboutCenter(normal) + posed_2.SupportAboutCenter(-normal);
  certificate.proven_lower_bound = along_ray / support;
  certificate.separation_error = std::abs(along_ray - support - double(result.separation));
  certificate.relative_gap = growth_distance == 0 ? 0 : growth_distance / certificate.proven_lower_bound - 1;
  return certificate;
}

}  // namespace dgd
