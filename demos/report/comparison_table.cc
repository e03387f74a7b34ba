#include "report/comparison_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "report/csv_file.h"

namespace dgd_demos {
namespace {

constexpr int kTitleWidth = 38;
constexpr int kFigureWidth = 12;

// Nothing, or never, is not a number to show.
std::string Format(const char* format, double number) {
  if (!std::isfinite(number)) return "-";
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

// Nothing has a ratio to nothing. A ratio to next to nothing has many digits, which would run into the next column.
std::string Ratio(double value, double first) {
  constexpr double kLongest = 1e4;
  const double ratio = value / first;
  return Format(std::abs(ratio) < kLongest ? "%.2f" : "%.2g", ratio);
}

std::string Right(const std::string& text) {
  return std::string(std::max(0, kFigureWidth - static_cast<int>(text.size())), ' ') + text;
}

std::string Left(std::string text) {
  text.resize(std::max<std::size_t>(text.size(), kTitleWidth), ' ');
  return text;
}

bool HasSpread(const std::vector<TableColumn>& columns) {
  return std::ranges::any_of(columns, [](const TableColumn& column) { return column.runs.size() > 1; });
}

std::string HeaderLine(const std::vector<TableColumn>& columns) {
  std::string line = Left("");
  for (std::size_t c = 0; c < columns.size(); ++c) {
    line += Right(columns[c].narrowphase);
    if (HasSpread(columns)) line += Right("IQR");
    if (c > 0) line += Right("ratio");
  }
  return line + '\n';
}

std::string FigureLine(std::size_t index, const std::vector<TableColumn>& columns) {
  const Figure& figure = Figures()[index];
  std::string line = Left(figure.title);
  const double first = FigureOf(index, columns.front().runs).value;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const FigureOverRuns figures = FigureOf(index, columns[c].runs);
    line += Right(Format(figure.format, figures.value / figure.unit));
    if (HasSpread(columns)) line += Right(Format(figure.format, figures.interquartile_range / figure.unit));
    if (c > 0) line += Right(Ratio(figures.value, first));
  }
  return line + '\n';
}

}  // namespace

std::string FormatTable(const std::vector<TableColumn>& columns) {
  std::string table = HeaderLine(columns);
  for (std::size_t i = 0; i < Figures().size(); ++i) table += FigureLine(i, columns);
  return table;
}

void WriteTableCsv(const std::filesystem::path& file, const std::vector<TableColumn>& columns) {
  CsvFile csv(file);
  csv << "figure";
  for (const TableColumn& column : columns) csv << ',' << column.narrowphase;
  csv << '\n';
  for (std::size_t i = 0; i < Figures().size(); ++i) {
    csv << Figures()[i].key;
    for (const TableColumn& column : columns) csv << ',' << FigureOf(i, column.runs).value;
    csv << '\n';
  }
  csv.Flush();
}

}  // namespace dgd_demos
