// Contract of LoadMotionScene: a good file becomes the scene it describes; a bad one gives a sentence with the file's
// name, the place in it, and the value, and names the joint or body it is about.
#include "motion/motion_scene.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "motion/motion_checks.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

TEST(MotionSceneTest, ValidFile_IsReadAsWritten) {
  const TestFolder folder;
  const MotionScene scene = LoadMotionScene(folder.Write("arm.json", SmallMotionSceneText()));
  EXPECT_EQ(scene.gravity, Eigen::Vector3d(0, 0, -9.81));
  const Arm& arm = scene.PlannedArm();
  EXPECT_EQ(arm.name, "planar");
  ASSERT_EQ(arm.links.size(), 3u);
  ASSERT_EQ(arm.joints.size(), 2u);
  EXPECT_EQ(arm.joints[1].name, "elbow");
  EXPECT_EQ(arm.joints[1].origin.position, Eigen::Vector3d(0.4, 0, 0));
  EXPECT_EQ(arm.joints[1].axis, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(arm.joints[1].lower, -2.5);
  EXPECT_EQ(arm.joints[1].upper, 2.5);
  EXPECT_EQ(arm.joints[1].max_velocity, 2);
  EXPECT_EQ(arm.joints[1].max_effort, 5);
  EXPECT_EQ(arm.links[2].mass, 1);
  EXPECT_EQ(arm.links[2].inertia, Eigen::Vector3d(0.01, 0.02, 0.02));
  EXPECT_FALSE(arm.links[1].inertia.has_value());
  EXPECT_EQ(std::get<Capsule>(arm.links[2].shapes.at(0).shape).length, 0.3);
  EXPECT_EQ(scene.obstacles.at(0).name, "post");
  EXPECT_EQ(scene.start, Eigen::Vector2d(-0.5, 0.1));
  EXPECT_EQ(scene.goal, Eigen::Vector2d(1.5, 0.1));
  EXPECT_EQ(scene.search_lower, Eigen::Vector2d(-3, -2.5));
  EXPECT_EQ(scene.arms[0].rest, Eigen::Vector2d(0, 0));
  EXPECT_NEAR((FlangePose(arm, Eigen::Vector2d(0, 0)).position - Eigen::Vector3d(0.8, 0, 0.1)).norm(), 0, 1e-15);
}

TEST(MotionSceneTest, Search_NarrowsSomeJoints) {
  const TestFolder folder;
  const MotionScene scene = LoadMotionScene(folder.Write(
      "arm.json", With(SmallMotionSceneText(), R"("plan": {)", R"("plan": { "search": { "elbow": [-1, 2] },)")));
  EXPECT_EQ(scene.search_lower, Eigen::Vector2d(-3, -1));
  EXPECT_EQ(scene.search_upper, Eigen::Vector2d(3, 2));
}

TEST(MotionSceneTest, SecondArm_StandsAtItsRest) {
  const TestFolder folder;
  std::string text = SmallMotionSceneText();
  const std::size_t begin = text.find("    {\n      \"name\": \"planar\""), end = text.find("  ],\n  \"obstacles\"");
  std::string second = With(text.substr(begin, end - begin), "\"planar\"", "\"other\"");
  second = With(second, R"("flange")", R"("rest": { "shoulder": 0.5, "elbow": -0.5 }, "flange")");
  text.insert(end - 1, ",\n" + second);
  const MotionScene scene = LoadMotionScene(folder.Write("arms.json", text));
  ASSERT_EQ(scene.arms.size(), 2u);
  EXPECT_EQ(scene.planned_arm, 0u);
  EXPECT_EQ(scene.arms[1].rest, Eigen::Vector2d(0.5, -0.5));
}

// One slip in a valid file, and what the complaint must say.
struct Slip {
  const char* name;
  const char* old_part;
  const char* new_part;
  const char* complaint;
};
void PrintTo(const Slip& slip, std::ostream* stream) { *stream << slip.name; }

class MotionSceneSlipTest : public testing::TestWithParam<Slip> {};

TEST_P(MotionSceneSlipTest, Complaint_NamesFilePlaceAndValue) {
  const TestFolder folder;
  const Slip& slip = GetParam();
  try {
    LoadMotionScene(folder.Write("broken.json", With(SmallMotionSceneText(), slip.old_part, slip.new_part)));
    FAIL() << "no complaint";
  } catch (const SceneError& error) {
    const std::string complaint = error.what();
    EXPECT_NE(complaint.find("broken.json: "), std::string::npos) << complaint;
    EXPECT_NE(complaint.find(slip.complaint), std::string::npos) << complaint;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, MotionSceneSlipTest,
    testing::Values(
        Slip{"BeyondALimit", R"("shoulder": 1.5)", R"("shoulder": 3.5)",
             "/plan/goal/shoulder: exceeds the limits of joint shoulder, -3 to 3 rad, with 3.5"},
        Slip{"UnknownJoint", R"("goal": { "shoulder": 1.5, "elbow")", R"("goal": { "shoulder": 1.5, "elbw")",
             "/plan/goal/elbw: the arm planar has no joint \"elbw\"; its joints: shoulder, elbow"},
        Slip{"MissingJoint", R"("start": { "shoulder": -0.5, "elbow": 0.1 })", R"("start": { "shoulder": -0.5 })",
             "/plan/start/elbow: is missing"},
        Slip{"UnknownArm", R"("arm": "planar")", R"("arm": "planer")", "/plan/arm: there is no arm \"planer\""},
        Slip{"UnknownKey", R"("gravity")", R"("gravitation": 1, "gravity")", "/gravitation: is not a known key"},
        Slip{"TwoLinksOfOneName", R"("name": "lower")", R"("name": "upper")",
             "/arms/0/links/2/name: is the name of an earlier one"},
        Slip{"AxisZero", R"("axis": [0, 0, 1])", R"("axis": [0, 0, 0])",
             "/arms/0/links/1/joint/axis: must be a direction, not [0,0,0]"},
        Slip{"LimitsReversed", R"("lower": -3, "upper": 3)", R"("lower": 3, "upper": -3)",
             "/arms/0/links/1/joint/upper: must be above 3"},
        Slip{"NoMass", R"("name": "upper", "mass": 1)", R"("name": "upper", "mass": 0)",
             "/arms/0/links/1/mass: must be above 0"},
        Slip{"UnknownShape", R"("type": "cylinder")", R"("type": "cube")",
             "/obstacles/0/type: must be sphere, capsule, box, cylinder, cone or mesh, not \"cube\""},
        Slip{"SearchLeavesOutTheStart", R"("plan": {)", R"("plan": { "search": { "elbow": [0.2, 2] },)",
             "/plan/search/elbow: must hold start and goal of joint elbow"},
        Slip{"UncheckedUnknownLink", R"("flange")", R"("unchecked": [["hand", "post"]], "flange")",
             "/arms/0/unchecked/0/0: the arm planar has no link \"hand\""},
        Slip{"UncheckedUnknownObstacle", R"("flange")", R"("unchecked": [["upper", "pole"]], "flange")",
             "/arms/0/unchecked/0/1: there is no link of the arm planar and no obstacle \"pole\""},
        Slip{"NotJson", R"("gravity": [)", R"("gravity" [)", "line 3, column"}),
    [](const auto& slip) { return slip.param.name; });

}  // namespace
}  // namespace dgd_demos
