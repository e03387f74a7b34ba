#include "dgd/shapes/dsf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "dgd/shapes/support_distance.h"

namespace dgd {
namespace {

/// Powers, most of the cost, are not computed twice: they stay on the stack, of twice as many points as the paper's
/// sets have (4 to 30). Those of further points are.
constexpr std::size_t kMostKeptPowers = 64;

}  // namespace

DsfInDouble::DsfInDouble(const ConvexHull& hull, double exponent)
    : exponent_(exponent), origin_(hull.center), inradius_(InradiusOfRounded<double>(hull)) {
  if (!(std::isfinite(exponent) && exponent > 2)) {
    throw std::invalid_argument("dsf exponent must be finite and > 2; got " + std::to_string(exponent));
  }
  if (hull.dimension < 3 || !(hull.inradius > 0)) {
    throw std::invalid_argument(
        "dsf points must not be in one plane: its support function is about an inner point;"
        " their hull has dimension " +
        std::to_string(hull.dimension));
  }
  for (const Eigen::Vector3d& vertex : hull.vertices) offsets_.push_back(vertex - origin_);
}

/// Gradient of the p-norm of the heights and, if asked for, its Hessian. With r_j the heights as parts of the largest
/// one, m, so that no power overflows, and q = sum r_j^p, the support value is s = m q^(1/p) and the gradient
/// g = q^(1/p - 1) sum r_j^(p-1) w_j. The Hessian is (p - 1) / (q s) sum r_j^(p-2) z_j z_j^T with
/// z_j = q^(1/p) w_j - r_j g: a sum of squares, so semidefinite also when rounded.
template <bool kWithDerivative>
CurvedPoint<double> DsfInDouble::Curve(const Eigen::Vector3d& direction) const {
  CurvedPoint<double> curved{origin_, Matrix3<double>::Constant(std::numeric_limits<double>::quiet_NaN())};
  const double length = direction.cwiseAbs().maxCoeff();
  if (!(length > 0)) return curved;
  const Eigen::Vector3d d = direction / length;
  double highest = 0;
  for (const Eigen::Vector3d& offset : offsets_) highest = std::max(highest, d.dot(offset));
  if (!(highest > 0)) return curved;

  double sum = 0;
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  [[maybe_unused]] std::array<double, kMostKeptPowers> powers;
  for (std::size_t j = 0; j < offsets_.size(); ++j) {
    const double part = d.dot(offsets_[j]) / highest;
    if (!(part > 0)) continue;
    const double power = std::pow(part, exponent_ - 2);
    if constexpr (kWithDerivative) {
      if (j < kMostKeptPowers) powers[j] = power;
    }
    sum += power * part * part;
    weighted += power * part * offsets_[j];
  }
  const double root = std::pow(sum, 1 / exponent_);
  const Eigen::Vector3d gradient = root / sum * weighted;
  curved.point = origin_ + gradient;
  if constexpr (!kWithDerivative) return curved;

  curved.derivative.setZero();
  for (std::size_t j = 0; j < offsets_.size(); ++j) {
    const double part = d.dot(offsets_[j]) / highest;
    if (!(part > 0)) continue;
    const double power = j < kMostKeptPowers ? powers[j] : std::pow(part, exponent_ - 2);
    const Eigen::Vector3d z = root * offsets_[j] - part * gradient;
    curved.derivative += power * (z * z.transpose());
  }
  curved.derivative *= (exponent_ - 1) / (sum * highest * root) / length;
  return curved;
}

SupportPoint<double> DsfInDouble::Support(const Eigen::Vector3d& direction) const {
  return {Curve<false>(direction).point, 0};
}

CurvedPoint<double> DsfInDouble::PieceSupport(FeatureId, const Eigen::Vector3d& direction) const {
  return Curve<true>(direction);
}

double DsfInDouble::SupportValue(const Eigen::Vector3d& direction) const {
  double highest = 0;
  for (const Eigen::Vector3d& offset : offsets_) highest = std::max(highest, direction.dot(offset));
  if (!(highest > 0)) return direction.dot(origin_);
  double sum = 0;
  for (const Eigen::Vector3d& offset : offsets_) {
    sum += std::pow(std::max(direction.dot(offset), 0.0) / highest, exponent_);
  }
  return highest * std::pow(sum, 1 / exponent_) + direction.dot(origin_);
}

double DsfInDouble::Distance(const Eigen::Vector3d& point) const {
  return SupportDistance<3, DsfInDouble>(*this, point).Find();
}

}  // namespace dgd
