#include "dgd/solver/support_pool.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/random.h"

namespace dgd_test {
namespace {

using Feature = dgd::DifferencePoint<double>;

/// Point i of one set less point i of another, both random.
std::vector<Feature> RandomSupports(Random& random, std::size_t count) {
  std::vector<Feature> supports;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d on_1 = random.InCube(), on_2 = 3 * random.InCube();
    supports.push_back({on_1 - on_2, on_1, static_cast<dgd::FeatureId>(i), static_cast<dgd::FeatureId>(100 + i)});
  }
  return supports;
}

TEST(SupportPool, Farthest_IsTheBestOfAllDifferencesOfTheLatest) {
  Random random(1);
  constexpr std::size_t kCapacity = dgd::SupportPool<double>::kCapacity;
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, kCapacity, kCapacity + 3}) {
    const std::vector<Feature> supports = RandomSupports(random, count);
    dgd::SupportPool<double> pool;
    for (const Feature& support : supports) pool.Remember(support);

    const std::size_t oldest = count - std::min(count, kCapacity);
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector3d direction = random.UnitVector();
      Feature best = supports[oldest];
      for (std::size_t i = oldest; i < count; ++i) {
        for (std::size_t j = oldest; j < count; ++j) {
          const Eigen::Vector3d minus_2 = supports[j].point - supports[j].on_1;
          const Eigen::Vector3d point = supports[i].on_1 + minus_2;
          if (direction.dot(point) > direction.dot(best.point)) {
            best = {point, supports[i].on_1, supports[i].feature_1, supports[j].feature_2};
          }
        }
      }
      const Feature farthest = pool.Farthest(direction);
      EXPECT_LT((farthest.point - best.point).norm(), 1e-14);
      EXPECT_EQ(farthest.on_1, best.on_1);
      EXPECT_EQ(farthest.feature_1, best.feature_1);
      EXPECT_EQ(farthest.feature_2, best.feature_2);
    }
  }
}

}  // namespace
}  // namespace dgd_test
