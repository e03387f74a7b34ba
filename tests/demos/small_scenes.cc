#include "small_scenes.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

Scene EmptyScene(double duration) {
  Scene scene;
  scene.file = "a scene of the tests";
  scene.about = "SI units, z up";
  scene.gravity = Vector3d(0, 0, -9.81);
  scene.time_step = 1.0 / 240;
  scene.duration = duration;
  scene.margin = 0.04;
  scene.ground = {Vector3d(10, 10, 0.5), 0.5};
  return scene;
}

BodyProperties OneKilogram() { return {1, Vector3d::Constant(0.1), 0.5, 0}; }

}  // namespace

Scene SmallDropScene() {
  Scene scene = EmptyScene(6);
  RandomPolytopes polytopes;
  polytopes.properties = OneKilogram();
  polytopes.count = 8;
  polytopes.min_vertices = 8;
  polytopes.max_vertices = 20;
  polytopes.diameter = 1;
  polytopes.region_min = Vector3d(-0.8, -0.8, 1);
  polytopes.region_max = Vector3d(0.8, 0.8, 5);
  scene.bodies.emplace_back(polytopes);
  scene.snapshots = {0, 1, 6};
  return scene;
}

Scene LeavingTheWorldScene() {
  Scene scene = EmptyScene(6);
  scene.ground.half_extents = Vector3d(1, 1, 0.5);
  Pose at_the_edge;
  at_the_edge.position = Vector3d(0.9, 0, 0.6);
  scene.gravity = Vector3d(6, 0, -6);  // Steeper than the friction holds.
  scene.bodies.emplace_back(SingleBody{OneKilogram(), "box", Box{Vector3d::Constant(0.3)}, at_the_edge});
  return scene;
}

std::string ValidSceneText() {
  return R"({
  "about": "one box; SI units, z up",
  "gravity": [0, 0, -9.81],
  "time_step": 0.004,
  "duration": 0.2,
  "margin": 0.04,
  "ground": { "half_extents": [5, 5, 0.5], "friction": 0.5 },
  "bodies": [
    { "type": "box", "half_extents": [0.5, 0.4, 0.3], "mass": 2, "position": [0, 0, 1], "rotation": [0, 0, 0.5] }
  ],
  "snapshots": [0, 0.1]
})";
}

TestFolder::TestFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "dgd_demos_test.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder: " + name);
  path_ = name;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TestFolder::Write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name) << text;
  return path_ / name;
}

std::string ReadFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::filesystem::path> SimulatedScenes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const bool is_scene = entry.path().extension() == ".json";
    if (is_scene && ReadFile(entry.path()).find("\"bodies\"") != std::string::npos) scenes.push_back(entry.path());
  }
  std::ranges::sort(scenes);
  return scenes;
}

}  // namespace dgd_demos
