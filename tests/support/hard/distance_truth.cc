#include "support/hard/distance_truth.h"

#include <algorithm>
#include <cmath>

#include "support/distance_bounds.h"
#include "support/pairs/any_pair.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

/// The exponent of the power of two that brings a length near to 1.
int ExponentOf(double length) { return length > 0 ? std::ilogb(length) : 0; }

}  // namespace

DistanceTruth TruthOf(const PairNumbers& pair) {
  // The balls of the radii add to any distance: without them, polytopes stay polytopes.
  PairNumbers cores = pair;
  cores.set_1.radius = cores.set_2.radius = 0;
  const AnyPair<double, 3> posed(cores);
  const Vector3d center_1 = posed.Center(Which::kFirst), center_2 = posed.Center(Which::kSecond);
  const Vector3d way = center_1 - center_2;
  // Squares of lengths must neither vanish nor overflow.
  const int exponent = ExponentOf(std::max(posed.Extent(), way.lpNorm<Eigen::Infinity>()));
  const auto in_unit = [exponent](double length) { return std::ldexp(length, -exponent); };
  const DistanceBounds bounds = BoundDistanceToOrigin([&](const Vector3d& direction) -> Vector3d {
    const Vector3d unit = direction.normalized();
    const Vector3d point =
        way + (posed.SupportFromCenter(Which::kFirst, unit) - posed.SupportFromCenter(Which::kSecond, -unit));
    return point.unaryExpr(in_unit);
  });
  const double radii = pair.set_1.radius + pair.set_2.radius;
  DistanceTruth truth;
  truth.lower = std::ldexp(bounds.lower, exponent) - radii;
  // Slivers of the polytope that proves the upper bound lose digits; planes do not.
  truth.upper = std::ldexp(std::max(bounds.upper, bounds.lower), exponent) - radii;
  truth.size = posed.Extent() + 2 * std::max(pair.set_1.radius, pair.set_2.radius);
  truth.reach = std::max(center_1.lpNorm<Eigen::Infinity>(), center_2.lpNorm<Eigen::Infinity>()) + truth.size;
  return truth;
}

double SeparationAlong(const PairNumbers& pair, const Vector3d& normal) {
  return SeparationAlong(AnyPair<double, 3>(pair), normal);
}

}  // namespace dgd_test
