// Motions carried out in this executable's precision of Bullet, against statics, dynamics and kinematics by hand.
#include "simulation/execution.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/arm_world.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

bool IsDouble() { return std::string_view(BulletPrecision()) == "double"; }

// Of the arm's kinematics over about a metre, m.
double Rounding() { return IsDouble() ? 1e-9 : 5e-6; }

MotionScene ShippedScene() {
  return LoadMotionScene(std::filesystem::path(DGD_TEST_SCENES) / "ur5e_five_obstacles.json");
}

MotionScene WithoutObstacles() {
  MotionScene scene = ShippedScene();
  scene.obstacles.clear();
  return scene;
}

Configuration Angles(const std::vector<double>& angles) {
  return Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size()));
}

/// As of an arm on a slanted pedestal.
Pose TiltedBase() {
  return {Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix(), {0.3, -0.2, 0.5}};
}

/// A sweep of the arm, stretched out by half, from left to right.
JointPath Sweep() { return {Angles({0.9, -1.2, 1.6, -1.9, -1.57, 0}), Angles({-0.9, -1.2, 1.6, -1.9, -1.57, 0})}; }

/// Posts that stand in the sweep's way.
MotionScene SceneWithPosts() {
  MotionScene scene = WithoutObstacles();
  for (const double side : {1, -1}) {
    const Pose pose = {Eigen::Matrix3d::Identity(), {0.45, side * 0.3, 0.45}};
    scene.obstacles.push_back({side > 0 ? "left_post" : "right_post", Cylinder{0.05, 0.9}, pose});
  }
  return scene;
}

ExecutionResult Execute(const MotionScene& scene, const JointPath& path, const ExecutionOptions& options = {}) {
  const ExecutionResult result = ExecutePath(scene, TimedPath(scene.PlannedArm(), path), options);
  EXPECT_EQ(result.failure.value_or(""), "");
  return result;
}

bool HasContact(const ExecutionResult& result, const std::string& first, const std::string& second) {
  return std::ranges::any_of(result.contacts, [&](const ExecutionContact& contact) {
    return contact.first == first && contact.second == second;
  });
}

std::string NamesOf(const ExecutionResult& result) {
  std::string names;
  for (const ExecutionContact& contact : result.contacts) names += contact.first + " and " + contact.second + "\n";
  return names;
}

/// What holds the arm up: of each joint, the moment about its axis of all weights beyond it.
Eigen::VectorXd HoldingEfforts(const MotionScene& scene, const Configuration& angles) {
  const Arm& arm = scene.PlannedArm();
  const std::vector<Pose> poses = LinkPoses(arm, angles);
  Eigen::VectorXd efforts = Eigen::VectorXd::Zero(angles.size());
  for (std::size_t joint = 0; joint < arm.joints.size(); ++joint) {
    const Pose& pose = poses[joint + 1];
    for (std::size_t link = joint + 1; link < arm.links.size(); ++link) {
      const Vector3d arm_of_lever = poses[link] * arm.links[link].centre_of_mass - pose.position;
      const Vector3d moment = arm_of_lever.cross(arm.links[link].mass * scene.gravity);
      efforts[static_cast<Eigen::Index>(joint)] -= moment.dot(pose.rotation * arm.joints[joint].axis);
    }
  }
  return efforts;
}

/// A weightless beam's end, say: one link that turns about z, 0.5 m from its axis.
MotionScene OneJointScene() {
  MotionScene scene;
  scene.gravity = Vector3d::Zero();
  Link base, link;
  base.name = "base";
  link.name = "bob";
  link.mass = 2;
  link.centre_of_mass = {0.5, 0, 0};
  SceneArm arm;
  arm.arm = {"pendulum", {}, {base, link}, {{"hinge", {}, Vector3d::UnitZ(), -3, 3, 3, 100}}, {}};
  arm.arm.flange.position = {1, 0, 0};
  arm.rest = Configuration::Zero(1);
  scene.arms.push_back(arm);
  scene.planned_arm = 0;
  scene.start = scene.goal = arm.rest;
  return scene;
}

TEST(ExecutionTest, ArmAtRest_HoldsItsPoseWithTheMomentsOfItsWeights) {
  MotionScene scene = WithoutObstacles();
  scene.arms[0].arm.base = TiltedBase();
  for (const Configuration& pose : {Angles({0, 0, 0, 0, 0, 0}), Angles({0.3, -1.1, 1.7, -0.9, 0.6, 0.4})}) {
    ExecutionOptions options;
    options.hold_time = 2;
    const ExecutionResult result = Execute(scene, {pose}, options);
    EXPECT_EQ(result.steps.size(), 480U);
    EXPECT_LE(result.greatest_error, IsDouble() ? 1e-6 : 5e-6);
    const Eigen::VectorXd difference = result.steps.back().efforts - HoldingEfforts(scene, pose);
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), IsDouble() ? 1e-4 : 0.05) << difference.transpose();
    EXPECT_GT(HoldingEfforts(scene, pose).cwiseAbs().maxCoeff(), 10);
    EXPECT_EQ(NamesOf(result), "");
  }
}

TEST(ExecutionTest, FlangeAndLinks_AreWhereKinematicsSays) {
  MotionScene scene = WithoutObstacles();
  scene.arms[0].arm.base = TiltedBase();
  for (Link& link : scene.arms[0].arm.links) link.shapes.clear();  // Nothing collides.
  const Arm& arm = scene.PlannedArm();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int run = 0; run < 20; ++run) {
    Configuration pose(6);
    for (double& q : pose) q = angle(random);
    ArmWorld world(scene, pose, {});
    world.Step(pose, pose);
    // Within roundoff, the motors leave the angles as they are.
    const Configuration angles = world.JointAngles();
    EXPECT_LE((angles - pose).norm(), 1e-4);
    EXPECT_LE((world.FlangePoseNow().position - FlangePose(arm, angles).position).norm(), Rounding());
    const std::vector<Pose> links = world.LinkPosesNow(), expected = LinkPoses(arm, angles);
    ASSERT_EQ(links.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LE((links[i].position - expected[i].position).norm(), Rounding()) << i;
      EXPECT_LE((links[i].rotation - expected[i].rotation).norm(), Rounding()) << i;
    }
  }
}

TEST(ExecutionTest, MotionInFreeSpace_IsTracked) {
  const MotionScene scene = WithoutObstacles();
  const JointPath path = {Sweep().front(), Angles({0, -1.8, 2.1, -1.9, -0.6, 1}), Sweep().back()};
  for (const double rate : {60.0, 240.0}) {
    ExecutionOptions options;
    options.step_rate = rate;
    const ExecutionResult result = Execute(scene, path, options);
    EXPECT_LE(result.greatest_error, IsDouble() ? 1e-6 : 1e-5) << rate;
    EXPECT_LE(result.rms_error, result.greatest_error);
    EXPECT_LE((result.steps.back().flange - FlangePose(scene.PlannedArm(), path.back()).position).norm(), 1e-5);
    EXPECT_LT(result.greatest_effort_share, 0.5);
    EXPECT_LE(result.greatest_velocity_share, 1 + 1e-5);
    EXPECT_EQ(NamesOf(result), "");
    EXPECT_NEAR(result.duration, TimedPath(scene.PlannedArm(), path).Duration() + 0.5, 1 / rate);
  }
}

// Around the posts, under the shelf and past the block; 5 cm away from them.
TEST(ExecutionTest, MotionBetweenTheShippedObstacles_TouchesNothing) {
  const MotionScene scene = ShippedScene();
  const JointPath path = {Angles({-1.3, -1.2, 1.6, -1.97, -1.57, 0}), Angles({-1.3, -1.79, 2.04, -1.91, -2.2, -0.81}),
                          Angles({-0.48, -2.02, 2.25, -2.08, -2.25, -1}), Angles({-0.1, -1.2, 1.6, -1.97, -1.57, 0})};
  for (const double rate : {60.0, 240.0}) {
    ExecutionOptions options;
    options.step_rate = rate;
    const ExecutionResult result = Execute(scene, path, options);
    EXPECT_EQ(NamesOf(result), "");
    EXPECT_LT(result.greatest_error, 1e-5);
    EXPECT_LT((result.steps.back().flange - FlangePose(scene.PlannedArm(), path.back()).position).norm(), 1e-5);
  }
}

// As timed_path.h says of the default acceleration.
TEST(ExecutionTest, DefaultAcceleration_NeedsLessThanTwoThirdsOfAStretchedArmsEffort) {
  const MotionScene scene = WithoutObstacles();
  const ExecutionResult result = Execute(scene, {Angles({0, 0, 0, 0, 0, 0}), Angles({0, -0.5, 0, 0, 0, 0})});
  EXPECT_EQ(result.greatest_effort_joint, "shoulder_lift");
  EXPECT_LT(result.greatest_effort_share, 2.0 / 3);
  EXPECT_GT(result.greatest_effort_share, 0.4);
}

TEST(ExecutionTest, MotorsTooWeak_FallBehind) {
  MotionScene scene = WithoutObstacles();
  for (Joint& joint : scene.arms[0].arm.joints) joint.max_effort /= 5;
  const ExecutionResult result = Execute(scene, {Angles({0, 0, 0, 0, 0, 0}), Angles({0, -0.5, 0, 0, 0, 0})});
  EXPECT_GT(result.greatest_error, 0.01);
  EXPECT_NEAR(result.greatest_effort_share, 1, 1e-5);
  EXPECT_EQ(result.greatest_effort_joint, "shoulder_lift");
}

// It lags while it speeds up with half the effort it needs, and would have to exceed the limit to be quick again.
TEST(ExecutionTest, ArmThatCatchesUp_StaysWithinItsVelocity) {
  MotionScene scene = OneJointScene();
  Joint& joint = scene.arms[0].arm.joints[0];
  joint.max_velocity = 0.8;
  joint.max_effort = 1.25;
  ExecutionOptions options;
  options.hold_time = 0;
  const ExecutionResult result = Execute(scene, {Angles({0}), Angles({2})}, options);
  EXPECT_GT(result.greatest_error, 0.01);
  EXPECT_LE(result.greatest_velocity_share, 1 + 1e-5);
  EXPECT_GT(result.greatest_velocity_share, 0.99);
}

// Torque is inertia times angular acceleration, with the parallel axes' part; the flange's error is then rounding.
TEST(ExecutionTest, SpeedingUp_NeedsTheEffortOfTheInertia) {
  constexpr double kAcceleration = 5;  // TimingOptions' default, as this motion is too short for the velocity limit.
  struct Case {
    std::optional<Vector3d> inertia;
    std::vector<LinkShape> shapes;
    double about_z;  // Through the centre of mass, kg m^2.
  };
  const LinkShape box = {Box{{0.3, 0.2, 0.1}}, {Eigen::Matrix3d::Identity(), {0.5, 0, 0}}};
  const std::vector<Case> cases = {{Vector3d(0.1, 0.2, 0.3), {}, 0.3},
                                   {std::nullopt, {box}, 2 * (0.36 + 0.16) / 12},
                                   {std::nullopt, {}, 0.4 * 2 * 0.05 * 0.05}};
  for (const Case& c : cases) {
    MotionScene scene = OneJointScene();
    scene.arms[0].arm.links[1].inertia = c.inertia;
    scene.arms[0].arm.links[1].shapes = c.shapes;
    const ExecutionResult result = Execute(scene, {Angles({0}), Angles({1})});
    const double expected = (c.about_z + 2 * 0.5 * 0.5) * kAcceleration;
    const double half_time = std::sqrt(1 / kAcceleration);
    // Bullet's velocities are those of the middle of a step, so that the first takes only half of the acceleration.
    EXPECT_NEAR(result.steps[0].efforts[0], expected / 2, 1e-3 * expected);
    for (std::size_t i = 1; result.steps[i].time <= half_time; ++i) {
      const ExecutionStep& step = result.steps[i];
      EXPECT_NEAR(step.efforts[0], expected, (IsDouble() ? 1e-6 : 1e-3) * expected) << step.time;
    }
  }
}

TEST(ExecutionTest, ObstacleInTheWay_IsReportedByName) {
  const ExecutionResult result = Execute(SceneWithPosts(), Sweep());
  EXPECT_TRUE(HasContact(result, "wrist_1", "left_post")) << NamesOf(result);
  EXPECT_GT(result.greatest_error, 0.01);
  for (const ExecutionContact& contact : result.contacts) {
    EXPECT_TRUE(contact.second.ends_with("post")) << contact.second;
    EXPECT_LE(contact.begin, contact.end);
    EXPECT_GT(contact.greatest_force, 0);
    EXPECT_LT(contact.least_distance, 1e-4);
    EXPECT_GT(contact.least_distance, -0.01) << "went through";
  }
  EXPECT_TRUE(std::ranges::any_of(result.steps, [](const ExecutionStep& step) { return step.contacts > 0; }));
  EXPECT_EQ(result.steps.front().contacts, 0);
}

// It begins within a step of when geometry says they meet: the bob's ball turns into a wall.
TEST(ExecutionTest, ContactBegins_WhenTheShapesMeet) {
  MotionScene scene = OneJointScene();
  scene.arms[0].arm.links[1].shapes = {{Sphere{0.1}, {Eigen::Matrix3d::Identity(), {0.5, 0, 0}}}};
  scene.obstacles.push_back({"wall", Box{{0.5, 0.1, 0.5}}, {Eigen::Matrix3d::Identity(), {0.5, 0.5, 0}}});
  const TimedPath path(scene.PlannedArm(), {Angles({0}), Angles({1.5})});
  const ExecutionResult result = ExecutePath(scene, path);
  ASSERT_TRUE(HasContact(result, "bob", "wall"));
  // Where the ball's centre is its radius below the wall, 0.3 m from the axis.
  const double begin = result.contacts[0].begin, step = 1 / ExecutionOptions().step_rate;
  EXPECT_LE(0.5 * std::sin(path.Sample(begin - step).angles[0]), 0.3);
  EXPECT_GE(0.5 * std::sin(path.Sample(begin + step).angles[0]), 0.3);
  EXPECT_NEAR(0.5 * std::sin(result.steps.back().angles[0]), 0.3, 0.005) << "the wall holds";
}

// Within a hundredth of a millimetre on either side.
TEST(ExecutionTest, MotionThatEndsJustBeforeAnObstacle_IsNoContact) {
  constexpr double kGap = 1e-5;  // m
  MotionScene scene = OneJointScene();
  scene.arms[0].arm.links[1].shapes = {{Sphere{0.1}, {Eigen::Matrix3d::Identity(), {0.5, 0, 0}}}};
  scene.obstacles.push_back({"wall", Box{{0.5, 0.1, 0.5}}, {Eigen::Matrix3d::Identity(), {0.5, 0.5, 0}}});
  EXPECT_EQ(NamesOf(Execute(scene, {Angles({0}), Angles({std::asin(0.6 - kGap / 0.5)})})), "");
  EXPECT_EQ(NamesOf(Execute(scene, {Angles({0}), Angles({std::asin(0.6 + kGap / 0.5)})})), "bob and wall\n");
}

// Their bounding boxes overlap, so that Bullet has contact points for them, whose distance is that of the surfaces.
TEST(ExecutionTest, BodiesNearEachOther_AreNoContact) {
  MotionScene scene = OneJointScene();
  const Eigen::Matrix3d slant = Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitX()).toRotationMatrix();
  scene.arms[0].arm.links[1].shapes = {{Capsule{0.1, 0.4}, {slant, {0.5, 0, 0}}}};
  for (const double gap : {0.001, -0.001}) {
    const Vector3d place = Vector3d(0.5, 0, 0) + (0.2 + gap) * slant.col(1);
    scene.obstacles = {{"ball", Sphere{0.1}, {Eigen::Matrix3d::Identity(), place}}};
    EXPECT_EQ(NamesOf(Execute(scene, {Angles({0})})), gap > 0 ? "" : "bob and ball\n");
  }
}

TEST(ExecutionTest, UncheckedPairsAndNeighbours_GoThroughEachOther) {
  MotionScene scene = WithoutObstacles();
  const Configuration pose = Sweep().front();
  const Pose forearm = LinkPoses(scene.PlannedArm(), pose)[3];
  scene.obstacles.push_back({"cage", Box{{0.05, 0.05, 0.05}}, {forearm.rotation, forearm * Vector3d(0, 0, 0.2)}});
  EXPECT_EQ(NamesOf(Execute(scene, {pose})), "forearm and cage\n");
  scene.arms[0].unchecked.emplace_back("forearm", "cage");
  EXPECT_EQ(NamesOf(Execute(scene, {pose})), "");
}

// As a pedestal in a floor does.
TEST(ExecutionTest, BaseInAnObstacle_IsNoContact) {
  MotionScene scene = OneJointScene();
  scene.arms[0].arm.links[0].shapes = {{Box{{0.1, 0.1, 0.1}}, {}}};
  scene.obstacles.push_back({"floor", Box{{1, 1, 0.1}}, {Eigen::Matrix3d::Identity(), {0, 0, -0.15}}});
  EXPECT_EQ(NamesOf(Execute(scene, {Angles({0})})), "");
}

TEST(ExecutionTest, ArmFoldedIntoItself_ReportsItsLinks) {
  const MotionScene scene = WithoutObstacles();
  const ExecutionResult result = Execute(scene, {Angles({0, -1.5, 2, 0, 0, 0}), Angles({0, -1.5, 3.1, -1.5, -1.5, 0})});
  ASSERT_FALSE(result.contacts.empty());
  for (const ExecutionContact& contact : result.contacts) {
    const std::vector<Link>& links = scene.PlannedArm().links;
    const auto place = [&](const std::string& name) { return std::ranges::find(links, name, &Link::name); };
    ASSERT_NE(place(contact.second), links.end());
    EXPECT_GE(place(contact.second) - place(contact.first), 2) << NamesOf(result);
  }
}

TEST(ExecutionTest, OtherArm_IsAnObstacle) {
  MotionScene scene = WithoutObstacles();
  SceneArm other = scene.arms[0];
  other.arm.name = "other";
  other.arm.base.position = {0, 0.6, 0};
  other.rest = Angles({0, -1.57, 0, 0, 0, 0});
  scene.arms.insert(scene.arms.begin(), other);
  scene.planned_arm = 1;
  const ExecutionResult result = Execute(scene, {Angles({0, -0.5, 0, 0, 0, 0}), Angles({1.6, -0.5, 0, 0, 0, 0})});
  ASSERT_FALSE(result.contacts.empty());
  for (const ExecutionContact& contact : result.contacts) EXPECT_EQ(contact.second.rfind("other's ", 0), 0U);
}

TEST(ExecutionTest, Steps_HaveTheirTimesAndThePlannedAngles) {
  const MotionScene scene = WithoutObstacles();
  const ExecutionOptions options;
  double done = 0;
  const TimedPath path(scene.PlannedArm(), Sweep());
  const ExecutionResult result = ExecutePath(scene, path, options, [&](double share) { done = share; });
  EXPECT_EQ(done, 1);
  ASSERT_GE(static_cast<double>(result.steps.size()), (path.Duration() + options.hold_time) * options.step_rate);
  for (std::size_t i = 0; i < result.steps.size(); ++i) {
    const ExecutionStep& step = result.steps[i];
    EXPECT_NEAR(step.time, static_cast<double>(i + 1) / options.step_rate, 1e-12);
    EXPECT_EQ(step.planned, path.Sample(step.time).angles);
    EXPECT_LE((step.flange - FlangePose(scene.PlannedArm(), step.planned).position).norm(), 1e-5);
  }
}

TEST(ExecutionTest, SameMotionTwice_IsTheSameToTheBit) {
  const ExecutionResult first = Execute(SceneWithPosts(), Sweep());
  const ExecutionResult second = Execute(SceneWithPosts(), Sweep());
  ASSERT_EQ(first.steps.size(), second.steps.size());
  for (std::size_t i = 0; i < first.steps.size(); ++i) ASSERT_EQ(first.steps[i].angles, second.steps[i].angles);
}

TEST(ExecutionTest, OptionsOutOfRange_Throw) {
  const MotionScene scene = OneJointScene();
  const TimedPath path(scene.PlannedArm(), {Angles({0})});
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const ExecutionOptions& options :
       {ExecutionOptions{.step_rate = 0}, ExecutionOptions{.step_rate = kNan}, ExecutionOptions{.hold_time = -1},
        ExecutionOptions{.position_gain = 0}, ExecutionOptions{.position_gain = 1.1},
        ExecutionOptions{.solver_iterations = 0}}) {
    EXPECT_THROW(ExecutePath(scene, path, options), std::invalid_argument);
  }
}

}  // namespace
}  // namespace dgd_demos
