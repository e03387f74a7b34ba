// Scenes of the kinds that Bullet's own benchmarks have, built here from scratch: many bodies, fallen, stacked, linked
// and broken.
#pragma once

#include <string_view>
#include <vector>

#include "bench/bench_world.h"

namespace dgd_bench {

struct BigScene {
  std::string_view name;
  std::string_view summary;
  void (*build)(BenchWorld& world);
};

/// All of them. Each builds the same in every world.
const std::vector<BigScene>& BigScenes();

}  // namespace dgd_bench
