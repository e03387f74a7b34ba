// hull_pairs: the growth distance against Bullet's GJK/EPA, pair by pair of random hulls. See --help.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_options.h"
#include "bench/benchmark_csv.h"
#include "bench/benchmark_table.h"
#include "bench/measurement.h"
#include "bench/peers/bullet_peers.h"
#include "program_main.h"
#include "report/progress_bar.h"

namespace dgd_bench {
namespace {

// The pairs of a class come from a stream of their own: the same whatever classes and margins run beside it.
Block MeasureBlock(const BenchOptions& options, std::size_t class_index, double margin,
                   dgd_demos::ProgressBar& progress) {
  const DistanceClass& distance_class = kDistanceClasses[class_index];
  Block block{&distance_class, margin, {}};
  block.rows.reserve(static_cast<std::size_t>(options.pairs));
  dgd_demos::Random random(options.seed, static_cast<std::uint32_t>(class_index));
  for (int i = 0; i < options.pairs; ++i) {
    block.rows.push_back(Measure(DrawHullPair(random, distance_class, options.distance_of, margin), options.effort));
    progress.Update(static_cast<double>(class_index) + static_cast<double>(i) / options.pairs);
  }
  return block;
}

std::vector<Block> MeasureMargin(const BenchOptions& options, double margin) {
  dgd_demos::ProgressBar progress("margin " + std::to_string(margin) + " m", kDistanceClasses.size());
  std::vector<Block> blocks;
  for (std::size_t c = 0; c < kDistanceClasses.size(); ++c) {
    blocks.push_back(MeasureBlock(options, c, margin, progress));
  }
  return blocks;
}

bool HasFailures(const std::vector<Block>& blocks) {
  for (const Block& block : blocks) {
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
      if (kMethods[m].must_not_fail && Summarize(block, m).failures > 0) return true;
    }
  }
  return false;
}

ExitStatus Run(const BenchOptions& options) {
  std::optional<BenchmarkCsv> csv;
  if (!options.csv.empty()) csv.emplace(options.csv, options);

  std::printf(
      "Pairs of hulls, %d..%d vertices, %g m across; %d pairs a class, seed %llu, Bullet in %s, distance of %s\n",
      kLeastVertices, kMostVertices, kHullDiameter, options.pairs, static_cast<unsigned long long>(options.seed),
      BulletPrecision(), NameOf(options.distance_of));
  ExitStatus status = kSuccess;
  for (const double margin : options.margins) {
    const std::vector<Block> blocks = MeasureMargin(options, margin);
    std::printf("\nmargin %g m\n%s%s", margin, FormatTable(blocks).c_str(), FormatVerdict(blocks).c_str());
    std::fflush(stdout);
    if (csv) {
      for (const Block& block : blocks) csv->Write(block);
    }
    if (HasFailures(blocks)) status = kFailedQuery;
  }
  std::printf("\n%s", TableFooter().c_str());
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
