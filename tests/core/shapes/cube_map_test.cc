#include "dgd/shapes/cube_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.h"
#include "support/scalars.h"

namespace dgd_test {
namespace {

template <class S>
class CubeMap : public testing::Test {};
TYPED_TEST_SUITE(CubeMap, Scalars);

TYPED_TEST(CubeMap, MiddleOf_IsInItsCell) {
  for (const std::size_t least : {0u, 6u, 7u, 100u, 5000u}) {
    const dgd::CubeMap<TypeParam> cells(least);
    ASSERT_GE(cells.Size(), least);
    ASSERT_LE(cells.Size(), 4 * least + 6);
    for (std::size_t cell = 0; cell < cells.Size(); ++cell) ASSERT_EQ(cells.CellOf(cells.MiddleOf(cell)), cell);
  }
}

TYPED_TEST(CubeMap, CellOf_HoldsDirectionsNearItsMiddle) {
  using Vector = dgd::Vector3<TypeParam>;
  Random random(TestSeed());
  const dgd::CubeMap<TypeParam> cells(6 * 8 * 8);
  // Half the diagonal of a cell in the middle of a face, where cells look largest.
  const auto widest = static_cast<TypeParam>(std::atan(std::sqrt(2.0) / 8) * 1.0001);
  for (int trial = 0; trial < 10000; ++trial) {
    const auto direction = Vector((random.LogUniform(1e-6, 1e6) * random.UnitVector()).cast<TypeParam>());
    const Vector middle = cells.MiddleOf(cells.CellOf(direction));
    ASSERT_GE(middle.dot(direction), std::cos(widest) * middle.norm() * direction.norm()) << direction.transpose();
  }
}

TYPED_TEST(CubeMap, CellOf_AnyBits_IsACell) {
  const dgd::CubeMap<TypeParam> cells(100);
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam x : {TypeParam(0), TypeParam(-1), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(),
                            Limits::max(), Limits::denorm_min()}) {
    for (const TypeParam y : {TypeParam(0), Limits::infinity(), Limits::quiet_NaN(), -Limits::denorm_min()}) {
      for (const auto& direction :
           {dgd::Vector3<TypeParam>(x, y, 0), dgd::Vector3<TypeParam>(y, x, y), dgd::Vector3<TypeParam>(0, x, x)}) {
        EXPECT_LT(cells.CellOf(direction), cells.Size()) << direction.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace dgd_test
