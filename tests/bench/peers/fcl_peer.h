// FCL's GJK/EPA, which is libccd's, in double.
#pragma once

#include "bench/peers/peer.h"

namespace dgd_bench {

/// To FCL's default tolerance, with nearest points. FCL rounds no shapes: it is asked about the cores, and the radii
/// are taken off its answer, which is exact for an exact one.
std::unique_ptr<Peer> MakeFclPeer(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
