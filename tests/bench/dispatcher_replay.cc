// dispatcher_replay: what a step asks of its narrowphase, recorded once and asked again of each. See --help.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/exit_status.h"
#include "bench/percentile.h"
#include "bench/replay_world.h"
#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"
#include "scene_options.h"
#include "simulation/drop_run.h"
#include "simulation/signed_distance.h"
#include "simulation/world.h"

namespace dgd_bench {
namespace {

using dgd_demos::Narrowphase;
using dgd_demos::Pose;

constexpr const char* kDescription =
    R"(Simulates a scene on Bullet's built-in narrowphase, and replays its motion on that and on the plugin: the
same pairs at the same poses in the same order, through the dispatcher, as a step does. Times every pair,
and has an exact oracle, which shares no code with either, judge the contacts.)";

constexpr const char* kFooter = R"(
Examples:
  dispatcher_replay                            the fifty falling polytopes, Bullet in float: half a minute
  dispatcher_replay_float64 --duration 3       the fall alone, Bullet in double
  dispatcher_replay --scene my.json            a scene of your own (format: scenes/README.md)

Rows:     pairs whose sets are apart by more than 2 cm, and so get no contact from Bullet; the others; all.
          The oracle tells which is which.
Columns:  times of a pair in us, from the dispatcher's near callback to its return, each the least of --rounds
          replays; their mean, and its ratio to the built-in's; contact points a pair; how much the deepest
          point's depth differs from the least translation, of overlapping pairs; overlaps deeper than 0.1 mm
          without a contact.

Exit status: 0; 1 the plugin missed an overlap; 2 wrong command line or scene file.)";

struct Options {
  std::string scene = "scenes/polytopes_50.json";
  std::optional<double> duration;
  std::uint64_t seed = 1;
  int rounds = 3;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMostRounds = 1000;
  Options options;
  dgd_demos::CommandLine line("dispatcher_replay", kDescription, kFooter);
  line.AddText("--scene", "FILE", options.scene, "Scene file");
  dgd_demos::AddDurationOption(line, options.duration);
  line.AddSeed(options.seed, "Seed of the scene's random bodies");
  line.AddNumber("--rounds", "N", options.rounds, {1, kMostRounds}, "Replays, of which each pair's least time counts");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

/// Poses of all bodies, before each step.
using Motion = std::vector<std::vector<Pose>>;

Motion RecordMotion(const dgd_demos::Scene& scene, const std::vector<dgd_demos::Body>& bodies) {
  dgd_demos::World world(scene, bodies, Narrowphase::kBuiltin);
  dgd_demos::ProgressBar progress("recording", 1);
  const int steps = dgd_demos::StepCount(scene);
  Motion motion;
  for (int step = 0; step < steps; ++step) {
    motion.push_back(world.Poses());
    world.Step();
    progress.Update(double(step + 1) / steps);
  }
  motion.push_back(world.Poses());
  return motion;
}

/// All samples of a narrowphase in the order of their making.
using Samples = std::vector<PairSample>;

constexpr std::array kNarrowphases = {Narrowphase::kBuiltin, Narrowphase::kDgd};

/// The samples of each narrowphase, step by step, in turns; and the steps that they belong to.
struct Replay {
  std::array<Samples, kNarrowphases.size()> samples;
  std::array<std::vector<std::size_t>, kNarrowphases.size()> steps;
};

Replay ReplayOnce(const Motion& motion, const std::vector<dgd_demos::Body>& bodies, double time_step,
                  const std::string& label) {
  std::array<ReplayWorld, kNarrowphases.size()> worlds{ReplayWorld{bodies, kNarrowphases[0], time_step},
                                                       ReplayWorld{bodies, kNarrowphases[1], time_step}};
  dgd_demos::ProgressBar progress(label, 1);
  Replay replay;
  for (std::size_t step = 0; step + 1 < motion.size(); ++step) {
    for (std::size_t n = 0; n < worlds.size(); ++n) {
      const Samples samples = worlds[n].Detect(motion[step], motion[step + 1]);
      replay.samples[n].insert(replay.samples[n].end(), samples.begin(), samples.end());
      replay.steps[n].insert(replay.steps[n].end(), samples.size(), step);
    }
    progress.Update(double(step + 1) / double(motion.size()));
  }
  return replay;
}

/// The pairs are the same in each round, and each one's answer is.
void KeepLeastTimes(Replay& least, const Replay& other) {
  for (std::size_t n = 0; n < least.samples.size(); ++n) {
    if (other.samples[n].size() != least.samples[n].size()) throw std::logic_error("two replays of a motion differ");
    for (std::size_t i = 0; i < least.samples[n].size(); ++i) {
      PairSample& sample = least.samples[n][i];
      sample.microseconds = std::min(sample.microseconds, other.samples[n][i].microseconds);
    }
  }
}

/// The exact signed distance of two bodies as Bullet sees them, metres.
class Oracle {
 public:
  explicit Oracle(const std::vector<dgd_demos::Body>& bodies) {
    for (const dgd_demos::Body& body : bodies) {
      cores_.push_back(dgd_demos::CoreOf(body.shape, body.margin));
      radii_.push_back(dgd_demos::RoundingRadius(body.shape, body.margin));
    }
  }

  double Distance(const dgd_demos::BodyPair& pair, const std::vector<Pose>& poses) const {
    const auto first = static_cast<std::size_t>(pair.first), second = static_cast<std::size_t>(pair.second);
    const dgd_demos::PosedPolyhedron core_1(cores_[first], poses[first]), core_2(cores_[second], poses[second]);
    return dgd_demos::ComputeSignedDistance(core_1, core_2).value - radii_[first] - radii_[second];
  }

 private:
  std::vector<dgd_demos::Polyhedron> cores_;
  std::vector<double> radii_;
};

/// One narrowphase on the pairs of one kind.
struct Row {
  std::vector<double> microseconds;
  double total = 0;  // us
  std::int64_t contacts = 0;
  std::vector<double> depth_errors;  // m, of overlapping pairs with contacts.
  int missed = 0;

  void Take(const PairSample& sample, double true_distance) {
    constexpr double kNegligible = 1e-4;  // m
    microseconds.push_back(sample.microseconds);
    total += sample.microseconds;
    contacts += sample.contacts;
    if (true_distance >= 0) return;
    if (sample.contacts > 0) {
      depth_errors.push_back(std::abs(sample.separation - true_distance));
    } else if (true_distance < -kNegligible) {
      ++missed;
    }
  }
  void Sort() {
    std::ranges::sort(microseconds);
    std::ranges::sort(depth_errors);
  }
  double Mean() const { return total / static_cast<double>(microseconds.size()); }
};

constexpr std::array<const char*, 3> kKinds = {"apart by more than 2 cm", "nearer, or overlapping", "all"};
constexpr double kApart = 0.02;  // m, Bullet's largest breaking threshold.
using Rows = std::array<Row, kKinds.size()>;

Rows Judge(const Samples& samples, const std::vector<std::size_t>& steps, const Motion& motion, const Oracle& oracle) {
  Rows rows;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double distance = oracle.Distance(samples[i].pair, motion[steps[i]]);
    rows[distance > kApart ? 0 : 1].Take(samples[i], distance);
    rows[2].Take(samples[i], distance);
  }
  for (Row& row : rows) row.Sort();
  return rows;
}

void Print(const std::array<Rows, kNarrowphases.size()>& measured) {
  std::printf("%-26s%9s%9s%9s%9s%9s%9s%11s%13s%13s%8s\n", "", "pairs", "p50", "p99", "p99.99", "mean", "ratio",
              "contacts", "error p99", "error max", "missed");
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    std::printf("%s\n", kKinds[kind]);
    for (std::size_t n = 0; n < kNarrowphases.size(); ++n) {
      const Row& row = measured[n][kind];
      std::printf("  %-24s%9zu%9.3f%9.3f%9.3f%9.3f%9.2f%11.2f%13.3f%13.3f%8d\n",
                  std::string(NameOf(kNarrowphases[n])).c_str(), row.microseconds.size(),
                  Percentile(row.microseconds, 0.5), Percentile(row.microseconds, 0.99),
                  Percentile(row.microseconds, 0.9999), row.Mean(), row.Mean() / measured[0][kind].Mean(),
                  double(row.contacts) / double(row.microseconds.size()), 1e6 * Percentile(row.depth_errors, 0.99),
                  1e6 * Percentile(row.depth_errors, 1), row.missed);
    }
  }
}

ExitStatus Run(const Options& options) {
  const dgd_demos::Scene scene = dgd_demos::LoadSceneFor(dgd_demos::FindData(options.scene), options.duration);
  const std::vector<dgd_demos::Body> bodies = MakeBodies(scene, options.seed);
  const Motion motion = RecordMotion(scene, bodies);
  std::printf(
      "%s, seed %llu: %zu bodies, %zu steps of %g ms, Bullet in %s precision; times in us, errors of the depth in um\n",
      options.scene.c_str(), static_cast<unsigned long long>(options.seed), bodies.size(), motion.size() - 1,
      1e3 * scene.time_step, dgd_demos::BulletPrecision());
  Replay replay;
  for (int round = 0; round < options.rounds; ++round) {
    Replay next = ReplayOnce(motion, bodies, scene.time_step, "replay " + std::to_string(round + 1));
    if (round == 0) {
      replay = std::move(next);
    } else {
      KeepLeastTimes(replay, next);
    }
  }
  const Oracle oracle(bodies);
  std::array<Rows, kNarrowphases.size()> measured;
  for (std::size_t n = 0; n < measured.size(); ++n) {
    measured[n] = Judge(replay.samples[n], replay.steps[n], motion, oracle);
  }
  Print(measured);
  return measured.back().back().missed > 0 ? kFailedQuery : kSuccess;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
