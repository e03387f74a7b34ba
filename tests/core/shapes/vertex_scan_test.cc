#include "dgd/shapes/vertex_scan.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/random.h"

namespace dgd_test {
namespace {

/// All counts around the vector blocks, so that padding is met in every lane.
template <class S>
void CompareWithPlainLoop() {
  Random random(TestSeed());
  for (int count = 1; count < 70; ++count) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) points.push_back(random.InCube());
    const dgd::PointArrays<S> arrays(points);
    ASSERT_EQ(arrays.size(), static_cast<std::size_t>(count));
    for (int trial = 0; trial < 100; ++trial) {
      const dgd::Vector3<S> direction = random.UnitVector().cast<S>();
      const dgd::VertexId farthest = arrays.Farthest(direction);
      ASSERT_LT(farthest, static_cast<dgd::VertexId>(count));
      S best = -std::numeric_limits<S>::infinity();
      for (int i = 0; i < count; ++i) best = std::max(best, direction.dot(arrays[static_cast<std::size_t>(i)]));
      EXPECT_NEAR(direction.dot(arrays[farthest]), best, 4 * std::numeric_limits<S>::epsilon());
    }
  }
}

TEST(PointArrays, Farthest_MatchesPlainLoopForEveryCount) {
  CompareWithPlainLoop<double>();
  CompareWithPlainLoop<float>();
}

TEST(PointArrays, Farthest_NamesAPointForAnyDirection) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::vector<Eigen::Vector3d> points(13, Eigen::Vector3d(1, 2, 3));
  const dgd::PointArrays<double> arrays(points);
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(nan, nan, nan), Eigen::Vector3d(0, nan, 1),
        Eigen::Vector3d(infinity, 0, 0), Eigen::Vector3d(-infinity, infinity, 0)}) {
    EXPECT_LT(arrays.Farthest(direction), 13U);
  }
}

/// Random points, some of them twice and some on a plane that a direction is normal to, so that there are ties.
template <class S>
void CompareKernels() {
  if (!dgd::vertex_scan::HasAvx2()) GTEST_SKIP() << "this processor has no AVX2: there is nothing to compare";
  const S nan = std::numeric_limits<S>::quiet_NaN(), infinity = std::numeric_limits<S>::infinity();
  constexpr std::size_t kBlock = dgd::vertex_scan::kBlockBytes / sizeof(S);
  Random random(TestSeed());
  for (std::size_t padded = kBlock; padded <= 12 * kBlock; padded += kBlock) {
    for (int trial = 0; trial < 500; ++trial) {
      std::vector<S> coordinates(3 * padded);
      for (S& coordinate : coordinates) coordinate = static_cast<S>(random.Below(5) - 2);
      dgd::Vector3<S> direction = random.UnitVector().cast<S>();
      if (trial % 4 == 1) direction = dgd::Vector3<S>::Unit(trial / 4 % 3);
      if (trial % 50 == 2) direction[trial / 50 % 3] = trial % 100 == 2 ? nan : infinity;
      const S x = direction.x(), y = direction.y(), z = direction.z();
      ASSERT_EQ(dgd::vertex_scan::FarthestAvx2(coordinates.data(), padded, x, y, z),
                dgd::vertex_scan::FarthestSse2(coordinates.data(), padded, x, y, z))
          << padded << " points along " << direction.transpose();
    }
  }
}

TEST(VertexScan, Farthest_AllKernelsFindTheSamePointInDouble) { CompareKernels<double>(); }
TEST(VertexScan, Farthest_AllKernelsFindTheSamePointInFloat) { CompareKernels<float>(); }

}  // namespace
}  // namespace dgd_test
