// The pairs of a class, in all of their poses: the same ones, in the same order, for every program that measures.
#pragma once

#include <algorithm>
#include <cstdint>

#include "bench/class_options.h"
#include "report/progress_bar.h"
#include "support/random.h"

namespace dgd_bench {

/// @tparam L  The class's dimension.
/// @param make   Makes a pointer to a pair of the class's numbers: something with an Extent().
/// @param visit  Called with the pair, its poses, and the index of both together.
template <int L, class Make, class Visit>
void WalkClass(const PairClass& each, const Meshes& meshes, const ClassOptions& options, const Make& make,
               const Visit& visit) {
  dgd_demos::ProgressBar progress(each.name, 1);
  dgd_test::Random random(options.seed);
  const int pairs = std::max(1, options.pairs / each.poses_factor);
  const int poses = options.pairs * options.poses / pairs;
  std::int64_t index = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto pair = make(each.draw_sets(random, meshes));
    const double extent = pair->Extent();
    for (int j = 0; j < poses; ++j) visit(*pair, DrawPoses(random, L, extent), index++);
    progress.Update(static_cast<double>(i + 1) / pairs);
  }
}

}  // namespace dgd_bench
