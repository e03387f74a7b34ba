// The four algorithms that the paper compares with (Sec. VI), next to ours and the paper's own, on a pair of sets.
#pragma once

#include "bench/growth_pair.h"

namespace dgd_bench {

/// As MakeGrowthPair(); in space with all algorithms of GrowthAlgorithm.
std::unique_ptr<GrowthPair> MakeComparedPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
