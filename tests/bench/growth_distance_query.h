// The growth distance of a pair of polytopes, default settings.
#pragma once

#include "bench/query.h"

namespace dgd_bench {

std::unique_ptr<Query> MakeColdQuery(const HullPair& pair);
std::unique_ptr<Query> MakeColdFloatQuery(const HullPair& pair);
/// Starts from what was found at the second hull's last pose.
std::unique_ptr<Query> MakeWarmQuery(const HullPair& pair);
/// And from there to the signed distance, cold.
std::unique_ptr<Query> MakeSignedDistanceQuery(const HullPair& pair);
/// The paper's algorithm as printed (bench/textbook/), cold.
std::unique_ptr<Query> MakePlainQuery(const HullPair& pair);
/// Collision yes or no, cold.
std::unique_ptr<Query> MakeCollisionQuery(const HullPair& pair);

}  // namespace dgd_bench
