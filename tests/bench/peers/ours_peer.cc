#include "bench/peers/ours_peer.h"

#include "bench/solver_set.h"
#include "bench/stopwatch.h"
#include "pipeline/pair_distance.h"

namespace dgd_bench {
namespace {

using dgd_test::SetNumbers;

/// What the plugin keeps of a pair from step to step.
struct PairMemory {
  dgd::WarmStart<double> warm_start;
  bool can_update = true;
};

class OursPeer : public Peer {
 public:
  OursPeer(const SetNumbers& set_1, const SetNumbers& set_2, bool is_warm)
      : set_1_(MakeSolverSet<3>(set_1)),
        set_2_(MakeSolverSet<3>(set_2)),
        posed_1_{set_1_.set, {}},
        posed_2_{set_2_.set, {}},
        is_warm_(is_warm) {}

  void MoveTo(const PairTurn& turn) override {
    if (is_warm_) {
      Place(turn.last_pose_1, turn.last_pose_2);
      memory_ = {};
      Solve(memory_);
    }
    Place(turn.pose_1, turn.pose_2);
  }

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] {
      PairMemory memory = memory_;  // Each repeat is the same query again.
      Keep(Solve(memory));
      Keep(memory);
    });
  }

  std::optional<SeparationAnswer> Ask() const override {
    PairMemory memory = memory_;
    const dgd::Result<double> result = Solve(memory);
    if (result.status != dgd::Status::kOptimal && result.status != dgd::Status::kCoincidentCenters) return std::nullopt;
    return SeparationAnswer{result.normal, result.separation, result.witness_1, result.witness_2};
  }

 private:
  void Place(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& pose_2) {
    posed_1_.pose = {pose_1.rotation, pose_1.translation};
    posed_2_.pose = {pose_2.rotation, pose_2.translation};
  }

  dgd::Result<double> Solve(PairMemory& memory) const {
    dgd_bullet::PosedShape shape_1 = posed_1_, shape_2 = posed_2_;  // Their centres may move.
    dgd_bullet::MoveCentersTogether(shape_1, shape_2);
    constexpr dgd::Settings<double> kSettings;
    if (is_warm_ && memory.can_update) {
      if (const auto updated = dgd_bullet::UpdateDistance(shape_1, shape_2, kSettings, memory.warm_start)) {
        return *updated;
      }
    }
    dgd::Result<double> result =
        dgd::GrowthDistance(shape_1.set, shape_1.pose, shape_2.set, shape_2.pose, kSettings, &memory.warm_start);
    memory.can_update = dgd_bullet::TurnToLeastTranslation(shape_1, shape_2, kSettings, memory.warm_start, result);
    return result;
  }

  SolverSet<3> set_1_, set_2_;
  dgd_bullet::PosedShape posed_1_, posed_2_;
  bool is_warm_;
  PairMemory memory_;
};

}  // namespace

std::unique_ptr<Peer> MakeOursPeer(const SetNumbers& set_1, const SetNumbers& set_2) {
  return std::make_unique<OursPeer>(set_1, set_2, false);
}

std::unique_ptr<Peer> MakeOursWarmPeer(const SetNumbers& set_1, const SetNumbers& set_2) {
  return std::make_unique<OursPeer>(set_1, set_2, true);
}

}  // namespace dgd_bench
