#include "dgd/stretch.h"

#include <Eigen/SVD>

namespace dgd {
namespace {

template <int L>
Stretch BySingularValues(const SquareMatrix<double, L>& linear) {
  const Vector<double, L> falling = Eigen::JacobiSVD<SquareMatrix<double, L>>(linear).singularValues();
  return {falling[0], falling[L - 1]};
}

}  // namespace

Stretch StretchOf(const SquareMatrix<double, 2>& linear) { return BySingularValues<2>(linear); }
Stretch StretchOf(const SquareMatrix<double, 3>& linear) { return BySingularValues<3>(linear); }

}  // namespace dgd
