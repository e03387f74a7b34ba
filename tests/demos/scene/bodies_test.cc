// Contract of MakeBodies: ground first; same seed, same bodies; random bodies start inside their region and touch
// nothing; a region without room is reported with the file and the group.
#include "scene/bodies.h"

#include <gtest/gtest.h>

#include <string>

#include "scene/scene_error.h"
#include "simulation/penetration_oracle.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

TEST(BodiesTest, Ground_IsFirstStaticAndBelowZero) {
  const std::vector<Body> bodies = MakeBodies(SmallDropScene(), 1);
  const Body& ground = bodies[kGroundIndex];
  EXPECT_EQ(ground.mass, 0);
  EXPECT_EQ(ground.pose.position.z() + std::get<Box>(ground.shape).half_extents.z(), 0);
}

TEST(BodiesTest, SameSeed_SameBodies) {
  const std::vector<Body> first = MakeBodies(SmallDropScene(), 5), second = MakeBodies(SmallDropScene(), 5);
  const std::vector<Body> other = MakeBodies(SmallDropScene(), 6);
  ASSERT_EQ(first.size(), 9u);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].pose.position, second[i].pose.position);
    EXPECT_EQ(first[i].pose.rotation, second[i].pose.rotation);
    EXPECT_EQ(CoreOf(first[i].shape, 0).vertices, CoreOf(second[i].shape, 0).vertices);
    EXPECT_EQ(first[i].pose.position == other[i].pose.position, i == kGroundIndex);
  }
}

TEST(BodiesTest, AnotherGroup_LeavesTheFirstAsItIs) {
  Scene scene = SmallDropScene();
  const std::vector<Body> alone = MakeBodies(scene, 5);
  RandomPolytopes second = std::get<RandomPolytopes>(scene.bodies[0]);
  second.region_min.x() += 5;
  second.region_max.x() += 5;
  scene.bodies.emplace_back(second);
  const std::vector<Body> both = MakeBodies(scene, 5);
  ASSERT_EQ(both.size(), 17u);
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i].pose.position, both[i].pose.position);
}

TEST(BodiesTest, RandomBodies_StartInTheirRegionWithoutTouching) {
  const Scene scene = SmallDropScene();
  const auto& group = std::get<RandomPolytopes>(scene.bodies[0]);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<Body> bodies = MakeBodies(scene, seed);
    CollisionInput all_pairs;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
      all_pairs.poses.push_back(bodies[i].pose);
      for (int j = 0; j < i; ++j) all_pairs.pairs.push_back({j, i});
      if (i == 0) continue;
      EXPECT_GE((bodies[i].pose.position - group.region_min).minCoeff(), 0);
      EXPECT_GE((group.region_max - bodies[i].pose.position).minCoeff(), 0);
    }
    EXPECT_EQ(PenetrationOracle(bodies).DeepestPenetration(all_pairs), 0) << "seed " << seed;
  }
}

TEST(BodiesTest, RegionWithoutRoom_IsReported) {
  Scene scene = SmallDropScene();
  std::get<RandomPolytopes>(scene.bodies[0]).region_max.z() = 1.5;
  try {
    MakeBodies(scene, 1);
    FAIL() << "no complaint";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("a scene of the tests: /bodies/0/region: no room"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace dgd_demos
