#include "bench/benchmark_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string_view>

namespace dgd_bench {
namespace {

constexpr std::size_t kTitleWidth = 34;

// Of kMethods.
constexpr std::size_t IndexOf(std::string_view key) {
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    if (key == kMethods[m].key) return m;
  }
  throw std::logic_error("no such method");
}
constexpr std::size_t kBullet = IndexOf("bullet_gjk_epa");
constexpr std::size_t kPlain = IndexOf("plain");
constexpr std::size_t kGrowthDistance = IndexOf("growth_distance");

// What the ratios are to.
struct Peers {
  Summary bullet, plain;
};

struct Column {
  const char* heading;  // Of this and the columns up to the next heading.
  const char* title;
  std::size_t width;
  const char* format;
  double (*figure)(const Summary& summary, const Peers& peers);
};

using S = Summary;

// The one list of columns.
constexpr std::array kColumns = {
    Column{"time (us)", "p50", 9, "%.3f", [](const S& s, const Peers&) { return s.p50; }},
    Column{"", "p99", 9, "%.3f", [](const S& s, const Peers&) { return s.p99; }},
    Column{"", "p99.99", 9, "%.3f", [](const S& s, const Peers&) { return s.p9999; }},
    Column{"", "max", 9, "%.3f", [](const S& s, const Peers&) { return s.slowest; }},
    Column{"to Bullet", "p50", 12, "%.3f", [](const S& s, const Peers& to) { return s.p50 / to.bullet.p50; }},
    Column{"to plain", "p50", 10, "%.3f", [](const S& s, const Peers& to) { return s.p50 / to.plain.p50; }},
    Column{"steps", "mean", 8, "%.1f", [](const S& s, const Peers&) { return s.mean_iterations; }},
    Column{"normal error (m)", "p99", 11, "%.1e", [](const S& s, const Peers&) { return s.normal_error_p99; }},
    Column{"", "max", 10, "%.1e", [](const S& s, const Peers&) { return s.normal_error_max; }},
    Column{"rel. gap", "max", 10, "%.1e", [](const S& s, const Peers&) { return s.relative_gap_max; }},
    Column{"infeas. (m)", "max", 13, "%.1e", [](const S& s, const Peers&) { return s.primal_infeasibility_max; }},
    Column{"no answer", "pairs", 12, "%.0f", [](const S& s, const Peers&) { return s.missing; }},
    Column{"failures", "pairs", 10, "%.0f", [](const S& s, const Peers&) { return s.failures; }},
};

std::string Format(const char* format, double number) {
  if (std::isnan(number)) return "-";
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

std::string Right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string Left(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

// A heading stands right-aligned over all its columns.
std::string HeadingLine() {
  std::string line = Left("", kTitleWidth);
  for (std::size_t first = 0; first < kColumns.size();) {
    std::size_t width = kColumns[first].width;
    std::size_t next = first + 1;
    for (; next < kColumns.size() && *kColumns[next].heading == '\0'; ++next) width += kColumns[next].width;
    line += Right(kColumns[first].heading, width);
    first = next;
  }
  return line + '\n';
}

std::string TitleLine() {
  std::string line = Left("", kTitleWidth);
  for (const Column& column : kColumns) line += Right(column.title, column.width);
  return line + '\n';
}

std::string MethodLine(const char* title, const Summary& summary, const Peers& peers) {
  std::string line = Left(std::string("  ") + title, kTitleWidth);
  for (const Column& column : kColumns) {
    line += Right(Format(column.format, column.figure(summary, peers)), column.width);
  }
  return line + '\n';
}

}  // namespace

std::string FormatTable(const std::vector<Block>& blocks) {
  std::string table = HeadingLine() + TitleLine();
  for (const Block& block : blocks) {
    table += std::string(block.distance_class->title) + '\n';
    const Peers peers{Summarize(block, kBullet), Summarize(block, kPlain)};
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
      table += MethodLine(kMethods[m].title, Summarize(block, m), peers);
    }
  }
  return table;
}

std::string FormatVerdict(const std::vector<Block>& blocks) {
  std::string ratios;
  std::size_t below = 0;
  for (const Block& block : blocks) {
    const double ratio = Summarize(block, kGrowthDistance).p50 / Summarize(block, kBullet).p50;
    ratios += Format(" %.2f", ratio);
    if (ratio < 1) ++below;
  }
  return std::string(kMethods[kGrowthDistance].title) + ", p50 to Bullet's:" + ratios + "; below 1 in " +
         std::to_string(below) + " of " + std::to_string(blocks.size()) + " classes\n";
}

std::string TableFooter() {
  return R"(to Bullet     p50 over that of Bullet's row in the same class
to plain      p50 over that of the paper's algorithm as printed (tests/bench/textbook)
steps         evaluations of the support functions
normal error  signed distance (exact, by separating axes) less the separation along the returned normal.
              GJK/EPA seeks the normal for which it vanishes. The growth distance does not: its normal is
              that one where the sets touch, and drifts from it with gap or depth, by where the centres lie.
rel. gap      growth distance over the one that the normal proves, less 1: the error of what it computes;
infeas.       how far its points are from their sets and, scaled, from each other: both by dgd/certificate.h
no answer     the solver reported no contact at any distance
failures      status other than optimal; for yes/no, the wrong answer
)";
}

}  // namespace dgd_bench
