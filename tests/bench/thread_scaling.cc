// thread_scaling: the plugin's pairs shared among threads, against one thread, in two worlds that must stay the same to
// the last bit. See --help.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>
#include <variant>

#include "bench/bench_world.h"
#include "bench/big_scene.h"
#include "bench/duration_option.h"
#include "bench/exit_status.h"
#include "command_line.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Lets shapes of all kinds fall into a heap twice, step by step in turns: with the plugin's pairs on one thread,
and shared among several. The two worlds must stay the same to the last bit.)";

constexpr const char* kFooter = R"(
Examples:
  thread_scaling                         two threads, 6 s
  thread_scaling_float64 --threads 4     four, Bullet in double

Exit status: 0; 1 the worlds differ; 2 wrong command line.)";

struct Options {
  int threads = 2;
  int bodies = 2000;
  double duration = 6;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMostThreads = 256, kMostBodies = 100000;
  Options options;
  dgd_demos::CommandLine line("thread_scaling", kDescription, kFooter);
  line.AddNumber("--threads", "N", options.threads, {1, kMostThreads}, "Threads");
  line.AddNumber("--bodies", "N", options.bodies, {1, kMostBodies}, "Shapes that fall");
  AddDurationOption(line, options.duration);
  if (const std::optional<int> end = line.Parse(argc, argv)) return ExitStatus(*end);
  return options;
}

/// Whether two numbers have the same bits; the fourth of a vector is of no account.
bool IsSame(const btVector3& a, const btVector3& b) { return std::memcmp(&a, &b, 3 * sizeof(btScalar)) == 0; }

bool AreSame(BenchWorld& a, BenchWorld& b) {
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

ExitStatus Run(const Options& options) {
  const int steps = std::max(1, static_cast<int>(std::lround(options.duration / BenchWorld::kTimeStep)));
  BenchWorld alone(dgd_demos::Narrowphase::kDgd), shared(dgd_demos::Narrowphase::kDgd, options.threads);
  for (BenchWorld* world : {&alone, &shared}) BuildHeap(*world, options.bodies);
  dgd_demos::ProgressBar progress("stepping", options.duration);
  double alone_ms = 0, shared_ms = 0, queries = 0;
  bool same = true;
  for (int step = 1; step <= steps && same; ++step) {
    const StepCost cost = alone.Step();
    alone_ms += cost.narrowphase_ms;
    queries += cost.queries;
    shared_ms += shared.Step().narrowphase_ms;
    same = AreSame(alone, shared);
    progress.Update(step * BenchWorld::kTimeStep);
  }
  std::printf("%d bodies, %d steps, %.0f pairs a step, Bullet in %s; this machine has %u processors\n",
              alone.MovingBodies(), steps, queries / steps, sizeof(btScalar) == sizeof(double) ? "double" : "float",
              std::thread::hardware_concurrency());
  std::printf("narrowphase, ms a step: one thread %.3f, %d threads %.3f: %.2f times as fast\n", alone_ms / steps,
              options.threads, shared_ms / steps, alone_ms / shared_ms);
  std::printf("poses of all bodies after each step: %s\n", same ? "the same to the last bit" : "DIFFERENT");
  return same ? kSuccess : kFailedQuery;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
