#include "bench/replay/contest.h"

#include <stdexcept>

#include "bench/growth_methods.h"
#include "bench/peers/bullet_peers.h"
#include "bench/peers/fcl_peer.h"
#include "bench/replay/ours_peer.h"
#include "bench/replay/referee.h"
#include "bench/speed_walk.h"
#include "bench/stopwatch.h"

namespace dgd_bench {
namespace {

std::unique_ptr<SpeedPair<3>> MakeGrowth(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2) try {
  return MakeSpeedPair<3>(set_1, set_2);
} catch (const std::invalid_argument&) {
  return nullptr;
}

MethodSample SampleOf(const SpeedAnswer& answer, const Referee& referee) {
  MethodSample sample = SampleOf(answer);
  sample.is_wrong = (referee.AreApart() && answer.upper_bound < 1) || (referee.Overlap() && answer.lower_bound > 1);
  return sample;
}

MethodSample SampleOf(const std::optional<SeparationAnswer>& answer, bool answers_apart, const Referee& referee) {
  MethodSample sample;
  if (!answer || !answer->HasNormal()) {
    sample.is_missing = answers_apart || referee.Overlap();
    return sample;
  }
  const SeparationErrors errors = referee.Judge(*answer);
  sample.normal_error = errors.normal;
  sample.depth_error = errors.depth;
  sample.witness_error = errors.witness;
  sample.is_wrong = errors.is_wrong;
  return sample;
}

}  // namespace

bool ContestMethod::IsWarm() const {
  const auto* question = std::get_if<SpeedQuestion>(&how);
  return is_warm_peer || (question != nullptr && question->start == kWarmStart);
}

double ContestMethod::Tolerance() const {
  const auto* question = std::get_if<SpeedQuestion>(&how);
  return question != nullptr ? question->tolerance : 0;
}

const std::vector<ContestMethod>& AllContestMethods() {
  static const std::vector<ContestMethod> kMethods = [] {
    const std::string of_bullet = std::string(", ") + BulletPrecision();
    std::vector<ContestMethod> methods = {
        {.key = "bullet_gjk_epa", .title = "Bullet GJK/EPA" + of_bullet, .how = MakeBulletGjkEpa},
        {.key = "bullet_mpr", .title = "Bullet MPR" + of_bullet, .how = MakeBulletMpr, .answers_apart = false},
        {.key = "fcl", .title = "FCL (libccd), double", .how = MakeFclPeer},
        {.key = "signed_distance", .title = "ours, signed distance", .how = MakeOursPeer},
        {.key = "signed_distance_warm",
         .title = "ours, signed distance, warm",
         .how = MakeOursWarmPeer,
         .is_warm_peer = true},
    };
    for (const GrowthMethod& method : kGrowthMethods) {
      methods.push_back({.key = method.key, .title = method.title, .how = method.question});
    }
    return methods;
  }();
  return kMethods;
}

ContestPair::ContestPair(const dgd_test::SetNumbers& set_1, const dgd_test::SetNumbers& set_2,
                         const std::vector<const ContestMethod*>& methods)
    : methods_(methods), growth_(MakeGrowth(set_1, set_2)), judged_({set_1, set_2, {}, {}}) {
  for (const ContestMethod* method : methods) {
    const auto* make = std::get_if<MakePeer>(&method->how);
    peers_.push_back(make != nullptr ? (*make)(set_1, set_2) : nullptr);
  }
}

void ContestPair::MoveTo(const PairTurn& turn) {
  judged_.MoveTo(turn.pose_1, turn.pose_2);
  for (const auto& peer : peers_) {
    if (peer != nullptr) peer->MoveTo(turn);
  }
  if (growth_ == nullptr) return;
  // Warm starts know the pair's relative pose alone: set 2 is where set 1 would have seen it.
  const Eigen::Matrix3d rotation = turn.pose_1.rotation * turn.last_pose_1.rotation.transpose();
  const dgd_test::PoseNumbers seen_2{
      rotation * turn.last_pose_2.rotation,
      turn.pose_1.translation + rotation * (turn.last_pose_2.translation - turn.last_pose_1.translation)};
  growth_->MoveTo(turn.pose_1, seen_2, turn.pose_2);
}

bool ContestPair::Takes(std::size_t method) const {
  const auto* question = std::get_if<SpeedQuestion>(&methods_[method]->how);
  if (question == nullptr) return peers_[method] != nullptr;
  return growth_ != nullptr && growth_->Takes(*question);
}

std::vector<MethodSample> ContestPair::Measure(int rounds, int repeats) const {
  const std::vector<double> times = LeastOfRounds(
      rounds, methods_.size(), [&](std::size_t m) { return Takes(m) ? Time(m, repeats) : MethodSample::kNone; });
  const Referee referee(judged_);
  std::vector<MethodSample> samples(methods_.size());
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    if (!Takes(m)) continue;
    if (peers_[m] != nullptr) {
      samples[m] = SampleOf(peers_[m]->Ask(), methods_[m]->answers_apart, referee);
    } else {
      samples[m] = SampleOf(growth_->Judge(std::get<SpeedQuestion>(methods_[m]->how)), referee);
    }
    samples[m].microseconds = times[m];
  }
  return samples;
}

double ContestPair::Time(std::size_t method, int repeats) const {
  if (peers_[method] != nullptr) return peers_[method]->Time(repeats);
  return growth_->Time(std::get<SpeedQuestion>(methods_[method]->how), repeats);
}

}  // namespace dgd_bench
