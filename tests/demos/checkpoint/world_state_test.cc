// Contract: a world that is made again and reads the state of another one goes on as that one does, to the last bit,
// with Bullet's own narrowphase and with this project's without warm starts.
#include "checkpoint/world_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "world_file/bullet_worlds.h"
#include "world_file/imported_world.h"

namespace dgd_demos {
namespace {

constexpr int kSteps = 700;  // By when parts of the worlds are asleep.

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const auto& world_case : dgd_test::AllWorldCases()) names.push_back(world_case.name);
  return names;
}

// Poses and velocities of all bodies.
std::vector<double> StateOf(const SimulatedWorld& world) {
  std::vector<double> state;
  const auto add = [&](const auto& matrix) { state.insert(state.end(), matrix.data(), matrix.data() + matrix.size()); };
  for (const Pose& pose : world.Poses()) {
    add(pose.position);
    add(pose.rotation);
  }
  for (const Motion& motion : world.Motions()) {
    add(motion.velocity);
    add(motion.angular_velocity);
  }
  return state;
}

class WorldStateTest : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  WorldStateTest() : original_(dgd_test::MakeWorld(std::get<0>(GetParam()))) {}

  std::unique_ptr<ImportedWorld> Load() {
    return std::make_unique<ImportedWorld>(LoadWorldBytes(std::get<0>(GetParam()), original_->Serialize()),
                                           NarrowphaseChoice::Named(std::get<1>(GetParam())));
  }

 private:
  std::unique_ptr<dgd_test::BulletWorld> original_;
};

TEST_P(WorldStateTest, Read_GoesOnToTheLastBit) {
  const std::vector<int> checkpoints = {1, 40, 333, 620};
  std::vector<std::string> saved;
  std::vector<std::vector<double>> states;
  const std::unique_ptr<ImportedWorld> world = Load();
  for (int step = 1; step <= kSteps; ++step) {
    std::vector<btTransform> collision_poses = PosesOf(world->Bullet());
    world->Step();
    states.push_back(StateOf(*world));
    if (std::ranges::count(checkpoints, step) == 0) continue;
    StateArchive archive;
    SerializeWorld(archive, world->Bullet(), std::move(collision_poses));
    saved.push_back(archive.bytes());
  }

  for (std::size_t i = 0; i < checkpoints.size(); ++i) {
    SCOPED_TRACE(checkpoints[i]);
    const std::unique_ptr<ImportedWorld> again = Load();
    StateArchive archive(saved[i], "state");
    SerializeWorld(archive, again->Bullet(), {});
    archive.ExpectEnd();
    for (int step = checkpoints[i];; ++step) {
      ASSERT_EQ(StateOf(*again), states[static_cast<std::size_t>(step) - 1]) << "after step " << step;
      if (step == kSteps) break;
      again->Step();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, WorldStateTest,
                         testing::Combine(testing::ValuesIn(Names()), testing::Values("builtin", "dgd:warm_start=off")),
                         [](const auto& test) {
                           return std::get<0>(test.param) +
                                  (std::get<1>(test.param) == "builtin" ? "_builtin" : "_dgd");
                         });

TEST(WorldStateTest, StateOfAnotherWorld_IsRefused) {
  const auto load = [](const char* name) {
    return std::make_unique<ImportedWorld>(LoadWorldBytes(name, dgd_test::MakeWorld(name)->Serialize()),
                                           Narrowphase::kBuiltin);
  };
  const auto boxes = load("boxes"), chain = load("chain");
  std::vector<btTransform> collision_poses = PosesOf(boxes->Bullet());
  boxes->Step();
  StateArchive written;
  SerializeWorld(written, boxes->Bullet(), collision_poses);
  StateArchive archive(written.bytes(), "state");
  EXPECT_THROW(SerializeWorld(archive, chain->Bullet(), {}), std::runtime_error);
}

}  // namespace
}  // namespace dgd_demos
