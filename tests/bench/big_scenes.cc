// big_scenes: scenes of thousands of bodies, stepped on Bullet's built-in narrowphase and on the plugin in turns, or on
// the plugin with one thread and with several. See --help.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/bench_world.h"
#include "bench/big_scene.h"
#include "bench/exit_status.h"
#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

using dgd_demos::Narrowphase;

constexpr const char* kDescription =
    R"(Simulates scenes of the kinds that Bullet's own benchmarks have, on Bullet's built-in narrowphase and on the
plugin, step by step in turns. With --threads also on the plugin with its own dispatcher, with so many threads; the two
worlds on the plugin must stay the same to the last bit.)";

constexpr const char* kFooter = R"(
Examples:
  big_scenes                                     all scenes, 20 s each, Bullet in float: some minutes
  big_scenes_float64 --scenes rubble ragdolls    two of them, Bullet in double
  big_scenes --scenes boxes --settle 10          both from where the built-in's bodies are after 10 s: the
                                                 same heap for both, where they would have made two
  big_scenes --threads 2                         the heap, also with the plugin's dispatcher on two threads
  big_scenes --threads 1 --scenes heap_8000_hulls --duration 10
                                                 what that dispatcher brings on one
  big_scenes --list                              what there is

Columns:  narrowphase and whole step in ms, means over all steps; ratio of the narrowphase's to the first row's; us
          per pair that was queried; rms speed of the moving bodies over the last second, m/s; when they came to
          rest: the last time that one in ten was faster than 5 cm/s, and the last time that their rms speed was
          (one ball that rolls on is enough for that); bodies awake at the end; bodies that fell through the floor
          or are not finite; fallbacks.

Exit status: 0; 1 the plugin lost more bodies than the built-in, or the worlds on the plugin differ; 2 wrong command
line.)";

struct Options {
  std::vector<std::string> scenes;
  double duration = 20;
  double settle = 0;  // s
  int threads = 0;    // 0: without the plugin's dispatcher.
  bool list = false;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr double kShortest = 0.1, kLongest = 3600;
  constexpr int kMostThreads = 64;
  Options options;
  std::vector<std::string> names;
  for (const BigScene& scene : BigScenes()) names.emplace_back(scene.name);
  dgd_demos::CommandLine line("big_scenes", kDescription, kFooter);
  line.AddChoices("--scenes", "NAME", options.scenes, names,
                  "Some of those that --list names; default: all but the heaps, or with --threads the heap");
  line.AddNumber("--duration", "S", options.duration, {kShortest, kLongest}, "Simulated seconds");
  line.AddNumber("--settle", "S", options.settle, {0, 1e4}, "Seconds on the built-in narrowphase first, for both");
  line.AddNumber("--threads", "N", options.threads, {1, kMostThreads}, "Adds the plugin's dispatcher");
  line.AddFlag("--list", options.list, "Lists the scenes");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  if (options.scenes.empty()) {
    for (const std::string& name : names) {
      if (options.threads > 0 ? name == "heap" : !name.starts_with("heap")) options.scenes.push_back(name);
    }
  }
  return options;
}

/// One narrowphase's world and run; the worlds are stepped in turns.
struct Side {
  Side(std::string name, Narrowphase narrowphase, int threads)
      : title(std::move(name)), world(std::make_unique<BenchWorld>(narrowphase, threads)) {}

  std::string title;
  std::unique_ptr<BenchWorld> world;
  double narrowphase_ms = 0, step_ms = 0;  // Sums.
  double queries = 0;
  double last_second_squares = 0;
  double rest_time = 0, rms_rest_time = 0;  // s
  WorldState end;
};

std::vector<Side> MakeSides(const Options& options) {
  std::vector<Side> sides;
  for (const Narrowphase narrowphase : {Narrowphase::kBuiltin, Narrowphase::kDgd}) {
    sides.emplace_back(std::string(NameOf(narrowphase)), narrowphase, 0);
  }
  if (options.threads > 0) {
    sides.emplace_back(std::to_string(options.threads) + " threads", Narrowphase::kDgd, options.threads);
  }
  return sides;
}

/// Whether two vectors have the same bits, except the fourth number, which is unused.
bool IsSame(const btVector3& a, const btVector3& b) { return std::memcmp(&a, &b, 3 * sizeof(btScalar)) == 0; }

bool HaveSamePoses(BenchWorld& a, BenchWorld& b) {
  const btCollisionObjectArray &of_a = a.world().getCollisionObjectArray(), &of_b = b.world().getCollisionObjectArray();
  for (int i = 0; i < of_a.size(); ++i) {
    const btTransform &pose_a = of_a[i]->getWorldTransform(), &pose_b = of_b[i]->getWorldTransform();
    if (!IsSame(pose_a.getOrigin(), pose_b.getOrigin())) return false;
    for (int row = 0; row < 3; ++row) {
      if (!IsSame(pose_a.getBasis()[row], pose_b.getBasis()[row])) return false;
    }
  }
  return true;
}

void Print(const BigScene& scene, int steps, const std::vector<Side>& sides) {
  std::printf("%s: %s; %d moving bodies\n", std::string(scene.name).c_str(), std::string(scene.summary).c_str(),
              sides[0].world->MovingBodies());
  for (const Side& side : sides) {
    std::printf("  %-12s%12.3f%9.2f%12.3f%9.3f%12.4f%9.2f%9.2f%8d%8d%11llu\n", side.title.c_str(),
                side.narrowphase_ms / steps, side.narrowphase_ms / sides[0].narrowphase_ms, side.step_ms / steps,
                1000 * side.narrowphase_ms / std::max(1.0, side.queries),
                std::sqrt(side.last_second_squares * BenchWorld::kTimeStep), side.rest_time, side.rms_rest_time,
                side.end.awake, side.end.lost,
                static_cast<unsigned long long>(dgd_demos::Fallbacks(side.world->configuration())));
  }
  std::fflush(stdout);
}

/// @return whether the plugin lost no more bodies than the built-in, and threads made no difference.
bool Simulate(const BigScene& scene, const Options& options) {
  constexpr double kAtRest = 0.05;  // m/s
  const auto steps_of = [](double seconds) { return static_cast<int>(std::lround(seconds / BenchWorld::kTimeStep)); };
  const double duration = options.duration;
  const int steps = std::max(1, steps_of(duration));
  std::vector<Side> sides = MakeSides(options);
  for (Side& side : sides) scene.build(*side.world);
  if (options.settle > 0) {
    BenchWorld first(Narrowphase::kBuiltin);
    scene.build(first);
    for (int step = 0; step < steps_of(options.settle); ++step) first.Step();
    for (Side& side : sides) side.world->TakePlacesFrom(first);
  }
  bool is_same = true;
  dgd_demos::ProgressBar progress(std::string(scene.name), duration);
  for (int step = 1; step <= steps; ++step) {
    const double time = step * BenchWorld::kTimeStep;
    for (Side& side : sides) {
      const StepCost cost = side.world->Step();
      side.narrowphase_ms += cost.narrowphase_ms;
      side.step_ms += cost.step_ms;
      side.queries += cost.queries;
      side.end = side.world->State();
      if (!(side.end.p90_speed <= kAtRest)) side.rest_time = time;
      if (!(side.end.rms_speed <= kAtRest)) side.rms_rest_time = time;
      if (time > duration - 1) side.last_second_squares += side.end.rms_speed * side.end.rms_speed;
    }
    if (options.threads > 0) is_same = is_same && HaveSamePoses(*sides[1].world, *sides[2].world);
    progress.Update(time);
  }
  Print(scene, steps, sides);
  if (options.threads > 0) {
    std::printf("  poses of all bodies after each step: %s\n", is_same ? "the same to the last bit" : "DIFFERENT");
  }
  return is_same && sides[1].end.lost <= sides[0].end.lost;
}

ExitStatus Run(const Options& options) {
  if (options.list) {
    for (const BigScene& scene : BigScenes()) {
      std::printf("%-18s%s\n", std::string(scene.name).c_str(), std::string(scene.summary).c_str());
    }
    return kSuccess;
  }
  std::printf("%g s in steps of 1/60 s, Bullet in %s\n", options.duration,
              sizeof(btScalar) == sizeof(double) ? "double" : "float");
  std::printf("%-14s%12s%9s%12s%9s%12s%9s%9s%8s%8s%11s\n", "", "narrowphase", "ratio", "step", "us/query", "last m/s",
              "rest s", "rms s", "awake", "lost", "fallbacks");
  bool is_good = true;
  for (const BigScene& scene : BigScenes()) {
    if (std::ranges::find(options.scenes, scene.name) == options.scenes.end()) continue;
    is_good = Simulate(scene, options) && is_good;
  }
  return is_good ? kSuccess : kFailedQuery;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
