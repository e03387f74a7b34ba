// The pairs of types in space, in two translation units: each takes a minute to compile.
#pragma once

#include "bench/speed_pair.h"

namespace dgd_bench {

/// Null if the types are not of theirs.
std::unique_ptr<SpeedPair<3>> MakePrimitivePair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);
std::unique_ptr<SpeedPair<3>> MakeHullPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
