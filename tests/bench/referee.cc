#include "bench/referee.h"

#include <algorithm>
#include <cmath>

namespace dgd_bench {
namespace {

using dgd_test::Which;
using Eigen::Vector3d;

constexpr double kNegligible = 1e-6;  // Of the extent.

}  // namespace

dgd_test::DistanceBounds BoundSignedDistance(const dgd_test::AnyPair<double, 3>& pair) {
  const Vector3d between = pair.Center(Which::kSecond) - pair.Center(Which::kFirst);
  return dgd_test::BoundDistanceToOrigin([&](const Vector3d& direction) -> Vector3d {
    const Vector3d unit = direction.normalized();
    return between + pair.SupportFromCenter(Which::kSecond, unit) - pair.SupportFromCenter(Which::kFirst, -unit);
  });
}

Referee::Referee(const dgd_test::AnyPair<double, 3>& pair) : pair_(pair), negligible_(kNegligible * pair.Extent()) {
  const dgd_test::DistanceBounds bounds = BoundSignedDistance(pair);
  lower_ = bounds.lower;
  upper_ = bounds.upper;
}

SeparationErrors Referee::Judge(const SeparationAnswer& answer) const {
  const double along = dgd_test::SeparationAlong(pair_, answer.normal);
  SeparationErrors errors;
  errors.normal = std::max(0.0, lower_ - along);
  errors.depth = std::abs(answer.separation - along);
  errors.witness = std::max(OutsideOf(Which::kFirst, answer.witness_1), OutsideOf(Which::kSecond, answer.witness_2));
  errors.is_wrong = (AreApart() && !(answer.separation > 0)) || (Overlap() && !(answer.separation <= 0));
  return errors;
}

double Referee::OutsideOf(Which which, const Vector3d& point) const {
  const Vector3d from_center = point - pair_.Center(which);
  const dgd_test::DistanceBounds bounds = dgd_test::BoundDistanceToOrigin([&](const Vector3d& direction) -> Vector3d {
    return pair_.SupportFromCenter(which, direction.normalized()) - from_center;
  });
  return std::max(0.0, bounds.lower);
}

}  // namespace dgd_bench
