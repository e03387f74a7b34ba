// speed: the growth distance against the paper's algorithm as printed, class by class of sets, time beside error. See
// --help.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/class_options.h"
#include "bench/exit_status.h"
#include "bench/growth_methods.h"
#include "bench/percentile.h"
#include "bench/speed_pair.h"
#include "program_main.h"
#include "report/progress_bar.h"
#include "support/pairs/tally.h"

namespace dgd_bench {
namespace {

constexpr const char* kDescription =
    R"(Times the growth distance on random pairs of sets in random poses, beside the paper's algorithm as it
is printed: virtual support functions, margins inside them, coordinates of the world. Both ask the same
code for points of the cores, in double, on the same pairs, in turns. What the answers are worth is told
by the same certificate.)";

constexpr const char* kExamples = R"(
Examples:
  speed                             all classes: two minutes
  speed --classes sharp-hulls       one of them
  speed --pairs 20 --poses 5        a first look: a second
  speed --classes meshes --meshes DIR
                                    pairs of the hulls of all .obj files in DIR and below
)";

constexpr const char* kFooter =
    R"(Rows:     cold; warm, from the answer at a pose 1 % of the extent and 0.01 rad away; and the collision
          check, cold; each followed by the plain algorithm's.
Columns:  times over all pairs and poses, each the least of --rounds means of --repeats queries, in us,
          percentiles by nearest rank; the row's p50 over the plain algorithm's; iterations are
          evaluations of the support functions; the worst relative gap, and the worst primal
          infeasibility as a part of the pair's size; answers that are not optimal, of checks the wrong
          or undecided ones.

Exit status: 0 all of our answers optimal and right; 1 some not; 2 wrong command line, or a mesh cannot
be read.)";

struct Options : ClassOptions {
  Options() {
    pairs = 200;
    poses = 20;
  }

  int repeats = 10, rounds = 3;
};

std::variant<Options, ExitStatus> ParseCommandLine(int argc, const char* const* argv) {
  constexpr int kMost = 100'000;
  Options options;
  CLI::App app(kDescription, "speed");
  app.footer(kExamples + ClassesInWords() + kFooter);
  AddClassOptions(app, options);
  app.add_option("--repeats", options.repeats, "Queries in a row, of which the mean is taken")
      ->type_name("N")
      ->check(CLI::Range(1, kMost).description(""))
      ->capture_default_str();
  app.add_option("--rounds", options.rounds, "Turns of all methods, of which each one's least mean counts")
      ->type_name("N")
      ->check(CLI::Range(1, kMost).description(""))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& end) {
    return app.exit(end, std::cout, std::cerr) == 0 ? kSuccess : kBadInput;
  }
  return options;
}

/// What a row of a class's table shows.
struct RowKind {
  const char* title;
  SpeedQuestion question;
};

/// Ours, each followed by its yardstick.
constexpr std::array kRowKinds = {
    RowKind{"cold", {.method = SpeedMethod::kOurs}},
    RowKind{"  plain", {.method = SpeedMethod::kPlain}},
    RowKind{"warm", {.method = SpeedMethod::kOurs, .start = kWarmStart}},
    RowKind{"  plain", {.method = SpeedMethod::kPlain, .start = kWarmStart}},
    RowKind{"collision check, cold", {.method = SpeedMethod::kOurs, .is_check = true}},
    RowKind{"  plain", {.method = SpeedMethod::kPlain, .is_check = true}},
};
constexpr std::size_t kColdRow = 0, kWarmRow = 2, kCheckRow = 4;

/// One method on all pairs and poses of a class.
struct Row {
  std::vector<double> microseconds;
  double iterations = 0;  // Of all.
  dgd_test::Worst relative_gap, primal_infeasibility;
  int failures = 0;

  void Take(double time, const SpeedAnswer& answer) {
    microseconds.push_back(time);
    iterations += answer.iterations;
    const auto index = static_cast<std::int64_t>(microseconds.size());
    relative_gap.Take(answer.relative_gap, index);
    primal_infeasibility.Take(answer.primal_infeasibility / answer.size, index);
    if (answer.is_failure) ++failures;
  }
};
using Rows = std::array<Row, kRowKinds.size()>;

template <int L>
void Measure(const SpeedPair<L>& pair, const Options& options, Rows& rows) {
  std::array<double, kRowKinds.size()> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t m = 0; m < rows.size(); ++m) {
      least[m] = std::min(least[m], pair.Time(kRowKinds[m].question, options.repeats));
    }
  }
  for (std::size_t m = 0; m < rows.size(); ++m) rows[m].Take(least[m], pair.Judge(kRowKinds[m].question));
}

template <int L>
Rows MeasureClass(const PairClass& each, const Meshes& meshes, const Options& options) {
  Rows rows;
  dgd_demos::ProgressBar progress(each.name, 1);
  dgd_test::Random random(options.seed);
  const int pairs = std::max(1, options.pairs / each.poses_factor);
  const int poses = options.pairs * options.poses / pairs;
  for (int i = 0; i < pairs; ++i) {
    const dgd_test::PairNumbers numbers = each.draw_sets(random, meshes);
    const auto pair = MakeSpeedPair<L>(numbers.set_1, numbers.set_2);
    const double extent = pair->Extent();
    for (int j = 0; j < poses; ++j) {
      const PairPoses drawn = DrawPoses(random, L, extent);
      pair->MoveTo(drawn.pose_1, drawn.last_pose_2, drawn.pose_2);
      Measure(*pair, options, rows);
    }
    progress.Update(static_cast<double>(i + 1) / pairs);
  }
  for (Row& row : rows) std::ranges::sort(row.microseconds);
  return rows;
}

void Print(const PairClass& each, const Rows& rows) {
  std::printf("%s: %s\n", each.name, each.title);
  for (std::size_t m = 0; m < rows.size(); ++m) {
    const Row& row = rows[m];
    const SpeedQuestion& question = kRowKinds[m].question;
    const bool is_plain = question.method == SpeedMethod::kPlain, is_check = question.is_check;
    std::printf("  %-24s%9.3f%9.3f%9.3f", kRowKinds[m].title, Percentile(row.microseconds, 0.5),
                Percentile(row.microseconds, 0.99), Percentile(row.microseconds, 0.9999));
    if (is_plain) {
      std::printf("%10s", "");
    } else {
      std::printf("%10.2f", Percentile(row.microseconds, 0.5) / Percentile(rows[m + 1].microseconds, 0.5));
    }
    if (is_check) {
      std::printf("%8s%10s%10s", "", "", "");
    } else {
      std::printf("%8.2f%10.1e%10.1e", row.iterations / static_cast<double>(row.microseconds.size()),
                  row.relative_gap.figure, row.primal_infeasibility.figure);
    }
    std::printf("%10d\n", row.failures);
  }
  std::fflush(stdout);
}

/// The exponent of a power of the vertex count, from the first class to the last.
double Growth(const PairClass& first, const Rows& rows_first, const PairClass& last, const Rows& rows_last,
              std::size_t row) {
  const auto p50 = [&](const Rows& rows) { return Percentile(rows[row].microseconds, 0.5); };
  return std::log(p50(rows_last) / p50(rows_first)) / std::log(double(last.vertices) / first.vertices);
}

/// Time against vertex count, of the classes that differ in nothing else.
void PrintGrowth(const std::vector<std::pair<const PairClass*, Rows>>& measured) {
  if (measured.size() < 2) return;
  const PairClass &first = *measured.front().first, &last = *measured.back().first;
  const Rows &rows_first = measured.front().second, &rows_last = measured.back().second;
  const auto growth = [&](std::size_t row) { return Growth(first, rows_first, last, rows_last, row); };
  std::printf("From %d to %d vertices, times grow as n to the power of: cold %.2f, warm %.2f, collision check %.2f; ",
              first.vertices, last.vertices, growth(kColdRow), growth(kWarmRow), growth(kCheckRow));
  std::printf("plain %.2f, %.2f, %.2f\n", growth(kColdRow + 1), growth(kWarmRow + 1), growth(kCheckRow + 1));
}

ExitStatus Run(const Options& options) {
  dgd_test::Random random(options.seed);
  const Meshes meshes = MakeMeshes(options, random);
  std::printf("%d pairs x %d poses a class, seed %llu; times in us\n", options.pairs, options.poses,
              static_cast<unsigned long long>(options.seed));
  std::printf("%-26s%9s%9s%9s%10s%8s%10s%10s%10s\n", "", "p50", "p99", "p99.99", "to plain", "iter.", "gap", "primal",
              "failures");
  ExitStatus status = kSuccess;
  std::vector<std::pair<const PairClass*, Rows>> by_vertices;
  for (const PairClass& each : AllPairClasses()) {
    if (!options.Wants(each)) continue;
    const Rows rows =
        each.dimension == 2 ? MeasureClass<2>(each, meshes, options) : MeasureClass<3>(each, meshes, options);
    Print(each, rows);
    if (each.vertices > 0) by_vertices.emplace_back(&each, rows);
    for (std::size_t m = 0; m < rows.size(); m += 2) {
      if (rows[m].failures > 0) status = kFailedQuery;
    }
  }
  PrintGrowth(by_vertices);
  return status;
}

}  // namespace
}  // namespace dgd_bench

int main(int argc, char** argv) {
  return dgd_demos::RunProgram(dgd_bench::ParseCommandLine(argc, argv), dgd_bench::Run);
}
