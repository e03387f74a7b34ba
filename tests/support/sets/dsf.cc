#include "support/sets/dsf.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include "support/sets/dsf_sums.h"
#include "support/sets/support_distance.h"

namespace dgd_test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// A height whose power is below 2^-70 of the highest one's changes no digit of the sums, and is left out. Logarithms
/// are of normal numbers, of 2^-900 or more.
constexpr double kNegligible = 70, kLowest = 900;

/// @return the power if it is a whole number, else 0.
std::uint32_t WholeOrZero(double power) {
  const bool is_whole = power > 0 && power < std::numeric_limits<std::uint32_t>::max() && power == std::floor(power);
  return is_whole ? static_cast<std::uint32_t>(power) : 0;
}

/// Orders points so that those of a block are near each other, and lie behind a direction together.
void OrderByPlace(Points::iterator begin, Points::iterator end) {
  if (end - begin <= static_cast<std::ptrdiff_t>(dsf_internal::kLanes)) return;
  Eigen::Vector3d lowest = *begin, highest = *begin;
  for (auto point = begin; point != end; ++point) {
    lowest = lowest.cwiseMin(*point);
    highest = highest.cwiseMax(*point);
  }
  Eigen::Index axis;
  (highest - lowest).maxCoeff(&axis);
  // Whole blocks on either side.
  constexpr auto kLanes = static_cast<std::ptrdiff_t>(dsf_internal::kLanes);
  const auto blocks = (end - begin + kLanes - 1) / kLanes;
  const auto middle = begin + blocks / 2 * kLanes;
  std::nth_element(begin, middle, end, [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  OrderByPlace(begin, middle);
  OrderByPlace(middle, end);
}

/// The sums by the instructions that every x86-64 has.
void SumBaseline(const double* offsets, std::size_t blocks, const double* direction, const dsf_internal::Powers& powers,
                 bool with_spread, dsf_internal::Sums& sums) {
  dsf_internal::Sum(offsets, blocks, direction, powers, with_spread, sums);
}

}  // namespace

bool dsf_internal::HasAvx2() { return __builtin_cpu_supports("avx2") != 0; }

DsfInDouble::DsfInDouble(const dgd::ConvexHull& hull, double exponent)
    : exponent_(exponent),
      whole_power_(WholeOrZero(exponent - 2)),
      least_part_(std::exp2(std::max(-kNegligible / (exponent - 2), -kLowest))),
      origin_(hull.center),
      inradius_(dgd::InradiusOfRounded<double>(hull)) {
  if (!(std::isfinite(exponent) && exponent > 2)) {
    throw std::invalid_argument("dsf exponent must be finite and > 2; got " + std::to_string(exponent));
  }
  if (hull.dimension < 3 || !(hull.inradius > 0)) {
    throw std::invalid_argument(
        "dsf points must not be in one plane: its support function is about an inner point;"
        " their hull has dimension " +
        std::to_string(hull.dimension));
  }
  Points offsets;
  for (const Eigen::Vector3d& vertex : hull.vertices) offsets.push_back(vertex - origin_);
  OrderByPlace(offsets.begin(), offsets.end());
  const std::size_t blocks = (offsets.size() + dsf_internal::kLanes - 1) / dsf_internal::kLanes;
  offsets_.assign(blocks * dsf_internal::kBlock, 0);
  for (std::size_t j = 0; j < offsets.size(); ++j) {
    double* const at = &offsets_[j / dsf_internal::kLanes * dsf_internal::kBlock + j % dsf_internal::kLanes];
    for (std::size_t k = 0; k < 3; ++k) at[k * dsf_internal::kLanes] = offsets[j][static_cast<Eigen::Index>(k)];
  }
}

dsf_internal::Sums DsfInDouble::SumsAlong(const Eigen::Vector3d& direction, bool with_spread) const {
  static const dsf_internal::SumKernel kBest = dsf_internal::HasAvx2() ? dsf_internal::SumAvx2 : SumBaseline;
  dsf_internal::Sums sums;
  kBest(offsets_.data(), offsets_.size() / dsf_internal::kBlock, direction.data(),
        {exponent_, whole_power_, least_part_}, with_spread, sums);
  return sums;
}

/// The gradient of the p-norm of the heights and, if `with_derivative`, its Hessian. With m the highest height, r_j the
/// others as parts of it and q = sum r_j^p, the support value is s = m q^(1/p), and the gradient g = q^(1/p - 1) sum
/// r_j^(p-1) w_j. The Hessian is (p - 1) / (q s) sum r_j^(p-2) z_j z_j^T with z_j = q^(1/p) w_j - r_j g. Both are
/// written by u_j = w_j - r_j w_0, w_0 the highest offset: near a vertex the sums of w_j would cancel.
dgd::CurvedPoint<double> DsfInDouble::Curve(const Eigen::Vector3d& direction, bool with_derivative) const {
  dgd::CurvedPoint<double> curved{origin_, dgd::Matrix3<double>::Constant(std::numeric_limits<double>::quiet_NaN())};
  const double length = direction.cwiseAbs().maxCoeff();
  if (!(length > 0)) return curved;
  const dsf_internal::Sums sums = SumsAlong(direction / length, with_derivative);
  if (!(sums.highest > 0)) return curved;
  const double root = std::pow(sums.powers, 1 / exponent_);
  const Eigen::Vector3d offset = Eigen::Map<const Eigen::Vector3d>(sums.offset) / sums.powers;
  curved.point = origin_ + root * (Eigen::Map<const Eigen::Vector3d>(sums.top) + offset);
  if (!with_derivative) return curved;

  const auto& [xx, xy, xz, yy, yz, zz] = sums.spread;
  dgd::Matrix3<double> spread;
  spread << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  curved.derivative = (exponent_ - 1) * root / (sums.powers * sums.highest * length) *
                      (spread - sums.powers * offset * offset.transpose());
  return curved;
}

dgd::SupportPoint<double> DsfInDouble::Support(const Eigen::Vector3d& direction) const {
  return {Curve(direction, false).point, 0};
}

dgd::CurvedPoint<double> DsfInDouble::PieceSupport(dgd::FeatureId, const Eigen::Vector3d& direction) const {
  return Curve(direction, true);
}

double DsfInDouble::SupportValue(const Eigen::Vector3d& direction) const {
  const double length = direction.cwiseAbs().maxCoeff();
  const double at_origin = direction.dot(origin_);  // NaN where the direction is.
  if (!(length > 0)) return at_origin;
  const dsf_internal::Sums sums = SumsAlong(direction / length, false);
  if (!(sums.highest > 0)) return at_origin;
  return length * sums.highest * std::pow(sums.powers, 1 / exponent_) + at_origin;
}

double DsfInDouble::Distance(const Eigen::Vector3d& point) const {
  return SupportDistance<3, DsfInDouble>(*this, point).Find();
}

}  // namespace dgd_test
