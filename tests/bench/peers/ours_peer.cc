#include "bench/peers/ours_peer.h"

#include "bench/solver_set.h"
#include "bench/stopwatch.h"
#include "dgd/any_set.h"

namespace dgd_bench {
namespace {

using dgd_test::SetNumbers;

/// The core's signed distance, from scratch or from frame to frame.
class OursPeer : public Peer {
 public:
  OursPeer(const SetNumbers& set_1, const SetNumbers& set_2, bool is_warm)
      : set_1_(MakeSolverSet<3>(set_1)), set_2_(MakeSolverSet<3>(set_2)), is_warm_(is_warm) {}

  void MoveTo(const PairTurn& turn) override {
    if (is_warm_) {
      Place(turn.last_pose_1, turn.last_pose_2);
      state_ = {};
      Solve(state_);
    }
    Place(turn.pose_1, turn.pose_2);
  }

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] {
      dgd::WarmStart<double> state = state_;  // Each repeat is the same query again.
      Keep(Solve(state));
      Keep(state);
    });
  }

  std::optional<SeparationAnswer> Ask() const override {
    dgd::WarmStart<double> state = state_;
    const dgd::SignedDistanceResult<double> result = Solve(state);
    if (result.status != dgd::Status::kOptimal) return std::nullopt;
    return SeparationAnswer{result.normal, result.separation, result.witness_1, result.witness_2};
  }

 private:
  void Place(const dgd_test::PoseNumbers& pose_1, const dgd_test::PoseNumbers& pose_2) {
    pose_1_ = {pose_1.rotation, pose_1.translation};
    pose_2_ = {pose_2.rotation, pose_2.translation};
  }

  dgd::SignedDistanceResult<double> Solve(dgd::WarmStart<double>& state) const {
    constexpr dgd::Settings<double> kSettings;
    if (is_warm_) {
      const auto updated = dgd::UpdateDistance(set_1_.set, pose_1_, set_2_.set, pose_2_, kSettings, state);
      if (updated.status == dgd::Status::kOptimal) return updated;
    }
    return dgd::SignedDistance(set_1_.set, pose_1_, set_2_.set, pose_2_, kSettings, &state);
  }

  SolverSet<3> set_1_, set_2_;
  dgd::Pose<double> pose_1_, pose_2_;
  bool is_warm_;
  dgd::WarmStart<double> state_;
};

}  // namespace

std::unique_ptr<Peer> MakeOursPeer(const SetNumbers& set_1, const SetNumbers& set_2) {
  return std::make_unique<OursPeer>(set_1, set_2, false);
}

std::unique_ptr<Peer> MakeOursWarmPeer(const SetNumbers& set_1, const SetNumbers& set_2) {
  return std::make_unique<OursPeer>(set_1, set_2, true);
}

}  // namespace dgd_bench
