// Contract: a scene that is written as a world file is the same world when it is read, names included; a file that
// cannot be written leaves nothing behind.
#include "world_file/write_world.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "scene/bodies.h"
#include "scene/scene_error.h"
#include "simulation/world.h"
#include "small_scenes.h"
#include "world_file/imported_world.h"

namespace dgd_demos {
namespace {

TEST(WriteWorldTest, Scene_IsReadAsItWas) {
  const Scene scene = SmallDropScene();
  World original(scene, MakeBodies(scene, 1), Narrowphase::kDgd);
  for (int step = 0; step < 60; ++step) original.Step();
  const TestFolder folder;
  const auto file = folder.path() / "drop.bullet";
  WriteWorldFile(original, file);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);

  ImportedWorld read(LoadWorldFile(file), Narrowphase::kDgd);
  ASSERT_EQ(read.Bodies().size(), original.Bodies().size());
  // Bullet keeps it in its own precision.
  EXPECT_NEAR(read.time_step(), original.time_step(), 1e-9);
  const auto poses = original.Poses(), read_poses = read.Poses();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(read.Bodies()[i].name, original.Bodies()[i].name);
    EXPECT_EQ(read.Bodies()[i].moves, original.Bodies()[i].moves);
    EXPECT_EQ(read_poses[i].position, poses[i].position);
    EXPECT_EQ(read_poses[i].rotation, poses[i].rotation);
  }
  EXPECT_EQ(SpeedsOf(read.Motions()), SpeedsOf(original.Motions()));
  EXPECT_NEAR(read.TotalEnergy().kinetic, original.TotalEnergy().kinetic, 1e-5);
  EXPECT_NEAR(read.TotalEnergy().potential, original.TotalEnergy().potential, 1e-4);
}

TEST(WriteWorldTest, Twice_IsTheSameFile) {
  const Scene scene = SmallDropScene();
  World world(scene, MakeBodies(scene, 1), Narrowphase::kBuiltin);
  const TestFolder folder;
  WriteWorldFile(world, folder.path() / "first.bullet");
  WriteWorldFile(world, folder.path() / "second.bullet");
  EXPECT_EQ(ReadFile(folder.path() / "first.bullet"), ReadFile(folder.path() / "second.bullet"));
}

TEST(WriteWorldTest, FolderThatIsNotThere_IsAnError) {
  const Scene scene = SmallDropScene();
  World world(scene, MakeBodies(scene, 1), Narrowphase::kBuiltin);
  try {
    WriteWorldFile(world, "/nowhere/drop.bullet");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "/nowhere/drop.bullet: cannot be written: No such file or directory");
  }
}

}  // namespace
}  // namespace dgd_demos
