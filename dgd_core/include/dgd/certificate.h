// Checks a result against the two sets alone: support functions for the dual side, membership for the primal side.
// Works in double whatever the sets' scalar, and shares no code with the solver.
#pragma once

#include <algorithm>
#include <limits>

#include "dgd/convex_set.h"
#include "dgd/growth_distance.h"
#include "dgd/types.h"

namespace dgd {

/// A core that can tell how far a point lies outside it.
template <class Core>
concept MeasurableCore = ConvexCore<Core> && requires(const Core& core, const VectorOf<Core>& point) {
  { core.Distance(point) } -> std::convertible_to<typename Core::Scalar>;
};

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

inline Eigen::Vector3d ToWorld(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation,
                               const Eigen::Vector3d& local) {
  return rotation * local + translation;
}

/// Largest <direction, x - center> over the posed set.
template <class Set>
double SupportAboutCenter(const Set& set, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& direction) {
  using S = typename Set::Scalar;
  const Eigen::Vector3d local = rotation.transpose() * direction;
  const Vector3<S> support = set.core.Support(local.template cast<S>()).point;
  const Vector3<S> center = set.core.Center();
  return local.dot(support.template cast<double>() - center.template cast<double>()) + double(set.radius);
}

/// Distance of a world point to the posed set, 0 inside.
template <class Set>
double DistanceToSet(const Set& set, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation,
                     const Eigen::Vector3d& point) {
  using S = typename Set::Scalar;
  const Eigen::Vector3d local = rotation.transpose() * (point - translation);
  if (!point.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  return std::max(0.0, double(set.core.Distance(local.template cast<S>())) - double(set.radius));
}

}  // namespace certificate_internal

/// Certificate of `result` for the two sets in their poses, which must be those of the query.
template <class Set1, class Set2>
requires MeasurableCore<typename Set1::Core> && MeasurableCore<typename Set2::Core> Certificate
Certify(const Set1& set_1, const Pose<typename Set1::Scalar>& pose_1, const Set2& set_2,
        const Pose<typename Set1::Scalar>& pose_2, const Result<typename Set1::Scalar>& result) {
  using namespace certificate_internal;
  using S = typename Set1::Scalar;
  const Eigen::Matrix3d rotation_1 = pose_1.rotation.template cast<double>();
  const Eigen::Matrix3d rotation_2 = pose_2.rotation.template cast<double>();
  const Eigen::Vector3d translation_1 = pose_1.translation.template cast<double>();
  const Eigen::Vector3d translation_2 = pose_2.translation.template cast<double>();
  const Vector3<S> local_center_1 = set_1.core.Center(), local_center_2 = set_2.core.Center();
  const Eigen::Vector3d center_1 = ToWorld(rotation_1, translation_1, local_center_1.template cast<double>());
  const Eigen::Vector3d center_2 = ToWorld(rotation_2, translation_2, local_center_2.template cast<double>());
  const Eigen::Vector3d witness_1 = result.witness_1.template cast<double>();
  const Eigen::Vector3d witness_2 = result.witness_2.template cast<double>();
  const Eigen::Vector3d normal = result.normal.template cast<double>();
  const double growth_distance = double(result.GrowthDistance());

  Certificate certificate;
  const Eigen::Vector3d scaled_1 = center_1 + growth_distance * (witness_1 - center_1);
  const Eigen::Vector3d scaled_2 = center_2 + growth_distance * (witness_2 - center_2);
  const double infeasibilities[] = {(scaled_1 - scaled_2).norm(),
                                    DistanceToSet(set_1, rotation_1, translation_1, witness_1),
                                    DistanceToSet(set_2, rotation_2, translation_2, witness_2)};
  for (const double infeasibility : infeasibilities) {
    // Not std::max, which drops a NaN; and once NaN, it stays so.
    if (std::isnan(certificate.primal_infeasibility)) break;
    if (!(infeasibility <= certificate.primal_infeasibility)) certificate.primal_infeasibility = infeasibility;
  }

  const Eigen::Vector3d p = center_2 - center_1;
  const double along_ray = normal.dot(p);
  certificate.dual_infeasibility = std::abs(normal.norm() - 1) + (along_ray >= 0 ? 0 : 1);
  const double support = SupportAboutCenter(set_1, rotation_1, normal) + SupportAboutCenter(set_2, rotation_2, -normal);
  certificate.proven_lower_bound = along_ray / support;
  certificate.separation_error = std::abs(along_ray - support - double(result.separation));
  certificate.relative_gap = growth_distance == 0 ? 0 : growth_distance / certificate.proven_lower_bound - 1;
  return certificate;
}

}  // namespace dgd
