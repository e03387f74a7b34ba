#include "dgd/shapes/vertex_scan.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/random.h"

namespace dgd_test {
namespace {

template <class S>
dgd::PointArrays<S> RandomPoints(Random& random, int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(random.InCube());
  return dgd::PointArrays<S>(points);
}

/// All counts around the vector blocks, so that padding is met in every lane.
template <class S>
void CompareWithPlainLoop() {
  Random random(TestSeed());
  for (int count = 1; count < 70; ++count) {
    const dgd::PointArrays<S> arrays = RandomPoints<S>(random, count);
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

template <class S>
dgd::Matrix3<S> RandomMatrix(Random& random) {
  dgd::Matrix3<S> matrix;
  for (int column = 0; column < 3; ++column) matrix.col(column) = random.InCube().cast<S>();
  return matrix;
}

template <class S>
void ComparePlacedWithPlainProducts() {
  Random random(TestSeed());
  for (int count = 1; count < 70; ++count) {
    const dgd::PointArrays<S> arrays = RandomPoints<S>(random, count);
    const dgd::Vector3<S> center = random.InCube().cast<S>();
    const dgd::Matrix3<S> matrix = RandomMatrix<S>(random);
    const std::size_t padded = arrays.PaddedSize();
    ASSERT_GE(padded, arrays.size());
    std::vector<S> placed(3 * padded);
    arrays.PlaceInto(placed.data(), center, matrix);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      const dgd::Vector3<S> point(placed[i], placed[padded + i], placed[2 * padded + i]);
      const dgd::Vector3<S> expected = matrix * (arrays[i] - center);
      ASSERT_LT((point - expected).norm(), 16 * std::numeric_limits<S>::epsilon()) << i << " of " << count;
    }
    // The padding is placed as the first point is, and a scan finds none of it.
    for (std::size_t i = arrays.size(); i < padded; ++i) ASSERT_EQ(placed[i], placed[0]);
    const dgd::Vector3<S> direction = random.UnitVector().cast<S>();
    ASSERT_LT(dgd::PointArrays<S>::Farthest(placed.data(), padded, direction), static_cast<dgd::VertexId>(count));
  }
}

TEST(PointArrays, PlaceInto_MatchesPlainProductsForEveryCount) {
  ComparePlacedWithPlainProducts<double>();
  ComparePlacedWithPlainProducts<float>();
}

template <class S>
void ComparePlaceKernels() {
  if (!dgd::vertex_scan::HasAvx2()) GTEST_SKIP() << "this processor has no AVX2: there is nothing to compare";
  constexpr std::size_t kBlock = dgd::vertex_scan::kBlockBytes / sizeof(S);
  Random random(TestSeed());
  for (std::size_t padded = kBlock; padded <= 12 * kBlock; padded += kBlock) {
    for (int trial = 0; trial < 100; ++trial) {
      std::vector<S> coordinates(3 * padded), by_sse2(3 * padded), by_avx2(3 * padded);
      for (S& coordinate : coordinates) coordinate = static_cast<S>(random.Uniform(-1, 1));
      const dgd::Vector3<S> center = random.InCube().cast<S>();
      const dgd::Matrix3<S> matrix = RandomMatrix<S>(random);
      dgd::vertex_scan::PlaceSse2(coordinates.data(), padded, center.data(), matrix.data(), by_sse2.data());
      dgd::vertex_scan::PlaceAvx2(coordinates.data(), padded, center.data(), matrix.data(), by_avx2.data());
      ASSERT_EQ(by_sse2, by_avx2) << padded << " points";
    }
  }
}

TEST(VertexScan, Place_AllKernelsGiveTheSameBitsInDouble) { ComparePlaceKernels<double>(); }
TEST(VertexScan, Place_AllKernelsGiveTheSameBitsInFloat) { ComparePlaceKernels<float>(); }

}  // namespace
}  // namespace dgd_test
