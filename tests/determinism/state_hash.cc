// state_hash: hashes of a scene's state on our narrowphase, second by second, one line each, to be compared between
// builds (tests/determinism/compare_builds.sh).
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <vector>

#include "scene_options.h"
#include "simulation/drop_run.h"
#include "simulation/world.h"

namespace {

/// FNV-1a over the bits of all poses.
class StateHash {
 public:
  void Add(const std::vector<dgd_demos::Pose>& poses) {
    for (const dgd_demos::Pose& pose : poses) {
      for (const double number : pose.position) Add(number);
      for (const double number : pose.rotation.reshaped()) Add(number);
    }
  }
  std::uint64_t Get() const { return hash_; }

 private:
  void Add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xff)) * 0x100000001b3U;
  }

  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

void Print(double seconds, const dgd_demos::World& world) {
  StateHash hash;
  hash.Add(world.Poses());
  std::printf("%2.0f s  %016llx\n", seconds, static_cast<unsigned long long>(hash.Get()));
}

}  // namespace

int main() try {
  constexpr std::uint64_t kSeed = 1;
  const dgd_demos::Scene scene = dgd_demos::LoadSceneFor(dgd_demos::FindData("scenes/polytopes_50.json"), std::nullopt);
  const std::vector<dgd_demos::Body> bodies = dgd_demos::MakeBodies(scene, kSeed);
  dgd_demos::World world(scene, bodies, dgd_demos::Narrowphase::kDgd);
  const int steps = dgd_demos::StepCount(scene), steps_per_second = static_cast<int>(std::lround(1 / scene.time_step));
  Print(0, world);
  for (int step = 1; step <= steps; ++step) {
    world.Step();
    if (step % steps_per_second == 0) Print(double(step) / steps_per_second, world);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
