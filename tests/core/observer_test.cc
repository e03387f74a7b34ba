// What an observer of a query is observed: once for each iteration, bounds that only approach each other, and at last
// those of the result.
#include <gtest/gtest.h>

#include <vector>

#include "dgd/shapes.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

template <int L>
dgd::Pose<double, L> RandomPose(Random& random, double distance) {
  dgd::Pose<double, L> pose;
  if constexpr (L == 3) {
    pose.rotation = random.Rotation();
  } else {
    pose.rotation = Eigen::Rotation2Dd(random.Uniform(-3, 3)).toRotationMatrix();
  }
  pose.translation = distance * random.UnitVector().template head<L>();
  return pose;
}

/// Of 200 queries at random poses, from deep overlap to far apart, each pair cold and then warm.
/// @return the most iterations of a query.
template <int L>
int CheckObserver(const AnySet<double, L>& set_1, const AnySet<double, L>& set_2) {
  using Iterate = dgd::Iterate<double, L>;
  Random random(TestSeed());
  int most = 0;
  for (int i = 0; i < 100; ++i) {
    const dgd::Pose<double, L> pose_1 = RandomPose<L>(random, 1), pose_2 = RandomPose<L>(random, 4);
    const AnyPair<double, L> pair(set_1, pose_1, set_2, pose_2);
    dgd::WarmStart<double, L> warm_start;
    for (int frame = 0; frame < 2; ++frame) {
      std::vector<Iterate> observed;
      const auto result =
          pair.GrowthDistance({}, &warm_start, [&observed](const Iterate& iterate) { observed.push_back(iterate); });
      EXPECT_EQ(result.status, dgd::Status::kOptimal);
      EXPECT_EQ(observed.size(), static_cast<std::size_t>(result.iterations));
      if (testing::Test::HasFailure()) return most;
      most = std::max(most, result.iterations);
      for (std::size_t k = 0; k < observed.size(); ++k) {
        EXPECT_EQ(observed[k].iteration, static_cast<int>(k) + 1);
        EXPECT_NEAR(observed[k].normal.norm(), 1, 1e-14);
        EXPECT_LE(observed[k].lower_bound, observed[k].upper_bound);
        if (k == 0) continue;
        // The lower one but for rounding: see LowerBound() in solver/ray_intersection.h.
        EXPECT_GE(observed[k].lower_bound, observed[k - 1].lower_bound * (1 - 2 * dgd::kEpsilon<double>));
        EXPECT_LE(observed[k].upper_bound, observed[k - 1].upper_bound);
      }
      EXPECT_EQ(observed.back().lower_bound, result.lower_bound);
      EXPECT_EQ(observed.back().upper_bound, result.upper_bound);
      EXPECT_EQ(observed.back().normal, result.normal);
    }
  }
  return most;
}

TEST(Observer, Polytopes_AreToldOnceForEachIteration) {
  const auto box = Erase(dgd::RoundedSet{dgd::Box<double>({0.3, 0.7, 1.1})});
  const auto rounded = Erase(dgd::RoundedSet{dgd::Box<double>({0.5, 0.2, 0.9}), 0.1});
  EXPECT_GT(CheckObserver<3>(box, box), 2);
  EXPECT_GT(CheckObserver<3>(box, rounded), 2);
}

TEST(Observer, CurvedSets_AreToldOnceForEachIteration) {
  const auto cone = Erase(dgd::RoundedSet{dgd::Cone<double>(0.6, 1.5)});
  const auto ellipsoid = Erase(dgd::RoundedSet{dgd::Ellipsoid<double>({0.3, 0.7, 1.1})});
  EXPECT_GT(CheckObserver<3>(cone, ellipsoid), 2);
  EXPECT_GT(CheckObserver<3>(cone, Erase(dgd::RoundedSet{dgd::Box<double>({0.3, 0.7, 1.1}), 0.1})), 2);
}

TEST(Observer, SetsOfThePlane_AreToldOnceForEachIteration) {
  const auto rectangle = Erase(dgd::RoundedSet{dgd::Rectangle<double>({0.3, 1.1})});
  const auto ellipse = Erase(dgd::RoundedSet{dgd::Ellipse<double>({0.4, 0.9})});
  EXPECT_GT(CheckObserver<2>(rectangle, rectangle), 2);
  EXPECT_GT(CheckObserver<2>(rectangle, ellipse), 2);
  EXPECT_GT(CheckObserver<2>(ellipse, ellipse), 2);
}

TEST(Observer, IterationLimit_EndsTheTelling) {
  const auto cone = Erase(dgd::RoundedSet{dgd::Cone<double>(0.6, 1.5)});
  dgd::Pose<double> pose;
  pose.translation = {1, 2, 0.5};
  int observed = 0;
  const AnyPair<double, 3> pair(cone, {}, cone, pose);
  const auto result =
      pair.GrowthDistance({.max_iterations = 2}, nullptr, [&observed](const dgd::Iterate<double, 3>&) { ++observed; });
  EXPECT_EQ(result.status, dgd::Status::kIterationLimit);
  EXPECT_EQ(observed, 2);
}

TEST(Observer, Watching_DoesNotChangeTheResult) {
  const auto cone = Erase(dgd::RoundedSet{dgd::Cone<double>(0.6, 1.5)});
  const auto ellipsoid = Erase(dgd::RoundedSet{dgd::Ellipsoid<double>({0.3, 0.7, 1.1})});
  dgd::Pose<double> pose;
  pose.translation = {1, 2, 0.5};
  const AnyPair<double, 3> pair(cone, {}, ellipsoid, pose);
  const auto watched = pair.GrowthDistance({}, nullptr, [](const dgd::Iterate<double, 3>&) {});
  const auto plain = pair.GrowthDistance();
  EXPECT_EQ(watched.iterations, plain.iterations);
  EXPECT_EQ(watched.lower_bound, plain.lower_bound);
  EXPECT_EQ(watched.upper_bound, plain.upper_bound);
  EXPECT_EQ(watched.normal, plain.normal);
}

}  // namespace
}  // namespace dgd_test
