#include "motion/check_comparison.h"

#include <dgd/any_set.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "motion/pair_checker.h"
#include "motion/state_checker.h"

namespace dgd_demos {
namespace {

// States in turn: few enough that whatever else the machine does in a while slows down all checkers alike.
constexpr std::size_t kStatesAtATime = 500;

using Clock = std::chrono::steady_clock;
double SecondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double SignedDistanceOf(const CollisionModel& model, std::size_t pair, const CollisionModel::Poses& poses) {
  const auto [first, second] = model.pairs()[pair];
  const dgd::AnySet &set_1 = model.parts()[first].body.set(), &set_2 = model.parts()[second].body.set();
  return dgd::SignedDistance(set_1, poses[first], set_2, poses[second]).separation;
}

using Shortcuts = StateChecker::Shortcuts;
using StatePoses = std::vector<CollisionModel::Poses>;

// The core with some of its shortcuts.
struct Core {
  StateChecker checker;
  CheckTimes times;
  std::vector<std::optional<std::size_t>> collisions;  // The first of each state.

  Core(const CollisionModel& model, Shortcuts shortcuts, const char* name) : checker(model, shortcuts), times{name} {}

  void Check(const StatePoses& states) {
    collisions.clear();
    for (const CollisionModel::Poses& poses : states) {
      const Clock::time_point start = Clock::now();
      const std::optional<std::size_t> collision = checker.FindCollision(poses);
      times.seconds += SecondsSince(start);
      collisions.push_back(collision);
    }
    times.pairs = checker.counts().pairs;
  }
};

// Checks what the core has checked.
void CheckByPeer(const CollisionModel& model, PairChecker& checker, const StatePoses& states, const Core& core,
                 CheckTimes& times) {
  std::vector<char> collides(model.pairs().size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    checker.SetPoses(states[i]);
    const std::optional<std::size_t> expected = core.collisions[i];
    const std::size_t pairs = expected ? *expected + 1 : model.pairs().size();
    const Clock::time_point start = Clock::now();
    for (std::size_t pair = 0; pair < pairs; ++pair) collides[pair] = checker.Collides(pair);
    times.seconds += SecondsSince(start);
    times.pairs += static_cast<std::int64_t>(pairs);
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      if ((collides[pair] != 0) == (expected == pair)) continue;
      ++times.differing;
      // Written so that NaN is beyond the band.
      if (!(std::abs(SignedDistanceOf(model, pair, states[i])) <= kTouchingBand)) ++times.beyond_band;
    }
  }
}

}  // namespace

std::vector<CheckTimes> CompareChecks(const CollisionModel& model, const std::vector<Configuration>& states,
                                      const Progress& progress) {
  std::vector<Core> cores;
  cores.emplace_back(model, Shortcuts::kNone, "dgd::DetectCollision alone");
  cores.emplace_back(model, Shortcuts::kNearestPoints, "dgd, cold");
  cores.emplace_back(model, Shortcuts::kCachedPlanes, "dgd, cached planes");
  const std::unique_ptr<PairChecker> peers[] = {MakeFclChecker(model), MakeBulletChecker(model)};
  std::vector<CheckTimes> peer_times;
  for (const std::unique_ptr<PairChecker>& peer : peers) peer_times.push_back({peer->Name()});

  for (std::size_t begin = 0; begin < states.size(); begin += kStatesAtATime) {
    if (progress) progress(static_cast<double>(begin) / static_cast<double>(states.size()));
    StatePoses poses(std::min(kStatesAtATime, states.size() - begin));
    for (std::size_t i = 0; i < poses.size(); ++i) model.ComputePoses(states[begin + i], poses[i]);
    for (Core& core : cores) {
      core.Check(poses);
      // No plane separates what overlaps, so there is no band for these.
      for (std::size_t i = 0; i < poses.size(); ++i) {
        core.times.differing += core.collisions[i] != cores[0].collisions[i];
      }
      core.times.beyond_band = core.times.differing;
    }
    for (std::size_t i = 0; i < peer_times.size(); ++i) {
      CheckByPeer(model, *peers[i], poses, cores[0], peer_times[i]);
    }
  }
  std::vector<CheckTimes> times;
  for (const Core& core : cores) times.push_back(core.times);
  times.insert(times.end(), peer_times.begin(), peer_times.end());
  return times;
}

}  // namespace dgd_demos
