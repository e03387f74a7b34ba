#include "motion/check_comparison.h"

#include <dgd/any_set.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "motion/pair_checker.h"
#include "motion/state_checker.h"

namespace dgd_demos {
namespace {

constexpr int kPasses = 3;

using Clock = std::chrono::steady_clock;
double SecondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double SignedDistanceOf(const CollisionModel& model, std::size_t pair, const CollisionModel::Poses& poses) {
  const auto [first, second] = model.pairs()[pair];
  const dgd::AnySet &set_1 = model.parts()[first].body.set(), &set_2 = model.parts()[second].body.set();
  const dgd::Result<double> growth = dgd::GrowthDistance(set_1, poses[first], set_2, poses[second]);
  return dgd::SignedDistance(set_1, poses[first], set_2, poses[second], growth).separation;
}

// The first collision of each state, by the core.
using Collisions = std::vector<std::optional<std::size_t>>;

using Shortcuts = StateChecker::Shortcuts;

CheckTimes TimeCore(const CollisionModel& model, const std::string& name, Shortcuts shortcuts,
                    const std::vector<CollisionModel::Poses>& poses, Collisions& collisions) {
  CheckTimes times{name};
  StateChecker checker(model, shortcuts);
  collisions.clear();
  for (const CollisionModel::Poses& state : poses) {
    const Clock::time_point start = Clock::now();
    const std::optional<std::size_t> collision = checker.FindCollision(state);
    times.seconds += SecondsSince(start);
    collisions.push_back(collision);
  }
  times.pairs = checker.counts().pairs;
  return times;
}

CheckTimes TimePeer(const CollisionModel& model, PairChecker& checker, const std::vector<CollisionModel::Poses>& poses,
                    const Collisions& expected) {
  CheckTimes times{checker.Name()};
  std::vector<char> collides(model.pairs().size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    checker.SetPoses(poses[i]);
    const std::size_t pairs = expected[i] ? *expected[i] + 1 : model.pairs().size();
    const Clock::time_point start = Clock::now();
    for (std::size_t pair = 0; pair < pairs; ++pair) collides[pair] = checker.Collides(pair);
    times.seconds += SecondsSince(start);
    times.pairs += static_cast<std::int64_t>(pairs);
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      const bool core_collides = expected[i] == pair;
      if ((collides[pair] != 0) == core_collides) continue;
      ++times.differing;
      // Written so that NaN is beyond the band.
      if (!(std::abs(SignedDistanceOf(model, pair, poses[i])) <= kTouchingBand)) ++times.beyond_band;
    }
  }
  return times;
}

// The fastest of some passes; what is counted is the same in each.
template <class Pass>
CheckTimes Fastest(const Pass& pass) {
  CheckTimes fastest = pass();
  for (int i = 1; i < kPasses; ++i) fastest.seconds = std::min(fastest.seconds, pass().seconds);
  return fastest;
}

}  // namespace

std::vector<CheckTimes> CompareChecks(const CollisionModel& model, const std::vector<Configuration>& states,
                                      const Progress& progress) {
  std::vector<CollisionModel::Poses> poses(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) model.ComputePoses(states[i], poses[i]);

  Collisions collisions;
  std::vector<CheckTimes> times;
  for (const auto& [name, shortcuts] :
       {std::pair("dgd::DetectCollision alone", Shortcuts::kNone), std::pair("dgd, cold", Shortcuts::kNearestPoints),
        std::pair("dgd, cached planes", Shortcuts::kCachedPlanes)}) {
    Collisions found;
    times.push_back(Fastest([&] { return TimeCore(model, name, shortcuts, poses, found); }));
    if (times.size() == 1) collisions = found;
    for (std::size_t i = 0; i < states.size(); ++i) times.back().differing += found[i] != collisions[i];
    times.back().beyond_band = times.back().differing;  // A plane that separates is a proof.
  }

  const std::unique_ptr<PairChecker> peers[] = {MakeFclChecker(model), MakeBulletChecker(model)};
  double share = 0.1;
  for (const std::unique_ptr<PairChecker>& peer : peers) {
    if (progress) progress(share);
    times.push_back(Fastest([&] { return TimePeer(model, *peer, poses, collisions); }));
    share += 0.45;
  }
  return times;
}

}  // namespace dgd_demos
