#include "report/comparison_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "report/csv_file.h"
#include "report/figures.h"

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

std::string HeaderLine(const std::vector<TableColumn>& columns) {
  std::string line = Left("");
  for (std::size_t c = 0; c < columns.size(); ++c) {
    line += Right(columns[c].narrowphase);
    if (c > 0) line += Right("ratio");
  }
  return line + '\n';
}

std::string FigureLine(const Figure& figure, const std::vector<TableColumn>& columns) {
  std::string line = Left(figure.title);
  const double first = FigureOf(figure, columns.front().runs);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const double value = FigureOf(figure, columns[c].runs);
    line += Right(Format(figure.format, value / figure.unit));
    if (c > 0) line += Right(Ratio(value, first));
  }
  return line + '\n';
}

}  // namespace

std::string FormatTable(const std::vector<TableColumn>& columns) {
  std::string table = HeaderLine(columns);
  for (const Figure& figure : Figures()) table += FigureLine(figure, columns);
  return table;
}

void WriteTableCsv(const std::filesystem::path& file, const std::vector<TableColumn>& columns) {
  CsvFile csv(file);
  csv.stream() << "figure";
  for (const TableColumn& column : columns) csv.stream() << ',' << column.narrowphase;
  csv.stream() << '\n';
  for (const Figure& figure : Figures()) {
    csv.stream() << figure.key;
    for (const TableColumn& column : columns) csv.stream() << ',' << FigureOf(figure, column.runs);
    csv.stream() << '\n';
  }
  csv.Flush();
}

}  // namespace dgd_demos
