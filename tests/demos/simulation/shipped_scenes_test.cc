// The scenes of scenes/ in this executable's precision of Bullet: each starts as it is meant to, on each narrowphase.
#include <gtest/gtest.h>

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

class ShippedSceneTest : public testing::TestWithParam<std::tuple<std::string, Narrowphase>> {};

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
                         testing::Combine(testing::ValuesIn(ShippedScenes()), testing::ValuesIn(AllNarrowphases())),
                         [](const auto& which) {
                           return std::get<0>(which.param) + "_" + std::string(NameOf(std::get<1>(which.param)));
                         });

}  // namespace
}  // namespace dgd_demos
