// The growth distance and from there the signed distance, cold, of any two sets of space: more types than Bullet has,
// in both scalars.
#pragma once

#include "bench/peers/peer.h"

namespace dgd_bench {

/// Both throw std::invalid_argument where a set refuses its numbers.
std::unique_ptr<Peer> MakeSignedDistanceInDouble(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);
std::unique_ptr<Peer> MakeSignedDistanceInFloat(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
