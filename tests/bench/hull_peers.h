// The other libraries' signed-distance solvers (bench/peers/) on a pair of hulls.
#pragma once

#include "bench/query.h"

namespace dgd_bench {

std::unique_ptr<Query> MakeBulletQuery(const HullPair& pair);
std::unique_ptr<Query> MakeFclQuery(const HullPair& pair);

}  // namespace dgd_bench
