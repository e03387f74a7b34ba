// Checks a signed distance against the two sets alone, as certificate.h checks a growth distance.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dgd/certificate.h"
#include "dgd/signed_distance.h"

namespace dgd {

/// What a signed distance is worth; all are non-negative, and NaN where the result holds such.
///
/// Apart, it is a proof: planes as far apart as the result says keep the sets from being nearer, and two points of them
/// are no farther apart than that. Overlapping, the same planes and points show that the reported translation is enough
/// and that none along this normal is less; that no normal nearby has a smaller one is sampled, and of normals
/// elsewhere nothing is proven.
struct SignedDistanceCertificate {
  /// Distance of each witness point to its own set, the larger one; metres.
  double primal_infeasibility = 0;
  /// How far the normal is from unit length.
  double dual_infeasibility = 0;
  /// |reported separation - separation of the supporting planes along the normal|, metres.
  double separation_error = 0;
  /// How far witness_2 is from witness_1 + separation * normal, metres.
  double connection_error = 0;
  /// Gain in separation of the best of 32 normals within 0.01 rad, metres.
  double neighbour_gain = 0;

  /// @param length_tolerance  For lengths along the normal and distances from the sets, metres.
  /// @param point_tolerance   For the connection, metres: along curves it is off by the root of what the separation is.
  bool Holds(double length_tolerance, double point_tolerance) const {
    return primal_infeasibility <= length_tolerance && dual_infeasibility <= 1e-3 &&
           separation_error <= length_tolerance && connection_error <= point_tolerance &&
           neighbour_gain <= length_tolerance;
  }
};

/// Certificate of `result` for the two sets in their poses, which must be those of the query.
template <class Set1, class Set2>
requires CertifiableCore<typename Set1::Core> && CertifiableCore<typename Set2::Core> SignedDistanceCertificate
Certify(const Set1& set_1, const PoseOf<Set1>& pose_1, const Set2& set_2, const PoseOf<Set1>& pose_2,
        const SignedDistanceResult<typename Set1::Scalar>& result) {
  using Point = Vector3<double>;
  const certificate_internal::PosedSet<Set1> posed_1(set_1, pose_1);
  const certificate_internal::PosedSet<Set2> posed_2(set_2, pose_2);
  const Point between_centers = posed_2.Center() - posed_1.Center();
  const auto separation_along = [&](const Point& normal) {
    return normal.dot(between_centers) - posed_1.SupportAboutCenter(normal) - posed_2.SupportAboutCenter(-normal);
  };
  const Point normal = result.normal.template cast<double>();
  const Point witness_1 = result.witness_1.template cast<double>(),
              witness_2 = result.witness_2.template cast<double>();
  const double separation = double(result.separation);

  SignedDistanceCertificate certificate;
  const double off_1 = posed_1.Distance(witness_1), off_2 = posed_2.Distance(witness_2);
  certificate.primal_infeasibility = off_1 > off_2 || std::isnan(off_1) ? off_1 : off_2;
  certificate.dual_infeasibility = std::abs(normal.norm() - 1);
  const double own = separation_along(normal);
  certificate.separation_error = std::abs(own - separation);
  certificate.connection_error = (witness_1 + separation * normal - witness_2).norm();

  const Matrix3<double> axes = FrameAlong<double>(normal);
  constexpr int kDirections = 8;
  for (const double angle : {1e-5, 1e-4, 1e-3, 1e-2}) {
    for (int i = 0; i < kDirections; ++i) {
      const double turn = 2 * std::numbers::pi * i / kDirections;
      const Point aside = std::cos(turn) * axes.col(0) + std::sin(turn) * axes.col(1);
      const double gain = separation_along((normal + angle * aside).normalized()) - own;
      certificate.neighbour_gain = std::max(certificate.neighbour_gain, gain);
    }
  }
  return certificate;
}

}  // namespace dgd
