// Contract: a row a figure, a column a run, each in the unit of its row's name; the ratio only where it means
// something.
#include "report/comparison_table.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "small_scenes.h"

namespace dgd_demos {
namespace {

RunSummary ExampleRun(double scale) {
  RunSummary summary;
  summary.steps = 10;
  summary.deepest_reported = 0.02 * scale;
  summary.deepest_true = 0.03 * scale;
  summary.mean_true = 0.001 * scale;
  summary.kinetic_energy_end = 0;
  summary.dissipated_share = 0.9;
  summary.pairs = 1000;
  summary.queries = 500;
  summary.narrowphase_us = 400 * scale;
  summary.contacts = 70;
  summary.fallbacks = 0;
  summary.wall_time = 1.5;
  return summary;
}

FigureValues ExampleSummary(double scale) { return FiguresOf(ExampleRun(scale)); }

// The row of the table that starts with `title`, its cells separated by single blanks.
std::string CellsOf(const std::string& table, const std::string& title) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(title) == std::string::npos) continue;
    std::istringstream words(line.substr(line.find(title) + title.size()));
    std::string cells;
    for (std::string word; words >> word;) cells += (cells.empty() ? "" : " ") + word;
    return cells;
  }
  return "no such row";
}

TEST(ComparisonTableTest, TwoRuns_FiguresInTheirUnitsAndTheirRatio) {
  const std::string table = FormatTable({{"builtin", {ExampleSummary(1)}}, {"dgd", {ExampleSummary(0.5)}}});
  EXPECT_EQ(CellsOf(table, "builtin"), "dgd ratio");
  EXPECT_EQ(CellsOf(table, "deepest penetration, reported (cm)"), "2.000 1.000 0.50");
  EXPECT_EQ(CellsOf(table, "deepest penetration, true (cm)"), "3.000 1.500 0.50");
  EXPECT_EQ(CellsOf(table, "energy dissipated (%)"), "90.00 90.00 1.00");
  EXPECT_EQ(CellsOf(table, "narrowphase per queried pair (us)"), "0.800 0.400 0.50");
  EXPECT_EQ(CellsOf(table, "contacts, mean over steps"), "7.0 7.0 1.00");
  EXPECT_EQ(CellsOf(table, "fallbacks to GJK/EPA"), "0 0 -") << "nothing has a ratio to nothing";
}

TEST(ComparisonTableTest, OneRun_HasNoRatio) {
  const std::string table = FormatTable({{"dgd", {ExampleSummary(1)}}});
  EXPECT_EQ(table.substr(0, table.find('\n')).find("ratio"), std::string::npos);
  EXPECT_EQ(CellsOf(table, "deepest penetration, true (cm)"), "3.000");
}

TEST(ComparisonTableTest, WhatNeverCameOrWasNotMeasured_IsADash) {
  const std::string table = FormatTable({{"builtin", {ExampleSummary(1)}}, {"dgd", {ExampleSummary(1)}}});
  EXPECT_EQ(CellsOf(table, "time to rest (s)"), "- - -");
  EXPECT_EQ(CellsOf(table, "the deepest in the last second (cm)"), "- - -");
}

TEST(ComparisonTableTest, ThreeColumns_EachLaterOneHasItsRatioToTheFirst) {
  const std::string table =
      FormatTable({{"builtin", {ExampleSummary(1)}}, {"dgd", {ExampleSummary(0.5)}}, {"other", {ExampleSummary(2)}}});
  EXPECT_EQ(CellsOf(table, "builtin"), "dgd ratio other ratio");
  EXPECT_EQ(CellsOf(table, "deepest penetration, true (cm)"), "3.000 1.500 0.50 6.000 2.00");
}

TEST(ComparisonTableTest, SeveralSeeds_MedianOfFiguresAndSumOfWhatShouldNotHappen) {
  RunSummary odd = ExampleRun(5);
  odd.fallbacks = 2;
  odd.lost_bodies = 1;
  odd.deepest_at_rest = 0.04;  // The others have no such figure.
  const std::vector<FigureValues> runs = {FiguresOf(odd), ExampleSummary(1), ExampleSummary(2)};
  const std::string table = FormatTable({{"dgd", runs}});
  EXPECT_EQ(CellsOf(table, "deepest penetration, true (cm)"), "6.000 6.000")
      << "3, 6 and 15 cm, half of them in 4.5 to 10.5";
  EXPECT_EQ(CellsOf(table, "the deepest in the last second (cm)"), "4 -");
  EXPECT_EQ(CellsOf(table, "fallbacks to GJK/EPA"), "2 -");
  EXPECT_EQ(CellsOf(table, "bodies lost"), "1 -");
  EXPECT_EQ(CellsOf(FormatTable({{"dgd", {ExampleSummary(1), ExampleSummary(2)}}}), "deepest penetration, true (cm)"),
            "4.500 1.500");
}

TEST(ComparisonTableTest, Csv_HasTheSameFiguresInSi) {
  const TestFolder folder;
  WriteTableCsv(folder.path() / "summary.csv", {{"builtin", {ExampleSummary(1)}}, {"dgd", {ExampleSummary(0.5)}}});
  const std::string csv = ReadFile(folder.path() / "summary.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "figure,builtin,dgd");
  EXPECT_NE(csv.find("\ndeepest_true_penetration_m,0.03,0.015\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\nnarrowphase_us_per_query,0.8,0.4\n"), std::string::npos) << csv;
}

}  // namespace
}  // namespace dgd_demos
