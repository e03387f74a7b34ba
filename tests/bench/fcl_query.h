// FCL's GJK and EPA, which are libccd's, on a pair of hulls.
#pragma once

#include "bench/query.h"

namespace dgd_bench {

/// The signed distance of the cores, with nearest points, to FCL's default tolerance; FCL's hulls have no margins,
/// which change the distance by a constant and the normal not at all.
std::unique_ptr<Query> MakeFclQuery(const HullPair& pair);

}  // namespace dgd_bench
