// big_scenes: scenes of thousands of bodies, stepped on Bullet's built-in narrowphase and on the plugin in turns. See
// --help.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/bench_world.h"
#include "bench/big_scene.h"
#include "bench/duration_option.h"
#include "bench/exit_status.h"
#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

using dgd_demos::Narrowphase;

constexpr const char* kDescription =
    R"(Simulates scenes of the kinds that Bullet's own benchmarks have, on Bullet's built-in narrowphase and on the
plugin, step by step in turns.)";

constexpr const char* kFooter = R"(
Examples:
  big_scenes                                     all scenes, 20 s each, Bullet in float: some minutes
  big_scenes_float64 --scenes rubble ragdolls    two of them, Bullet in double
  big_scenes --scenes boxes --settle 10          both from where the built-in's bodies are after 10 s: the
                                                 same heap for both, where they would have made two
  big_scenes --list                              what there is

Columns:  narrowphase and whole step in ms, means over all steps; ratio of the narrowphase's to the built-in's; us
          per pair that was queried; rms speed of the moving bodies over the last second, m/s; when they came to
          rest: the last time that one in ten was faster than 5 cm/s, and the last time that their rms speed was
          (one ball that rolls on is enough for that); bodies awake at the end; bodies that fell through the floor
          or are not finite; fallbacks.

Exit status: 0; 1 the plugin lost more bodies than the built-in; 2 wrong command line.)";

struct Options {
  std::vector<std::string> scenes;
  double duration = 20;
  double settle = 0;  // s
  bool list = false;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  Options options;
  std::vector<std::string> names;
  for (const BigScene& scene : BigScenes()) names.emplace_back(scene.name);
  dgd_demos::CommandLine line("big_scenes", kDescription, kFooter);
  line.AddChoices("--scenes", "NAME", options.scenes, names, "Some of those that --list names; default: all");
  AddDurationOption(line, options.duration);
  line.AddNumber("--settle", "S", options.settle, {0, 1e4}, "Seconds on the built-in narrowphase first, for both");
  line.AddFlag("--list", options.list, "Lists the scenes");
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  if (options.scenes.empty()) options.scenes = names;
  return options;
}

constexpr std::array kNarrowphases = {Narrowphase::kBuiltin, Narrowphase::kDgd};

/// One narrowphase's run.
struct Tally {
  double narrowphase_ms = 0, step_ms = 0;  // Sums.
  double queries = 0;
  double last_second_squares = 0;
  double rest_time = 0, rms_rest_time = 0;  // s
  WorldState end;
};

void Print(const BigScene& scene, int steps, int bodies, const std::array<Tally, kNarrowphases.size()>& runs,
           const std::array<std::uint64_t, kNarrowphases.size()>& fallbacks) {
  std::printf("%s: %s; %d moving bodies\n", std::string(scene.name).c_str(), std::string(scene.summary).c_str(),
              bodies);
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const Tally& run = runs[n];
    std::printf("  %-12s%12.3f%9.2f%12.3f%9.3f%12.4f%9.2f%9.2f%8d%8d%11llu\n",
                std::string(NameOf(kNarrowphases[n])).c_str(), run.narrowphase_ms / steps,
                run.narrowphase_ms / runs[0].narrowphase_ms, run.step_ms / steps,
                1000 * run.narrowphase_ms / std::max(1.0, run.queries),
                std::sqrt(run.last_second_squares * BenchWorld::kTimeStep), run.rest_time, run.rms_rest_time,
                run.end.awake, run.end.lost, static_cast<unsigned long long>(fallbacks[n]));
  }
  std::fflush(stdout);
}

/// @return whether the plugin lost no more bodies than the built-in.
bool Simulate(const BigScene& scene, const Options& options) {
  constexpr double kAtRest = 0.05;  // m/s
  const auto steps_of = [](double seconds) { return static_cast<int>(std::lround(seconds / BenchWorld::kTimeStep)); };
  const double duration = options.duration;
  const int steps = std::max(1, steps_of(duration));
  std::array<BenchWorld, kNarrowphases.size()> worlds{BenchWorld(kNarrowphases[0]), BenchWorld(kNarrowphases[1])};
  for (BenchWorld& world : worlds) scene.build(world);
  if (options.settle > 0) {
    BenchWorld first(Narrowphase::kBuiltin);
    scene.build(first);
    for (int step = 0; step < steps_of(options.settle); ++step) first.Step();
    for (BenchWorld& world : worlds) world.TakePlacesFrom(first);
  }
  std::array<Tally, kNarrowphases.size()> runs;
  dgd_demos::ProgressBar progress(std::string(scene.name), duration);
  for (int step = 1; step <= steps; ++step) {
    const double time = step * BenchWorld::kTimeStep;
    for (std::size_t n = 0; n < worlds.size(); ++n) {
      Tally& run = runs[n];
      const StepCost cost = worlds[n].Step();
      run.narrowphase_ms += cost.narrowphase_ms;
      run.step_ms += cost.step_ms;
      run.queries += cost.queries;
      run.end = worlds[n].State();
      if (!(run.end.p90_speed <= kAtRest)) run.rest_time = time;
      if (!(run.end.rms_speed <= kAtRest)) run.rms_rest_time = time;
      if (time > duration - 1) run.last_second_squares += run.end.rms_speed * run.end.rms_speed;
    }
    progress.Update(time);
  }
  Print(scene, steps, worlds[0].MovingBodies(), runs,
        {dgd_demos::Fallbacks(worlds[0].configuration()), dgd_demos::Fallbacks(worlds[1].configuration())});
  return runs[1].end.lost <= runs[0].end.lost;
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
  bool none_lost = true;
  for (const BigScene& scene : BigScenes()) {
    if (std::ranges::find(options.scenes, scene.name) == options.scenes.end()) continue;
    none_lost = Simulate(scene, options) && none_lost;
  }
  return none_lost ? kSuccess : kFailedQuery;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
