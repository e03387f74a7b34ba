#include "bench/hull_peers.h"

#include <optional>
#include <utility>

#include "bench/peers/bullet_peers.h"
#include "bench/peers/fcl_peer.h"

namespace dgd_bench {
namespace {

class PeerQuery : public Query {
 public:
  PeerQuery(std::unique_ptr<Peer> peer, const HullPair& pair) : peer_(std::move(peer)) {
    const dgd_test::PoseNumbers pose_1{pair.pose_1.rotation, pair.pose_1.position};
    const dgd_test::PoseNumbers pose_2{pair.pose_2.rotation, pair.pose_2.position};
    const dgd_test::PoseNumbers last_pose_2{pair.last_pose_2.rotation, pair.last_pose_2.position};
    peer_->MoveTo({pose_1, last_pose_2, pose_1, pose_2});
  }

  double Time(int repeats) const override { return peer_->Time(repeats); }

  Judgement Judge(const HullPair& pair) const override {
    const std::optional<SeparationAnswer> answer = peer_->Ask();
    Judgement judgement;
    // A normal that is none is no answer either.
    judgement.is_missing = !answer || !answer->HasNormal();
    if (!judgement.is_missing) judgement.normal_error = NormalError(pair, answer->normal);
    return judgement;
  }

 private:
  std::unique_ptr<Peer> peer_;
};

std::unique_ptr<Query> MakeQuery(MakePeer make, const HullPair& pair) {
  const auto set_of = [&](const dgd_demos::Polyhedron& core) {
    return dgd_test::SetNumbers{.type = dgd_test::SetType::kPolytope, .points = core.vertices, .radius = pair.margin};
  };
  return std::make_unique<PeerQuery>(make(set_of(pair.core_1), set_of(pair.core_2)), pair);
}

}  // namespace

std::unique_ptr<Query> MakeBulletQuery(const HullPair& pair) { return MakeQuery(MakeBulletGjkEpa, pair); }
std::unique_ptr<Query> MakeFclQuery(const HullPair& pair) { return MakeQuery(MakeFclPeer, pair); }

}  // namespace dgd_bench
