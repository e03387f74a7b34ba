// The solvers that are compared.
#pragma once

#include <array>

#include "bench/growth_distance_query.h"
#include "bench/hull_peers.h"

namespace dgd_bench {

/// The one list of methods, in the order of the table's rows. The first one is what the others' ratios refer to.
inline constexpr std::array kMethods = {
    Method{"bullet_gjk_epa", "Bullet GJK/EPA, cold", MakeBulletQuery, false},
    Method{"fcl", "FCL (libccd), cold", MakeFclQuery, false},
    Method{"plain", "paper's algorithm, plain, cold", MakePlainQuery, false},
    Method{"growth_distance", "growth distance, double, cold", MakeColdQuery, true},
    Method{"growth_distance_warm", "growth distance, double, warm", MakeWarmQuery, true},
    Method{"growth_distance_float", "growth distance, float, cold", MakeColdFloatQuery, false},
    Method{"signed_distance", "signed distance, double, cold", MakeSignedDistanceQuery, true},
    Method{"collision", "collision yes/no, double, cold", MakeCollisionQuery, true},
};

}  // namespace dgd_bench
