// The snippets of the core's README, word for word, and what they should give.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "dgd/any_set.h"
#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/half_space_distance.h"
#include "dgd/shapes.h"
#include "dgd/signed_distance.h"
#include "dgd/time_of_impact.h"
#include "support/readme_snippets.h"

// The upper half of a ball, its flat side in the plane z = 0.
class Dome {
 public:
  using Scalar = double;
  explicit Dome(double radius) : radius_(radius) {}

  dgd::SupportPoint<double> Support(const Eigen::Vector3d& direction) const {
    if (direction.z() >= 0) return {radius_ * direction.normalized()};
    const Eigen::Vector3d lateral(direction.x(), direction.y(), 0);
    return {radius_ * lateral.normalized()};  // The disc's centre for direction -z: normalized() leaves a zero.
  }
  Eigen::Vector3d Center() const { return {0, 0, 0.375 * radius_}; }
  double Inradius() const { return 0.375 * radius_; }

 private:
  double radius_;
};
static_assert(dgd::ConvexCore<Dome>);

class Tetrahedron {
 public:
  using Scalar = double;

  dgd::SupportPoint<double> Support(const Eigen::Vector3d& direction) const {
    dgd::VertexId best = 0;
    for (dgd::VertexId i = 1; i < 4; ++i) {
      if (direction.dot(vertices_[i]) > direction.dot(vertices_[best])) best = i;
    }
    return {vertices_[best], best};
  }
  Eigen::Vector3d Center() const { return Eigen::Vector3d::Zero(); }
  double Inradius() const { return 0.577; }  // 1 / sqrt(3), rounded down.
  Eigen::Vector3d Vertex(dgd::VertexId i) const { return vertices_[i]; }
  dgd::VertexId VertexCount() const { return 4; }

 private:
  std::array<Eigen::Vector3d, 4> vertices_{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
};
static_assert(dgd::VertexCore<Tetrahedron>);

namespace {

TEST(ReadmeCore, SignedDistance_IsBetweenTheNearestPoints) {
  const dgd::RoundedSet set_1{dgd::Box<double>({0.5, 0.5, 0.5})};
  const dgd::RoundedSet set_2 = dgd::Sphere(0.25);
  const dgd::Pose<double> pose_1;
  dgd::Pose<double> pose_2;
  pose_2.translation = {0.2, 0.1, 2};

  dgd::WarmStart<double> warm_start;
  const dgd::Result<double> growth = dgd::GrowthDistance(set_1, pose_1, set_2, pose_2, {}, &warm_start);
  const dgd::SignedDistanceResult<double> distance =
      dgd::SignedDistance(set_1, pose_1, set_2, pose_2, growth, &warm_start);

  EXPECT_EQ(distance.status, dgd::Status::kOptimal);
  EXPECT_NEAR(distance.separation, 1.25, 1e-12);
  EXPECT_NEAR(distance.upper_bound, 1.25, 1e-12);
  EXPECT_NEAR((distance.witness_1 - Eigen::Vector3d(0.2, 0.1, 0.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((distance.witness_2 - Eigen::Vector3d(0.2, 0.1, 1.75)).norm(), 0, 1e-12);
}

TEST(ReadmeCore, SetsOfAnyShape_AreCheckedInTurn) {
  dgd::Pose<double> link_pose;
  const dgd::Pose<double> obstacle_pose;
  link_pose.translation = {0, 0, 0.75};
  int collisions = 0;

  const dgd::AnySet link = dgd::Capsule(0.1, 0.4);
  const std::vector<dgd::AnySet> obstacles = {dgd::Sphere(0.3), dgd::RoundedSet{dgd::Box<double>({1, 1, 0.1})}};
  for (const dgd::AnySet& obstacle : obstacles) {
    const dgd::CollisionResult<double> check = dgd::DetectCollision(link, link_pose, obstacle, obstacle_pose);
    if (check.status == dgd::Status::kColliding) ++collisions;
  }

  EXPECT_EQ(collisions, 1) << "the capsule's end is inside the ball, and above the box";
}

TEST(ReadmeCore, TurningRod_HitsTheBall) {
  const dgd::RoundedSet rod{dgd::Box<double>({1, 0.05, 0.05}), 0.05};
  const dgd::RoundedSet ball = dgd::Sphere(0.2);
  dgd::Motion<double> turn, rest;
  turn.rotation = {0, 0, std::numbers::pi / 2};
  rest.start.translation = {0, 0.8, 0};
  const dgd::TimeOfImpactResult<double> impact = dgd::TimeOfImpact(rod, turn, ball, rest);

  EXPECT_EQ(impact.status, dgd::Status::kTouching);
  EXPECT_NEAR(impact.time, 1 - std::asin(0.3 / 0.8) / (std::numbers::pi / 2), 1e-9);
}

TEST(ReadmeCore, Plane_HasItsOwnSetsAndPoses) {
  const dgd::RoundedSet robot{dgd::Rectangle<double>({0.4, 0.2}), 0.05};
  const dgd::RoundedSet tree = dgd::Circle(0.3);
  dgd::Pose<double, 2> robot_pose, tree_pose;
  robot_pose.rotation = Eigen::Rotation2Dd(std::numbers::pi / 2).toRotationMatrix();
  tree_pose.translation = {0, 1.5};

  const dgd::Result<double, 2> result = dgd::GrowthDistance(robot, robot_pose, tree, tree_pose);
  const dgd::CollisionResult<double, 2> check = dgd::DetectCollision(robot, robot_pose, tree, tree_pose);

  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  EXPECT_NEAR(result.GrowthDistance(), 2, 1e-7);
  EXPECT_NEAR(result.separation, 0.75, 1e-7);
  EXPECT_EQ(check.status, dgd::Status::kSeparated);
}

TEST(ReadmeCore, OwnSet_IsASetAsAnyOther) {
  const dgd::RoundedSet dome{Dome(1), 0.1};
  dgd::Pose<double> pose;
  pose.translation = {0, 0, 3};
  const auto result = dgd::GrowthDistance(dome, dgd::Pose<double>(), dgd::Sphere(0.5), pose);

  // From the centre at 0.375 up: the dome reaches 0.625 + 0.1, the sphere 0.5.
  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  EXPECT_NEAR(result.GrowthDistance(), 2.625 / 1.225, 1e-7);
  EXPECT_NEAR(result.separation, 1.4, 1e-7);
  pose.translation.z() = -2;
  const auto below = dgd::GrowthDistance(dome, dgd::Pose<double>(), dgd::Sphere(0.5), pose);
  EXPECT_NEAR(below.GrowthDistance(), 2.375 / 0.975, 1e-7);
}

TEST(ReadmeCore, OwnVertices_AreFoundAgainByTheWarmStart) {
  const dgd::RoundedSet tetrahedron{Tetrahedron()};
  dgd::Pose<double> pose;
  pose.translation = {3, 3, -3};
  dgd::WarmStart<double> warm_start;
  const auto solve = [&] {
    return dgd::GrowthDistance(tetrahedron, dgd::Pose<double>(), tetrahedron, pose, {}, &warm_start);
  };
  const auto cold = solve();
  // A face, 1 / sqrt(3) from the centre, and a vertex, sqrt(3) from it.
  EXPECT_NEAR(cold.GrowthDistance(), 9 / 4.0, 1e-12);
  EXPECT_GT(warm_start.size, 0);
  EXPECT_LT(solve().iterations, cold.iterations);
}

TEST(ReadmeCore, HalfSpace_IsTheGround) {
  const dgd::RoundedSet box{dgd::Box<double>({0.5, 0.5, 0.5})};
  const dgd::HalfSpace<double> ground;  // z <= 0 in its own frame.
  dgd::Pose<double> box_pose, ground_pose;
  box_pose.translation = {0, 0, 2};
  const dgd::Result<double> result = dgd::GrowthDistance(box, box_pose, ground, ground_pose);

  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  EXPECT_EQ(result.GrowthDistance(), 4);
  EXPECT_EQ(result.separation, 1.5);
}

TEST(ReadmeCore, Observer_PrintsALineForEachIteration) {
  const dgd::RoundedSet set_1{dgd::Cone<double>(0.5, 1)};
  const dgd::RoundedSet set_2{dgd::Ellipsoid<double>({0.2, 0.3, 0.4})};
  const dgd::Pose<double> pose_1;
  dgd::Pose<double> pose_2;
  pose_2.translation = {0.4, 0.9, 0.3};
  testing::internal::CaptureStdout();

  const auto print = [](const dgd::Iterate<double, 3>& iterate) {
    std::printf("%d,%.17g,%.17g\n", iterate.iteration, iterate.lower_bound, iterate.upper_bound);
  };
  const dgd::Result<double> result = dgd::GrowthDistance(set_1, pose_1, set_2, pose_2, {}, nullptr, print);

  std::istringstream printed(testing::internal::GetCapturedStdout());
  int lines = 0;
  for (std::string line; std::getline(printed, line);) {
    ++lines;
    EXPECT_EQ(line.substr(0, line.find(',')), std::to_string(lines));
  }
  EXPECT_EQ(lines, result.iterations);
}

TEST(ReadmeCore, Certificate_HoldsForTheResult) {
  const dgd::RoundedSet set_1{dgd::Cone<double>(0.5, 1)};
  const dgd::RoundedSet set_2{dgd::Ellipsoid<double>({0.2, 0.3, 0.4})};
  const dgd::Pose<double> pose_1;
  dgd::Pose<double> pose_2;
  pose_2.translation = {0.4, 0.9, 0.3};
  const dgd::Result<double> result = dgd::GrowthDistance(set_1, pose_1, set_2, pose_2);

  const dgd::Certificate certificate = dgd::Certify(set_1, pose_1, set_2, pose_2, result);
  const bool holds = certificate.Holds(1e-9, 1e-7);  // Metres, and relative.

  EXPECT_TRUE(holds);
}

// So that the README's code is the code that is compiled and tested here.
TEST(ReadmeCore, Snippets_AreTheseWordForWord) {
  const std::string folder = DGD_TEST_CORE_FOLDER;
  const int snippets = dgd_test::ExpectSnippetsIn(
      folder + "/../../dgd_core/README.md",
      {folder + "/readme/trajectory.cc", folder + "/readme/gradient.cc", folder + "/readme_core_test.cc"});
  EXPECT_EQ(snippets, 12);
}

}  // namespace
