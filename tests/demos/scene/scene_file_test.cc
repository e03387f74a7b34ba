// Contract of LoadScene: a good file becomes the scene it describes; a bad one gives a sentence with the file's name,
// the JSON path and the offending value, or line and column where it is not even JSON.
#include "scene/scene_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "small_scenes.h"

namespace dgd_demos {
namespace {

// What LoadScene says about a file with this text.
std::string ComplaintAbout(const std::string& text) {
  const TestFolder folder;
  try {
    LoadScene(folder.Write("broken.json", text));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

std::string Replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t place = text.find(old_part);
  EXPECT_NE(place, std::string::npos) << old_part;
  return text.replace(place, old_part.size(), new_part);
}

TEST(SceneFileTest, ValidFile_IsReadAsWritten) {
  const TestFolder folder;
  const Scene scene = LoadScene(folder.Write("scene.json", ValidSceneText()));
  EXPECT_EQ(scene.gravity, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_EQ(scene.time_step, 0.004);
  EXPECT_EQ(scene.duration, 0.2);
  EXPECT_EQ(scene.margin, 0.04);
  EXPECT_EQ(scene.ground.half_extents, Eigen::Vector3d(5, 5, 0.5));
  EXPECT_EQ(scene.snapshots, (std::vector<double>{0, 0.1}));
  ASSERT_EQ(scene.bodies.size(), 1u);
  const auto& body = std::get<SingleBody>(scene.bodies[0]);
  EXPECT_EQ(std::get<Box>(body.shape).half_extents, Eigen::Vector3d(0.5, 0.4, 0.3));
  EXPECT_EQ(body.properties.mass, 2);
  EXPECT_EQ(body.properties.friction, 0.5);
  EXPECT_FALSE(body.properties.inertia.has_value());
  EXPECT_EQ(body.pose.position, Eigen::Vector3d(0, 0, 1));
  // Turned by 0.5 about z.
  EXPECT_NEAR(body.pose.rotation(1, 0), std::sin(0.5), 1e-15);
  EXPECT_NEAR(body.pose.rotation(2, 2), 1, 1e-15);
}

TEST(SceneFileTest, WhatIsOptional_IsReadAsWritten) {
  const TestFolder folder;
  const Scene still = LoadScene(folder.Write("still.json", ValidSceneText()));
  EXPECT_TRUE(still.sleeping);
  EXPECT_EQ(still.solver.iterations, 10);
  EXPECT_EQ(still.solver.friction_directions, 1);
  EXPECT_TRUE(std::get<SingleBody>(still.bodies[0]).motion.velocity.isZero(0));
  EXPECT_TRUE(std::get<SingleBody>(still.bodies[0]).motion.angular_velocity.isZero(0));

  std::string text =
      Replaced(ValidSceneText(), R"("bodies")",
               R"("sleeping": false, "solver": { "iterations": 50, "friction_directions": 2 }, "bodies")");
  text = Replaced(text, R"("mass": 2)",
                  R"("mass": 2, "damping": 0.3, "velocity": [1, 2, -3], "angular_velocity": [0, 0, 4])");
  const Scene scene = LoadScene(folder.Write("scene.json", text));
  EXPECT_FALSE(scene.sleeping);
  EXPECT_EQ(scene.solver.iterations, 50);
  EXPECT_EQ(scene.solver.friction_directions, 2);
  EXPECT_EQ(std::get<SingleBody>(scene.bodies[0]).properties.damping, 0.3);
  EXPECT_EQ(std::get<SingleBody>(scene.bodies[0]).motion.velocity, Eigen::Vector3d(1, 2, -3));
  EXPECT_EQ(std::get<SingleBody>(scene.bodies[0]).motion.angular_velocity, Eigen::Vector3d(0, 0, 4));

  const Scene fixed =
      LoadScene(folder.Write("static.json", Replaced(ValidSceneText(), R"("mass": 2)", R"("mass": 0)")));
  EXPECT_EQ(std::get<SingleBody>(fixed.bodies[0]).properties.mass, 0);
}

TEST(SceneFileTest, ShippedScenes_AreValid) {
  const std::vector<std::filesystem::path> scenes = SimulatedScenes(DGD_TEST_SCENES);
  for (const std::filesystem::path& scene : scenes) EXPECT_NO_THROW(LoadScene(scene)) << scene;
  EXPECT_GE(scenes.size(), 2u) << "is " << DGD_TEST_SCENES << " the right folder?";
}

TEST(SceneFileTest, MeshFile_IsConvexifiedScaledAndCentred) {
  const TestFolder folder;
  folder.Write("cube.obj",
               "v 1 1 1\nv 3 1 1\nv 1 3 1\nv 3 3 1\nv 1 1 3\nv 3 1 3\nv 1 3 3\nv 3 3 3\nv 2 2 2\n"
               "f 1 2 4\nf 5 6 8\nf 5 7 8\nf 1 3 9\n");
  const std::string text = Replaced(ValidSceneText(), R"("type": "box", "half_extents": [0.5, 0.4, 0.3])",
                                    R"("type": "mesh", "file": "cube.obj", "scale": 0.1)");
  const Scene scene = LoadScene(folder.Write("scene.json", text));
  const Polyhedron& hull = std::get<Hull>(std::get<SingleBody>(scene.bodies[0]).shape).polyhedron;
  ASSERT_EQ(hull.vertices.size(), 8u);  // The point in the middle is no vertex of the hull.
  for (const Eigen::Vector3d& vertex : hull.vertices) {
    EXPECT_NEAR(vertex.cwiseAbs().minCoeff(), 0.1, 1e-6);
    EXPECT_NEAR(vertex.cwiseAbs().maxCoeff(), 0.1, 1e-6);
  }
}

// One slip in a valid file, and what the complaint must name.
struct Slip {
  const char* name;
  const char* old_part;
  const char* new_part;
  std::vector<std::string> named;

  // Instead of GoogleTest's dump of the bytes, which have addresses and would differ from run to run.
  friend void PrintTo(const Slip& slip, std::ostream* stream) { *stream << slip.new_part; }
};

class SceneFileSlipTest : public testing::TestWithParam<Slip> {};

TEST_P(SceneFileSlipTest, IsNamedByFilePathAndValue) {
  const std::string complaint = ComplaintAbout(Replaced(ValidSceneText(), GetParam().old_part, GetParam().new_part));
  EXPECT_NE(complaint.find("broken.json"), std::string::npos) << complaint;
  for (const std::string& part : GetParam().named) EXPECT_NE(complaint.find(part), std::string::npos) << complaint;
}

// A group of polytopes in place of the box, with one value left open.
const std::string kBox =
    R"({ "type": "box", "half_extents": [0.5, 0.4, 0.3], "mass": 2, "position": [0, 0, 1], "rotation": [0, 0, 0.5] })";

const Slip kSlips[] = {
    {"MissingKey", R"("margin": 0.04,)", "", {": /margin: is missing"}},
    {"UnknownKey", R"("margin")", R"("margins": 1, "margin")", {": /margins: ", "not a known key", "1"}},
    {"UnknownKeyInBody", R"("mass": 2)", R"("mass": 2, "colour": "red")", {": /bodies/0/colour: ", "\"red\""}},
    {"WrongType", "0.004", "\"fast\"", {": /time_step: must be a number, not \"fast\""}},
    {"NullValue", "0.004", "null", {": /time_step: ", "null"}},
    {"ZeroTimeStep", "0.004", "0", {": /time_step: must be above 0", "not 0"}},
    {"NegativeTimeStep", "0.004", "-0.1", {": /time_step: ", "-0.1"}},
    {"HugeTimeStep", "0.004", "4", {": /time_step: ", "up to 0.1", "not 4"}},
    {"DurationBelowTimeStep", "0.2,", "0.001,", {": /duration: ", "0.001"}},
    {"NegativeMargin", "0.04", "-0.04", {": /margin: ", "-0.04"}},
    {"NegativeSize", "0.4, 0.3", "-0.4, 0.3", {": /bodies/0/half_extents/1: ", "-0.4"}},
    {"ZeroSize", "0.4, 0.3", "0, 0.3", {": /bodies/0/half_extents/1: must be above 0", "not 0"}},
    {"TwoNumbersForThree", "[0.5, 0.4, 0.3]", "[0.5, 0.4]", {": /bodies/0/half_extents: ", "[0.5,0.4]"}},
    {"NegativeMass", R"("mass": 2)", R"("mass": -2)", {": /bodies/0/mass: ", "-2"}},
    {"VelocityOfAStaticBody",
     R"("mass": 2)",
     R"("mass": 0, "velocity": [1, 0, 0])",
     {": /bodies/0/velocity: ", "mass 0", "[1,0,0]"}},
    {"HugeVelocity", R"("mass": 2)", R"("mass": 2, "velocity": [0, 1e4, 0])", {": /bodies/0/velocity/1: ", "10000"}},
    {"HugeAngularVelocity",
     R"("mass": 2)",
     R"("mass": 2, "angular_velocity": [0, 0, -1e4])",
     {": /bodies/0/angular_velocity/2: ", "-10000"}},
    {"NoSolverIterations",
     R"("bodies")",
     R"("solver": { "iterations": 0 }, "bodies")",
     {": /solver/iterations: must be from 1 up to 10000, not 0"}},
    {"ThreeFrictionDirections",
     R"("bodies")",
     R"("solver": { "friction_directions": 3 }, "bodies")",
     {": /solver/friction_directions: must be from 1 up to 2, not 3"}},
    {"UnknownKeyInSolver",
     R"("bodies")",
     R"("solver": { "erp": 1 }, "bodies")",
     {": /solver/erp: ", "not a known key"}},
    {"NumberForTruth", R"("bodies")", R"("sleeping": 0, "bodies")", {": /sleeping: must be true or false, not 0"}},
    {"HugeDamping", R"("mass": 2)", R"("mass": 2, "damping": 2)", {": /bodies/0/damping: must be from 0 up to 1", "2"}},
    {"NegativeInertia", R"("mass": 2)", R"("mass": 2, "inertia": [1, 1, -1])", {": /bodies/0/inertia/2: ", "-1"}},
    {"DegreesForRadians", "0, 0.5]", "0, 90]", {": /bodies/0/rotation/2: ", "90"}},
    {"UnknownType", R"("box")", R"("teapot")", {": /bodies/0/type: ", "\"teapot\""}},
    {"BodyIsNoObject", kBox.c_str(), "7", {": /bodies/0: must be an object, not 7"}},
    {"NoBodies", kBox.c_str(), "", {": /bodies: ", "[]"}},
    {"SnapshotAfterTheEnd", "[0, 0.1]", "[0, 0.3]", {": /snapshots/1: ", "0.3"}},
    {"SnapshotsOutOfOrder", "[0, 0.1]", "[0.1, 0]", {": /snapshots/1: ", "not 0"}},
    {"MissingMesh",
     R"("type": "box", "half_extents": [0.5, 0.4, 0.3])",
     R"("type": "mesh", "file": "nowhere.obj")",
     {": /bodies/0/file: ", "nowhere.obj"}},
    {"NotANumber", "0.004", "NaN", {"line 4, column 16: ", "invalid literal", "N"}},
    {"NumberOverflow", "0.004", "1e999", {"line 4, column 20: ", "number overflow", "1e999"}},
    {"MissingComma", "0.004,", "0.004", {"line 5, column 12: ", "expected '}'"}},
    {"KeyTwice", R"("margin")", R"("margin": 0.01, "margin")", {"\"margin\"", "twice"}},
};

INSTANTIATE_TEST_SUITE_P(Box, SceneFileSlipTest, testing::ValuesIn(kSlips),
                         [](const testing::TestParamInfo<Slip>& slip) { return std::string(slip.param.name); });

// The same for a group of random polytopes.
class PolytopeGroupSlipTest : public testing::TestWithParam<Slip> {};

TEST_P(PolytopeGroupSlipTest, IsNamedByFilePathAndValue) {
  const std::string group =
      R"({ "type": "random_polytopes", "count": 3, "vertices": { "min": 8, "max": 20 }, "diameter": 1,
           "region": { "min": [-1, -1, 1], "max": [1, 1, 4] }, "mass": 1 })";
  const std::string text = Replaced(ValidSceneText(), kBox, group);
  ASSERT_EQ(ComplaintAbout(text), "no complaint");
  const std::string complaint = ComplaintAbout(Replaced(text, GetParam().old_part, GetParam().new_part));
  EXPECT_NE(complaint.find("broken.json: /bodies/0"), std::string::npos) << complaint;
  for (const std::string& part : GetParam().named) EXPECT_NE(complaint.find(part), std::string::npos) << complaint;
}

const Slip kPolytopeSlips[] = {
    {"TooFewVertices", R"("min": 8)", R"("min": 3)", {"/vertices/min: must be from 4", "not 3"}},
    {"MaxBelowMin", R"("max": 20)", R"("max": 7)", {"/vertices/max: must be from 8", "not 7"}},
    {"FractionOfAVertex", R"("min": 8)", R"("min": 8.5)", {"/vertices/min: must be an integer", "8.5"}},
    {"StaticPolytopes", R"("mass": 1)", R"("mass": 0)", {"/mass: must be above 0", "not 0"}},
    {"ZeroCount", R"("count": 3)", R"("count": 0)", {"/count: ", "not 0"}},
    {"NegativeDiameter", R"("diameter": 1)", R"("diameter": -1)", {"/diameter: ", "-1"}},
    {"RegionInsideOut", R"("max": [1, 1, 4])", R"("max": [1, 1, 0])", {"/region: ", "[1,1,0]"}},
    {"PositionOfAGroup", R"("mass": 1)", R"("mass": 1, "position": [0, 0, 1])", {"/position: ", "not a known key"}},
};

INSTANTIATE_TEST_SUITE_P(Polytopes, PolytopeGroupSlipTest, testing::ValuesIn(kPolytopeSlips),
                         [](const testing::TestParamInfo<Slip>& slip) { return std::string(slip.param.name); });

TEST(SceneFileTest, MissingFile_IsNamed) {
  try {
    LoadScene("nowhere/scene.json");
    FAIL() << "no complaint";
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "nowhere/scene.json: cannot be opened: No such file or directory");
  }
}

TEST(SceneFileTest, FolderForFile_IsNamed) {
  const TestFolder folder;
  EXPECT_THROW(LoadScene(folder.path()), SceneError);
}

}  // namespace
}  // namespace dgd_demos
