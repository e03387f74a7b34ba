// Bullet's own solvers on a pair of its convex shapes: cold, in the precision of the linked library.
#pragma once

#include "bench/peers/peer.h"

namespace dgd_bench {

/// "float" or "double": what Bullet's libraries in this process were built for.
const char* BulletPrecision();

/// As btConvexConvexAlgorithm asks once the capsules are ruled out: simplex solver and detector made anew, so that
/// nothing is known from before, EPA in reserve. But it reports however far apart the shapes are.
std::unique_ptr<Peer> MakeBulletGjkEpa(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

/// Minkowski portal refinement: says nothing of sets that are apart.
std::unique_ptr<Peer> MakeBulletMpr(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
