// Bullet's own GJK and EPA on a pair of its hulls.
#pragma once

#include "bench/query.h"

namespace dgd_bench {

/// "float" or "double": what Bullet's libraries in this process were built for.
const char* BulletPrecision();

/// As btConvexConvexAlgorithm asks once the capsules are ruled out: simplex solver and detector made anew, so that
/// nothing is known from before, EPA in reserve. But it reports however far apart the hulls are.
std::unique_ptr<Query> MakeBulletQuery(const HullPair& pair);

}  // namespace dgd_bench
