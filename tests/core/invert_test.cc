#include "dgd/invert.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random.h"

namespace dgd_test {
namespace {

template <int L>
void CheckRandomMatrices() {
  using Matrix = dgd::SquareMatrix<double, L>;
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    Matrix matrix, inverse;
    for (int j = 0; j < L * L; ++j) matrix(j) = random.Uniform(-1, 1);
    ASSERT_TRUE(dgd::Invert(matrix, inverse));
    // Rounding grows with the condition.
    EXPECT_LE((matrix * inverse - Matrix::Identity()).norm(), 1e-14 * matrix.norm() * inverse.norm()) << matrix;
  }
}

TEST(Invert, RandomMatrices_TimesTheirInverseAreTheIdentity) {
  CheckRandomMatrices<1>();
  CheckRandomMatrices<2>();
  CheckRandomMatrices<3>();
}

template <int L>
void CheckNone(const dgd::SquareMatrix<double, L>& matrix) {
  const dgd::SquareMatrix<double, L> before = dgd::SquareMatrix<double, L>::Constant(7);
  dgd::SquareMatrix<double, L> inverse = before;
  EXPECT_FALSE(dgd::Invert(matrix, inverse)) << matrix;
  EXPECT_EQ(inverse, before);
}

TEST(Invert, SingularTinyAndNoNumbers_HaveNone) {
  for (const double value : {0.0, 1e-320, std::numeric_limits<double>::quiet_NaN()}) {
    CheckNone<1>(dgd::SquareMatrix<double, 1>::Constant(value));
    CheckNone<2>(dgd::SquareMatrix<double, 2>::Constant(value));
    CheckNone<3>(dgd::SquareMatrix<double, 3>::Constant(value));
  }
  CheckNone<2>(dgd::SquareMatrix<double, 2>{{1, 2}, {2, 4}});
  CheckNone<3>(dgd::Matrix3<double>{{1, 2, 3}, {2, 4, 6}, {0, 1, 0}});
}

}  // namespace
}  // namespace dgd_test
