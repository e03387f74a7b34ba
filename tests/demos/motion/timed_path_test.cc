// Contract of timed paths: within the joints' limits by differences, near the path, and as fast as theory says.
#include "motion/timed_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace dgd_demos {
namespace {

constexpr double kStep = 1e-3;  // Between two samples, s.

/// Only the limits matter: each joint has another one.
Arm ArmOf(const std::vector<double>& max_velocities) {
  Arm arm;
  arm.links.resize(max_velocities.size() + 1);
  for (const double max_velocity : max_velocities) {
    arm.joints.push_back({"", {}, Eigen::Vector3d::UnitZ(), -10, 10, max_velocity, 1});
  }
  return arm;
}

Configuration Angles(const std::vector<double>& angles) {
  return Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size()));
}

/// Parts from a thousandth of a radian to two, with turns of any angle.
JointPath RandomPath(std::size_t joints, std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-3, 0.3);
  JointPath path = {Configuration::Zero(static_cast<Eigen::Index>(joints))};
  for (int i = 0; i < 12; ++i) {
    const auto draw = [&](double) { return coordinate(random); };
    const Configuration direction = path[0].unaryExpr(draw).normalized();
    path.push_back(path.back() + std::pow(10, exponent(random)) * direction);
  }
  return path;
}

double DistanceFrom(const Configuration& point, const Configuration& from, const Configuration& to) {
  const Configuration along = to - from;
  const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - from - share * along).norm();
}

double DistanceFrom(const Configuration& point, const JointPath& path) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) least = std::min(least, DistanceFrom(point, path[i - 1], path[i]));
  return least;
}

std::vector<JointState> SamplesOf(const TimedPath& timed) {
  std::vector<JointState> samples;
  const int steps = static_cast<int>(std::ceil(timed.Duration() / kStep));
  for (int i = 0; i <= steps; ++i) samples.push_back(timed.Sample(i * kStep));
  return samples;
}

class TimedPathTest : public testing::TestWithParam<double> {
 protected:
  TimingOptions Options() const { return {/*max_acceleration=*/3, /*max_deviation=*/GetParam()}; }
  Arm arm_ = ArmOf({0.5, 3, 1, 2});
};

INSTANTIATE_TEST_SUITE_P(Deviations, TimedPathTest, testing::Values(0, 1e-3, 0.05));

TEST_P(TimedPathTest, DifferencesOfSamples_AreWithinTheLimits) {
  constexpr double kRounding = 1e-9;
  std::mt19937_64 random(1);
  for (int run = 0; run < 20; ++run) {
    const std::vector<JointState> samples = SamplesOf(TimedPath(arm_, RandomPath(4, random), Options()));
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const Eigen::VectorXd velocities = (samples[i].angles - samples[i - 1].angles) / kStep;
      const Eigen::VectorXd accelerations = (samples[i].velocities - samples[i - 1].velocities) / kStep;
      for (std::size_t joint = 0; joint < arm_.joints.size(); ++joint) {
        const auto index = static_cast<Eigen::Index>(joint);
        ASSERT_LE(std::abs(velocities[index]), arm_.joints[joint].max_velocity + kRounding);
        ASSERT_LE(std::abs(samples[i].velocities[index]), arm_.joints[joint].max_velocity + kRounding);
        ASSERT_LE(std::abs(accelerations[index]), Options().max_acceleration + kRounding);
      }
      // Velocities are those of the angles: their mean over a step is within what they change in it.
      const Eigen::VectorXd means = (samples[i].velocities + samples[i - 1].velocities) / 2;
      ASSERT_LE((velocities - means).cwiseAbs().maxCoeff(), Options().max_acceleration * kStep);
    }
  }
}

TEST_P(TimedPathTest, Samples_StayWithinTheDeviation) {
  constexpr double kRounding = 1e-9;
  std::mt19937_64 random(2);
  double farthest = 0;
  for (int run = 0; run < 10; ++run) {
    const JointPath path = RandomPath(4, random);
    const std::vector<JointState> samples = SamplesOf(TimedPath(arm_, path, Options()));
    for (const JointState& state : samples) farthest = std::max(farthest, DistanceFrom(state.angles, path));
    // And no corner is left out.
    for (const Configuration& corner : path) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 1; i < samples.size(); ++i) {
        nearest = std::min(nearest, DistanceFrom(corner, {samples[i - 1].angles, samples[i].angles}));
      }
      EXPECT_LE(nearest, GetParam() + 1e-5);
    }
  }
  EXPECT_LE(farthest, GetParam() + kRounding);
  EXPECT_GE(farthest, GetParam() / 10);  // The deviation is made use of.
}

TEST_P(TimedPathTest, RestsAtTheEndsOfThePath) {
  std::mt19937_64 random(3);
  const JointPath path = RandomPath(4, random);
  const TimedPath timed(arm_, path, Options());
  for (const double early : {-1.0, 0.0, 1e-12}) {
    EXPECT_LE((timed.Sample(early).angles - path.front()).norm(), 1e-12);
    EXPECT_LE(timed.Sample(early).velocities.norm(), 1e-10);
  }
  for (const double late : {-1e-12, 0.0, 1.0}) {
    EXPECT_LE((timed.Sample(timed.Duration() + late).angles - path.back()).norm(), 1e-12);
    EXPECT_LE(timed.Sample(timed.Duration() + late).velocities.norm(), 1e-10);
  }
}

TEST(TimedPath, StraightMotion_TakesTheTimeOfTheory) {
  constexpr double kAcceleration = 2;
  const Arm arm = ArmOf({0.5, 0.5});
  // Long enough for the top speed of the joint that goes farther: distance / speed + speed / acceleration.
  EXPECT_NEAR(TimedPath(arm, {Angles({0, 0}), Angles({1, -3})}, {kAcceleration, 0}).Duration(), 3 / 0.5 + 0.25, 1e-12);
  // Too short for it: half of the way speeding up, half of it braking.
  EXPECT_NEAR(TimedPath(arm, {Angles({0, 0}), Angles({0.02, 0.01})}, {kAcceleration, 0}).Duration(), 2 * 0.1, 1e-12);
}

TEST(TimedPath, WithoutDeviation_StopsAtCorners) {
  const TimedPath timed(ArmOf({1, 1}), {Angles({0, 0}), Angles({1, 0}), Angles({1, 1})}, {2, 0});
  const JointState middle = timed.Sample(timed.Duration() / 2);
  EXPECT_LE((middle.angles - Angles({1, 0})).norm(), 1e-12);
  EXPECT_LE(middle.velocities.norm(), 1e-9);
}

// By the parabola's own formulas: it comes as near as the deviation to the corner, at the speed that bends it so.
TEST(TimedPath, RightAngle_IsCutByTheDeviation) {
  constexpr double kDeviation = 0.01, kAcceleration = 2;
  const TimedPath timed(ArmOf({9, 9}), {Angles({0, 0}), Angles({1, 0}), Angles({1, 1})}, {kAcceleration, kDeviation});
  const JointState middle = timed.Sample(timed.Duration() / 2);
  EXPECT_NEAR((middle.angles - Angles({1, 0})).norm(), kDeviation, 1e-12);
  const double cut = 4 * kDeviation / std::sqrt(2), speed = std::sqrt(2 * kAcceleration * cut);
  EXPECT_NEAR((middle.velocities - Angles({speed / 2, speed / 2})).norm(), 0, 1e-9);
}

TEST(TimedPath, ConfigurationsOnTheWay_CostNoTime) {
  const Arm arm = ArmOf({1, 1, 1});
  const JointPath path = {Angles({0, 0, 0}), Angles({1, 2, 0.3})};
  const double duration = TimedPath(arm, path).Duration();
  EXPECT_NEAR(TimedPath(arm, Subdivide(path, 0.01)).Duration(), duration, 1e-9);
  EXPECT_NEAR(TimedPath(arm, {path[0], path[0], path[1], path[1]}).Duration(), duration, 1e-12);
}

TEST(TimedPath, OfOneConfiguration_RestsThere) {
  const TimedPath timed(ArmOf({1, 1}), {Angles({0.1, 0.2})});
  EXPECT_EQ(timed.Duration(), 0);
  EXPECT_EQ(timed.Sample(1).angles, Angles({0.1, 0.2}));
  EXPECT_EQ(timed.Sample(1).velocities, Angles({0, 0}));
}

TEST(TimedPath, InputThatMakesNoSense_Throws) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Arm arm = ArmOf({1, 1});
  const JointPath path = {Angles({0, 0}), Angles({1, 0})};
  EXPECT_THROW(TimedPath(arm, {}), std::invalid_argument);
  EXPECT_THROW(TimedPath(arm, {Angles({0})}), std::invalid_argument);
  EXPECT_THROW(TimedPath(arm, {Angles({0, kNan})}), std::invalid_argument);
  EXPECT_THROW(TimedPath(arm, path, {0, 0}), std::invalid_argument);
  EXPECT_THROW(TimedPath(arm, path, {kNan, 0}), std::invalid_argument);
  EXPECT_THROW(TimedPath(arm, path, {1, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace dgd_demos
