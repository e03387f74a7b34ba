// Contract: a damaged file ends in a world that steps, or in an error; never in a crash. Every byte before the DNA, and
// every so-many-th of the DNA, is set and flipped in turn, and the file ends at every place; in worlds larger than one
// sphere, at every so-many-th.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/scene_error.h"
#include "world_file/imported_world.h"
#include "world_file/world_bytes.h"

namespace dgd_demos {
namespace {

enum class Outcome { kWorld, kError };

Outcome LoadAndStep(std::vector<std::byte> bytes) {
  try {
    ImportedWorld world(LoadWorldBytes("world", std::move(bytes)), Narrowphase::kDgd);
    for (int step = 0; step < 2; ++step) world.Step();
    return Outcome::kWorld;
  } catch (const SceneError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("world: ")) << error.what();
    return Outcome::kError;
  }
}

class MutationTest : public testing::TestWithParam<std::string> {
 protected:
  // Of the DNA, whose every byte takes the same way, fewer.
  static constexpr std::size_t kDnaStride = 101;

  std::unique_ptr<dgd_test::BulletWorld> original_ =
      GetParam() == "sphere" ? dgd_test::MakeFallingSphere() : dgd_test::MakeWorld(GetParam());
  dgd_test::WorldBytes world_{*original_};
};

TEST_P(MutationTest, EveryByteChanged) {
  const std::vector<std::byte> bytes = world_.bytes();
  const bool is_small = GetParam() == "sphere";
  int worlds = 0, errors = 0;
  for (std::size_t i = 0; i < bytes.size(); i += i < world_.DnaPosition() ? (is_small ? 1 : 29) : kDnaStride) {
    for (const std::byte mask : {std::byte{0xff}, std::byte{0x01}, std::byte{0x80}}) {
      std::vector<std::byte> damaged = bytes;
      damaged[i] = mask == std::byte{0xff} ? mask : damaged[i] ^ mask;
      ++(LoadAndStep(std::move(damaged)) == Outcome::kWorld ? worlds : errors);
    }
  }
  std::printf("%s: %d worlds, %d errors\n", GetParam().c_str(), worlds, errors);
  EXPECT_GT(worlds, errors / 10);
  EXPECT_GT(errors, worlds / 10);
}

TEST_P(MutationTest, EveryLength) {
  const std::vector<std::byte> bytes = world_.bytes();
  const std::size_t stride = GetParam() == "sphere" ? 1 : 101;
  for (std::size_t length = 0; length < bytes.size(); length += stride) {
    EXPECT_EQ(LoadAndStep({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}), Outcome::kError)
        << length;
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, MutationTest, testing::Values("sphere", "compounds", "ragdoll", "chain"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace dgd_demos
