// Contract: a state of which any value is another one, whose hash is right, ends in an error or in a run that goes on;
// never in a crash. Words are exchanged in turn, and the state ends at every so-many-th byte.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "checkpoint/world_state.h"
#include "simulation/drop_run.h"
#include "world_file/bullet_worlds.h"
#include "world_file/imported_world.h"

namespace dgd_demos {
namespace {

constexpr int kStepsBefore = 40, kMoreSteps = 3;

class ForgedStateTest : public testing::TestWithParam<std::string> {
 protected:
  enum class Outcome { kRun, kError };

  ForgedStateTest() {
    const std::unique_ptr<ImportedWorld> world = Load();
    WorldRun run(*world, Settings(*world));
    std::vector<btTransform> collision_poses;
    for (int step = 0; step < kStepsBefore; ++step) {
      collision_poses = PosesOf(world->Bullet());
      run.Step();
    }
    StateArchive archive;
    SerializeWorld(archive, world->Bullet(), collision_poses);
    run.Serialize(archive);
    state_ = archive.bytes();
  }

  Outcome Continue(std::string state) const {
    const std::unique_ptr<ImportedWorld> world = Load();
    WorldRun run(*world, Settings(*world));
    StateArchive archive(std::move(state), "forged");
    try {
      SerializeWorld(archive, world->Bullet(), {});
      run.Serialize(archive);
      archive.ExpectEnd();
    } catch (const std::runtime_error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("forged: ")) << error.what();
      return Outcome::kError;
    }
    for (int step = 0; step < kMoreSteps && !run.IsDone(); ++step) run.Step();
    const DropRun result = run.Result();
    for (const Snapshot& snapshot : result.snapshots) EXPECT_EQ(snapshot.poses.size(), world->Bodies().size());
    return Outcome::kRun;
  }

  std::string state_;

 private:
  std::unique_ptr<ImportedWorld> Load() const {
    return std::make_unique<ImportedWorld>(LoadWorldBytes("world", bytes_), Narrowphase::kDgd);
  }
  static RunSettings Settings(const SimulatedWorld& world) {
    return {(kStepsBefore + kMoreSteps) * world.time_step(), 1, {0, kStepsBefore / 2 * world.time_step()}};
  }

  std::vector<std::byte> bytes_ = dgd_test::MakeWorld(GetParam())->Serialize();
};

TEST_P(ForgedStateTest, AnyValue) {
  ASSERT_EQ(Continue(state_), Outcome::kRun);
  constexpr std::size_t kStride = 5;  // Bytes: values begin anywhere.
  constexpr std::uint32_t kOthers[] = {0, 1, 2, 5, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fc00000};
  int runs = 0, errors = 0;
  std::size_t turn = 0;
  for (std::size_t i = 0; i + sizeof(std::uint32_t) <= state_.size(); i += kStride) {
    std::string forged = state_;
    std::memcpy(forged.data() + i, &kOthers[turn++ % std::size(kOthers)], sizeof(std::uint32_t));
    if (forged != state_) ++(Continue(std::move(forged)) == Outcome::kRun ? runs : errors);
  }
  std::printf("%s: %zu bytes, %d runs, %d errors\n", GetParam().c_str(), state_.size(), runs, errors);
  EXPECT_GT(runs, errors / 10);
  EXPECT_GT(errors, 10);
}

TEST_P(ForgedStateTest, AnyLength) {
  for (std::size_t length = 0; length < state_.size(); length += 31) {
    EXPECT_EQ(Continue(state_.substr(0, length)), Outcome::kError) << length;
  }
  EXPECT_EQ(Continue(state_ + '\0'), Outcome::kError);
}

INSTANTIATE_TEST_SUITE_P(Worlds, ForgedStateTest, testing::Values("boxes", "compounds", "ragdoll"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace dgd_demos
