#include "report/comparison_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace dgd_demos {
namespace {

struct Row {
  const char* title;   // For people, with the unit in which the figure is shown.
  const char* key;     // For programs, with the SI unit of the figure.
  const char* format;  // Of the figure in the title's unit.
  double unit;         // Title's unit in the key's.
  double (*figure)(const RunSummary&);
};

double PerStep(double sum, const RunSummary& run) { return sum / run.steps; }

// The one list of rows: the printed table and summary.csv both follow it.
constexpr std::array kRows = {
    Row{"deepest penetration, reported (cm)", "deepest_reported_penetration_m", "%.3f", 1e-2,
        [](const RunSummary& run) { return run.deepest_reported; }},
    Row{"deepest penetration, true (cm)", "deepest_true_penetration_m", "%.3f", 1e-2,
        [](const RunSummary& run) { return run.deepest_true; }},
    Row{"  the deepest of a step, mean (cm)", "mean_true_penetration_m", "%.4f", 1e-2,
        [](const RunSummary& run) { return run.mean_true; }},
    Row{"kinetic energy at the end (J)", "kinetic_energy_end_j", "%.4f", 1,
        [](const RunSummary& run) { return run.kinetic_energy_end; }},
    Row{"potential energy dissipated (%)", "potential_energy_dissipated_share", "%.2f", 1e-2,
        [](const RunSummary& run) { return run.dissipated_share; }},
    Row{"pairs of overlapping boxes", "pairs", "%.0f", 1,
        [](const RunSummary& run) { return static_cast<double>(run.pairs); }},
    Row{"  of these queried (not asleep)", "queries", "%.0f", 1,
        [](const RunSummary& run) { return static_cast<double>(run.queries); }},
    Row{"narrowphase per queried pair (us)", "narrowphase_us_per_query", "%.3f", 1,
        [](const RunSummary& run) { return run.narrowphase_us / static_cast<double>(run.queries); }},
    Row{"contacts, mean over steps", "contacts_mean", "%.1f", 1,
        [](const RunSummary& run) { return PerStep(static_cast<double>(run.contacts), run); }},
    Row{"fallbacks to GJK/EPA", "fallbacks", "%.0f", 1,
        [](const RunSummary& run) { return static_cast<double>(run.fallbacks); }},
    Row{"wall time of the steps (s)", "wall_time_s", "%.2f", 1, [](const RunSummary& run) { return run.wall_time; }},
};

constexpr int kTitleWidth = 36;
constexpr int kFigureWidth = 12;

std::string Format(const char* format, double number) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

std::string Right(const std::string& text) {
  return std::string(std::max(0, kFigureWidth - static_cast<int>(text.size())), ' ') + text;
}

std::string Left(std::string text) {
  text.resize(std::max<std::size_t>(text.size(), kTitleWidth), ' ');
  return text;
}

// Nothing has a ratio to nothing.
std::string Ratio(double numerator, double denominator) {
  const double ratio = numerator / denominator;
  return std::isfinite(ratio) ? Format("%.2f", ratio) : "-";
}

}  // namespace

std::string FormatTable(const std::vector<TableColumn>& columns) {
  const bool has_ratio = columns.size() == 2;
  std::string table = Left("");
  for (const TableColumn& column : columns) table += Right(column.narrowphase);
  if (has_ratio) table += Right("ratio");
  table += '\n';
  for (const Row& row : kRows) {
    table += Left(row.title);
    for (const TableColumn& column : columns) table += Right(Format(row.format, row.figure(column.summary) / row.unit));
    if (has_ratio) table += Right(Ratio(row.figure(columns[1].summary), row.figure(columns[0].summary)));
    table += '\n';
  }
  return table;
}

void WriteTableCsv(const std::filesystem::path& file, const std::vector<TableColumn>& columns) {
  std::ofstream stream(file);
  stream.precision(std::numeric_limits<double>::max_digits10);
  stream << "figure";
  for (const TableColumn& column : columns) stream << ',' << column.narrowphase;
  stream << '\n';
  for (const Row& row : kRows) {
    stream << row.key;
    for (const TableColumn& column : columns) stream << ',' << row.figure(column.summary);
    stream << '\n';
  }
  stream.close();
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace dgd_demos
