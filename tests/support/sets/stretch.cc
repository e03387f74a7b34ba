#include "support/sets/stretch.h"

#include <Eigen/SVD>

namespace dgd_test {
namespace {

template <int L>
Stretch BySingularValues(const dgd::SquareMatrix<double, L>& linear) {
  const dgd::Vector<double, L> falling = Eigen::JacobiSVD<dgd::SquareMatrix<double, L>>(linear).singularValues();
  return {falling[0], falling[L - 1]};
}

}  // namespace

Stretch StretchOf(const dgd::SquareMatrix<double, 2>& linear) { return BySingularValues<2>(linear); }
Stretch StretchOf(const dgd::SquareMatrix<double, 3>& linear) { return BySingularValues<3>(linear); }

}  // namespace dgd_test
