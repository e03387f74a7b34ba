#include "support/pairs/extended_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "dgd/convex_hull.h"

namespace dgd_test {
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

Real SignOf(Real value) { return value < 0 ? -1 : 1; }

RealVector HighestOf(const std::vector<RealVector>& points, const RealVector& direction) {
  const auto is_lower = [&](const RealVector& a, const RealVector& b) { return direction.dot(a) < direction.dot(b); };
  return *std::max_element(points.begin(), points.end(), is_lower);
}

RealVector BoxSupport(const RealVector& half_extents, const RealVector& direction) {
  return half_extents.cwiseProduct(direction.unaryExpr(&SignOf));
}

/// The farthest point of a circle about the z axis.
RealVector CirclePoint(const RealVector& direction, Real radius, Real height) {
  const Real lateral = std::hypot(direction.x(), direction.y());
  if (!(lateral > 0)) return {radius, 0, height};
  return {radius / lateral * direction.x(), radius / lateral * direction.y(), height};
}

/// The higher one of two circles, of which one may be an apex.
RealVector TwoCirclesSupport(const RealVector& direction, Real base_radius, Real top_radius, Real height) {
  const RealVector base = CirclePoint(direction, base_radius, -height / 2);
  const RealVector top = CirclePoint(direction, top_radius, height / 2);
  return direction.dot(base) > direction.dot(top) ? base : top;
}

RealVector EllipsoidSupport(const RealVector& semi_axes, const RealVector& direction) {
  const RealVector stretched = semi_axes.cwiseProduct(direction);
  return semi_axes.cwiseProduct(stretched) / stretched.norm();
}

/// Gradient of the dual norm of A d, whose exponent is as the core has it, in double.
RealVector SuperellipsoidSupport(const RealVector& semi_axes, double exponent, const RealVector& direction) {
  const Real dual = exponent / (exponent - 1);
  const RealVector stretched = semi_axes.cwiseProduct(direction);
  const Real largest = stretched.cwiseAbs().maxCoeff();
  Real sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += std::pow(std::abs(stretched[axis]) / largest, dual);
  RealVector point;
  for (int axis = 0; axis < 3; ++axis) {
    const Real part = std::pow(std::abs(stretched[axis]) / largest, dual - 1) * std::pow(sum, 1 / dual - 1);
    point[axis] = SignOf(stretched[axis]) * semi_axes[axis] * part;
  }
  return point;
}

/// Gradient of the p-norm of the positive heights above the centre.
RealVector DsfSupport(const std::vector<RealVector>& points, const RealVector& center, Real exponent,
                      const RealVector& direction) {
  Real highest = 0;
  for (const RealVector& point : points) highest = std::max(highest, direction.dot(point - center));
  Real sum = 0;
  RealVector gradient = RealVector::Zero();
  for (const RealVector& point : points) {
    const Real height = direction.dot(point - center) / highest;
    if (!(height > 0)) continue;
    const Real power = std::pow(height, exponent - 1);
    sum += power * height;
    gradient += power * (point - center);
  }
  return center + std::pow(sum, 1 / exponent - 1) * gradient;
}

/// A function's value at a number, and its slope there; `across` is the derivative by another variable.
struct Sample {
  Real at = 0, value = 0, slope = 0, across = 0;
};

/// Minimum of a function of one variable whose slope changes its sign once from below to above: between two samples,
/// by turns from where their tangents meet, from where their slopes are interpolated to vanish, and from the middle.
/// The first is right at once at kinks, the second one converges fast where the function is smooth.
/// @return the lower sample, and the derivative across at the minimum: of the convex combination without slope.
template <class Function>
Sample Minimum(const Function& function, Real first_step, Real farthest_certain) {
  constexpr int kMostSteps = 400;
  Sample low = function(Real(0));
  if (!(std::abs(low.slope) > 0)) return low;
  Sample high = low;
  for (Real step = first_step;; step *= 8) {
    if (!(step < 1e15L)) throw std::logic_error("no minimum");
    if (low.slope >= 0) {
      high = low;
      low = function(low.at - step);
    } else if (high.slope <= 0) {
      low = high;
      high = function(high.at + step);
    } else {
      break;
    }
  }
  for (int i = 0; i < kMostSteps; ++i) {
    const Real width = high.at - low.at;
    const Real meeting = low.at + (low.value - high.value + high.slope * width) / (high.slope - low.slope);
    const Real floor = low.value + low.slope * (meeting - low.at);
    const Real lowest = std::min(low.value, high.value);
    if (width <= farthest_certain && lowest - floor <= 2 * kEpsilon * std::abs(lowest)) break;
    const Real balanced = low.at - low.slope * width / (high.slope - low.slope);
    Real next = i % 3 == 0 ? meeting : i % 3 == 1 ? balanced : low.at + width / 2;
    if (!(next > low.at && next < high.at)) next = low.at + width / 2;
    if (!(next > low.at && next < high.at)) break;
    const Sample middle = function(next);
    if (!(std::abs(middle.slope) > 0)) return middle;
    (middle.slope < 0 ? low : high) = middle;
  }
  Sample best = low.value < high.value ? low : high;
  const Real weight = high.slope / (high.slope - low.slope);
  best.across = weight * low.across + (1 - weight) * high.across;
  return best;
}

/// Minimum over directions about one, by coordinate within coordinate.
/// @param evaluate  Value and gradient (in space) at a direction.
/// @param tangents  Two columns; in the plane, the first alone.
template <class Evaluate>
Real MinimumOverDirections(const Evaluate& evaluate, const RealVector& first, const Eigen::Matrix<Real, 3, 2>& tangents,
                           int dimension, Real farthest_certain) {
  constexpr Real kFirstStep = 1e-7L;
  const auto sample = [&](Real outer, Real inner) {
    const auto [value, gradient] = evaluate(RealVector(first + outer * tangents.col(0) + inner * tangents.col(1)));
    return std::array<Real, 3>{value, tangents.col(0).dot(gradient), tangents.col(1).dot(gradient)};
  };
  const auto over_inner = [&](Real outer) {
    if (dimension == 2) {
      const auto [value, slope, unused] = sample(outer, 0);
      return Sample{outer, value, slope, 0};
    }
    const Sample lowest = Minimum(
        [&](Real inner) {
          const auto [value, across, slope] = sample(outer, inner);
          return Sample{inner, value, slope, across};
        },
        kFirstStep, farthest_certain);
    return Sample{outer, lowest.value, lowest.across, 0};
  };
  return Minimum(over_inner, kFirstStep, farthest_certain).value;
}

/// Two unit vectors across another one; in the plane the first is the plane's.
Eigen::Matrix<Real, 3, 2> TangentsOf(const RealVector& axis, int dimension) {
  Eigen::Matrix<Real, 3, 2> tangents;
  tangents.col(0) = dimension == 2 ? RealVector(-axis.y(), axis.x(), 0) : axis.unitOrthogonal();
  tangents.col(1) = axis.cross(tangents.col(0));
  return tangents;
}

}  // namespace

ExtendedSet::ExtendedSet(const SetNumbers& numbers, const Eigen::Vector3d& center, const PoseNumbers& pose)
    : numbers_(numbers),
      center_(center.cast<Real>()),
      translation_(pose.translation.cast<Real>()),
      rotation_(pose.rotation.cast<Real>()) {
  const std::vector<Eigen::Vector3d> points =
      numbers.type == SetType::kDsf ? dgd::BuildConvexHull(numbers.points).vertices : numbers.points;
  for (const Eigen::Vector3d& point : points) points_.push_back(point.cast<Real>());
}

ExtendedSet ExtendedSet::Moved(const RealTwist& twist, Real time) const {
  ExtendedSet moved = *this;
  moved.translation_ += time * twist.linear;
  const Real rate = twist.angular.norm();
  if (rate > 0) {
    moved.rotation_ = Eigen::AngleAxis<Real>(time * rate, twist.angular / rate).toRotationMatrix() * rotation_;
  }
  return moved;
}

RealVector ExtendedSet::SupportFromCenter(const RealVector& direction) const {
  return rotation_ * (CoreSupport(rotation_.transpose() * direction) - center_) +
         Real(numbers_.radius) / direction.norm() * direction;
}

RealVector ExtendedSet::CoreSupport(const RealVector& direction) const {
  const RealVector lengths = numbers_.lengths.cast<Real>();
  const RealVector in_plane(lengths.x(), lengths.y(), 0);
  switch (numbers_.type) {
    case SetType::kPoint:
    case SetType::kCircle:
      return RealVector::Zero();
    case SetType::kSegment:
      return {0, 0, SignOf(direction.z()) * lengths[0]};
    case SetType::kStadium:
      return {0, SignOf(direction.y()) * lengths[0], 0};
    case SetType::kBox:
    case SetType::kPlainBox:
      return BoxSupport(lengths, direction);
    case SetType::kRectangle:
      return BoxSupport(in_plane, direction);
    case SetType::kCylinder:
      return CirclePoint(direction, lengths[0], SignOf(direction.z()) * lengths[1]);
    case SetType::kCone:
      return TwoCirclesSupport(direction, lengths[0], 0, lengths[1]);
    case SetType::kFrustum:
      return TwoCirclesSupport(direction, lengths[0], lengths[1], lengths[2]);
    case SetType::kEllipsoid:
      return EllipsoidSupport(lengths, direction);
    case SetType::kEllipse:
      return EllipsoidSupport(in_plane, direction);
    case SetType::kTriangle:
    case SetType::kPolytope:
    case SetType::kMesh:
    case SetType::kPolygon:
      return HighestOf(points_, direction);
    case SetType::kDsf:
      return DsfSupport(points_, center_, numbers_.exponent, direction);
    case SetType::kSuperellipsoid:
      return SuperellipsoidSupport(lengths, numbers_.exponent, direction);
    case SetType::kSuperellipse:
      return SuperellipsoidSupport(in_plane, numbers_.exponent, direction);
    case SetType::kAffineBox:
    case SetType::kAffineCylinder: {
      const RealMatrix stretch = numbers_.stretch.cast<Real>();
      const RealVector mapped = stretch.transpose() * direction;
      const RealVector point = numbers_.type == SetType::kAffineBox
                                   ? BoxSupport(lengths, mapped)
                                   : CirclePoint(mapped, lengths[0], SignOf(mapped.z()) * lengths[1]);
      return stretch * point + points_.at(0);
    }
  }
  throw std::logic_error("a type without a support function");
}

Real ExtendedGrowthDistance(const ExtendedSet& set_1, const ExtendedSet& set_2, int dimension,
                            const Eigen::Vector3d& normal) {
  // s is the largest <n, d> / H(n), H the support function of the difference about the centres: so d over the least
  // H(n) of all n with <n, d / |d|> = 1, on which plane H is convex.
  const RealVector between = set_2.Center() - set_1.Center();
  const Real distance = between.norm();
  const RealVector axis = between / distance;
  const RealVector first = normal.cast<Real>() / axis.dot(normal.cast<Real>());
  const auto height = [&](const RealVector& direction) {
    const RealVector point = set_1.SupportFromCenter(direction) - set_2.SupportFromCenter(-direction);
    return std::pair<Real, RealVector>(direction.dot(point), point);
  };
  const Real least = MinimumOverDirections(height, first, TangentsOf(axis, dimension), dimension,
                                           std::numeric_limits<Real>::infinity());
  return distance / least;
}

Real ExtendedSignedDistance(const ExtendedSet& set_1, const ExtendedSet& set_2, const Eigen::Vector3d& normal) {
  // The largest separation (<n, d> - H(n)) / |n|: along lines of n it is quasi-concave only, so what tangents say of it
  // is certain only near by.
  constexpr Real kNear = 1e-9L;
  const RealVector between = set_2.Center() - set_1.Center();
  const RealVector first = normal.cast<Real>().normalized();
  const auto overlap = [&](const RealVector& direction) {
    const RealVector point = set_1.SupportFromCenter(direction) - set_2.SupportFromCenter(-direction);
    const Real length = direction.norm(), height = direction.dot(point - between);
    return std::pair<Real, RealVector>(height / length,
                                       (point - between) / length - height / (length * length * length) * direction);
  };
  return -MinimumOverDirections(overlap, first, TangentsOf(first, 3), 3, kNear);
}

}  // namespace dgd_test
