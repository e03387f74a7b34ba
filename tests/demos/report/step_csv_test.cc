// Contract: what is written is on disk soon, complete, and reads back to the same bits.
#include "report/step_csv.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "small_scenes.h"

namespace dgd_demos {
namespace {

const RunInfo kInfo = {"my_scene.json", 7, "dgd", "double", "Debug"};

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> Cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ',');
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

TEST(StepCsvTest, Head_SaysWhatTheRunWas) {
  const TestFolder folder;
  const StepCsv csv(folder.path() / "run.csv", kInfo);
  const std::string text = ReadFile(folder.path() / "run.csv");
  for (const char* part : {"# scene: my_scene.json\n", "# seed: 7\n", "# narrowphase: dgd\n", "# precision: double\n",
                           "# build type: Debug\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
}

TEST(StepCsvTest, Row_ReadsBackToTheBit) {
  const TestFolder folder;
  StepCsv csv(folder.path() / "run.csv", kInfo);
  const StepRecord step{1.0 / 3, {std::sqrt(2), std::exp(1)}, {M_PI, 5, 4, 3, 1e-17 / 3, 2}, std::cbrt(7e-9)};
  csv.Write(step);
  csv.Flush();  // `csv` is still open below.

  const std::vector<std::string> lines = Lines(ReadFile(folder.path() / "run.csv"));
  const std::vector<std::string> names = Cells(lines[lines.size() - 2]), cells = Cells(lines.back());
  ASSERT_EQ(names.size(), 10u);
  ASSERT_EQ(cells.size(), names.size());
  const std::vector<std::pair<std::string, double>> expected = {{"time_s", step.time},
                                                                {"kinetic_energy_j", step.energy.kinetic},
                                                                {"potential_energy_j", step.energy.potential},
                                                                {"contacts", 3},
                                                                {"deepest_reported_penetration_m", 1e-17 / 3},
                                                                {"narrowphase_us", M_PI},
                                                                {"pairs", 5},
                                                                {"queries", 4},
                                                                {"fallbacks", 2},
                                                                {"deepest_true_penetration_m", std::cbrt(7e-9)}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(names[i], expected[i].first);
    EXPECT_EQ(std::stod(cells[i]), expected[i].second) << names[i];
  }
}

TEST(StepCsvTest, Rows_AreOnDiskWithinATenthOfASecond) {
  const TestFolder folder;
  StepCsv csv(folder.path() / "run.csv", kInfo);
  csv.Write({1, {0, 0}, {}, std::nullopt});
  std::this_thread::sleep_for(std::chrono::milliseconds(110));
  csv.Write({2, {0, 0}, {}, std::nullopt});
  EXPECT_EQ(Cells(Lines(ReadFile(folder.path() / "run.csv")).back())[0], "2");
}

TEST(StepCsvTest, OracleNotAsked_LeavesTheCellEmpty) {
  const TestFolder folder;
  StepCsv csv(folder.path() / "run.csv", kInfo);
  csv.Write({1, {0, 0}, {}, std::nullopt});
  csv.Flush();
  const std::vector<std::string> cells = Cells(Lines(ReadFile(folder.path() / "run.csv")).back());
  ASSERT_EQ(cells.size(), 10u);
  EXPECT_EQ(cells.back(), "");
}

TEST(StepCsvTest, FolderThatDoesNotExist_IsNamed) {
  try {
    const StepCsv csv("nowhere/run.csv", kInfo);
    FAIL() << "no complaint";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "nowhere/run.csv: cannot be written: No such file or directory");
  }
}

// For want of a small disk, a small file.
TEST(StepCsvTest, FullDisk_IsNoticedAtTheRow) {
  const TestFolder folder;
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small = {100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(StepCsv(folder.path() / "run.csv", kInfo), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
}

}  // namespace
}  // namespace dgd_demos
