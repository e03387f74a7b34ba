// The scenes of scenes/ in this executable's precision of Bullet: each starts as it is meant to, on each narrowphase.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "scene/bodies.h"
#include "scene/scene_file.h"
#include "simulation/drop_run.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

std::vector<std::string> ShippedScenes() {
  std::vector<std::string> names;
  for (const std::filesystem::path& scene : SimulatedScenes(DGD_TEST_SCENES)) names.push_back(scene.stem().string());
  return names;
}

std::vector<NarrowphaseChoice> Choices() {
  std::vector<NarrowphaseChoice> choices;
  for (const char* name : {"builtin", "dgd", "dgd:geometry_mode=sharp", "dgd:keep_empty_manifolds=off"}) {
    choices.push_back(NarrowphaseChoice::Named(name));
  }
  return choices;
}

class ShippedSceneTest : public testing::TestWithParam<std::tuple<std::string, NarrowphaseChoice>> {};

// Bodies that start inside each other are thrown apart in these steps, and gain energy. What starts in contact overlaps
// by rounding.
TEST_P(ShippedSceneTest, FirstSteps_LoseNoBodyAndThrowNoneApart) {
  const auto& [name, narrowphase] = GetParam();
  Scene scene = LoadScene(std::filesystem::path(DGD_TEST_SCENES) / (name + ".json"));
  scene.duration = 5 * scene.time_step;
  std::vector<double> penetrations;  // m
  const DropRun run = RunDrop(scene, MakeBodies(scene, 1), narrowphase, 1,
                              [&](const StepRecord& step) { penetrations.push_back(step.true_penetration.value()); });
  ASSERT_FALSE(penetrations.empty());
  EXPECT_LT(penetrations.front(), 1e-5);
  EXPECT_EQ(run.failure.value_or(""), "");
  EXPECT_EQ(run.summary.steps, 5);
  EXPECT_EQ(run.summary.lost_bodies, 0);
  EXPECT_LT(run.summary.energy_rise, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedSceneTest,
                         testing::Combine(testing::ValuesIn(ShippedScenes()), testing::ValuesIn(Choices())),
                         [](const auto& which) {
                           std::string name = std::get<0>(which.param) + "_" + std::get<1>(which.param).Name();
                           std::ranges::replace_if(
                               name, [](char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace dgd_demos
