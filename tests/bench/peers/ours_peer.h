// The plugin's own way to a contact normal: growth distance, then least translation.
#pragma once

#include "bench/peers/peer.h"

namespace dgd_bench {

std::unique_ptr<Peer> MakeOursPeer(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

/// Goes on from the answer to the last poses, as the plugin does from step to step where no face holds the contact.
std::unique_ptr<Peer> MakeOursWarmPeer(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2);

}  // namespace dgd_bench
