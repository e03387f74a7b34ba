#include "soak/soak_report.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "soak/soak_case.h"

namespace dgd_soak {
namespace {

using dgd_test::Tally;
using dgd_test::Worst;

constexpr std::size_t kNameWidth = 34;
constexpr double kTail = 0.9999;

struct Column {
  const char* title;
  const char* csv_name;
  std::size_t width;
  const char* format;
  double (*figure)(const Tally& tally);
  Worst Tally::*worst = nullptr;  ///< Whose case the CSV file names.
};

double Number(std::int64_t count) { return static_cast<double>(count); }

// The one list of columns.
constexpr std::array kColumns = {
    Column{"pairs", "pairs", 11, "%.0f", [](const Tally& t) { return Number(t.pairs); }},
    Column{"queries", "queries", 11, "%.0f", [](const Tally& t) { return Number(t.queries); }},
    Column{"steps mean", "iterations_mean", 12, "%.2f", [](const Tally& t) { return t.MeanIterations(); }},
    Column{"p99.99", "iterations_p9999", 8, "%.0f",
           [](const Tally& t) { return Number(t.IterationPercentile(kTail)); }},
    Column{"max", "iterations_max", 5, "%.0f", [](const Tally& t) { return Number(t.IterationPercentile(1)); }},
    Column{"gap", "relative_gap_max", 10, "%.1e", [](const Tally& t) { return t.relative_gap.figure; },
           &Tally::relative_gap},
    Column{"primal", "relative_primal_infeasibility_max", 10, "%.1e",
           [](const Tally& t) { return t.primal_infeasibility.figure; }, &Tally::primal_infeasibility},
    Column{"dual", "dual_infeasibility_max", 10, "%.1e", [](const Tally& t) { return t.dual_infeasibility.figure; },
           &Tally::dual_infeasibility},
    Column{"separation", "relative_separation_error_max", 12, "%.1e",
           [](const Tally& t) { return t.separation_error.figure; }, &Tally::separation_error},
    Column{"error", "relative_growth_distance_error_max", 10, "%.1e",
           [](const Tally& t) { return t.growth_distance_error.figure; }, &Tally::growth_distance_error},
    Column{"not optimal", "non_optimal", 13, "%.0f", [](const Tally& t) { return Number(t.non_optimal); }},
    Column{"not monotone", "non_monotone", 14, "%.0f", [](const Tally& t) { return Number(t.non_monotone); }},
    Column{"yes/no", "disagreements", 8, "%.0f", [](const Tally& t) { return Number(t.disagreements); }},
    Column{"FAILED", "failed_pairs", 8, "%.0f", [](const Tally& t) { return Number(t.failed_pairs); }},
};

std::string Right(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 1, ' ') + text;
}

std::string Left(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string TitleLine(const char* scalar) {
  std::string line = Left(scalar, kNameWidth);
  for (const Column& column : kColumns) line += Right(column.title, column.width);
  return line + '\n';
}

std::string Line(const std::string& name, const Tally& tally) {
  std::string line = Left("  " + name, kNameWidth);
  for (const Column& column : kColumns) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), column.format, column.figure(tally));
    line += Right(text.data(), column.width);
  }
  return line + '\n';
}

std::string NameOf(const TypePair& pair) {
  return std::string(dgd_test::InfoOf(pair.type_1).name) + "-" + dgd_test::InfoOf(pair.type_2).name;
}

struct Class {
  const char* name;
  bool (*has)(const TypePair& pair);
};
constexpr std::array kClasses = {
    Class{"all curved", [](const TypePair& pair) { return pair.Dimension() == 3 && pair.IsCurved(); }},
    Class{"all polytopes, meshes", [](const TypePair& pair) { return pair.Dimension() == 3 && !pair.IsCurved(); }},
    Class{"all 2D", [](const TypePair& pair) { return pair.Dimension() == 2; }},
};

std::string Table(const char* scalar, const std::vector<Tally>& tallies) {
  std::string table = TitleLine(scalar);
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    if (tallies[i].pairs > 0) table += Line(NameOf(AllTypePairs()[i]), tallies[i]);
  }
  for (const Class& each : kClasses) {
    Tally sum;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      if (each.has(AllTypePairs()[i])) sum.Merge(tallies[i]);
    }
    if (sum.pairs > 0) table += Line(each.name, sum);
  }
  return table + '\n';
}

/// The scalars that the options choose, with their tallies.
std::vector<std::pair<const char*, const std::vector<Tally>*>> Tables(const SoakState& state,
                                                                      const SoakOptions& options) {
  std::vector<std::pair<const char*, const std::vector<Tally>*>> tables;
  if (options.in_double) tables.emplace_back("double", &state.in_double);
  if (options.in_float) tables.emplace_back("float", &state.in_float);
  return tables;
}

}  // namespace

std::string FormatReport(const SoakState& state, const SoakOptions& options) {
  std::string report;
  for (const auto& [scalar, tallies] : Tables(state, options)) report += Table(scalar, *tallies);
  if (!HasFailures(state)) return report + "no case failed\n";
  report += "failed, the first of them:\n";
  for (const std::int64_t index : state.failures) {
    report += "  dgd_soak " + state.case_options + " --replay " + std::to_string(index) + '\n';
  }
  return report;
}

void WriteCsv(const SoakState& state, const SoakOptions& options, const std::filesystem::path& file) {
  std::ofstream out(file);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "# dgd_soak " << state.case_options << "\n# pairs: " << state.done << "\nscalar,type_1,type_2";
  for (const Column& column : kColumns) {
    out << ',' << column.csv_name;
    if (column.worst != nullptr) out << ',' << column.csv_name << "_case";
  }
  out << '\n';
  for (const auto& [scalar, tallies] : Tables(state, options)) {
    for (std::size_t i = 0; i < tallies->size(); ++i) {
      const Tally& tally = (*tallies)[i];
      if (tally.pairs == 0) continue;
      out << scalar << ',' << dgd_test::InfoOf(AllTypePairs()[i].type_1).name << ','
          << dgd_test::InfoOf(AllTypePairs()[i].type_2).name;
      for (const Column& column : kColumns) {
        out << ',' << column.figure(tally);
        if (column.worst != nullptr) out << ',' << (tally.*column.worst).index;
      }
      out << '\n';
    }
  }
  out.flush();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(errno));
}

bool HasFailures(const SoakState& state) { return !state.failures.empty(); }

}  // namespace dgd_soak
