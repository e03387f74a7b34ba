// The program as its users run it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "apps/apps.h"
#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;

Outcome RunReport(const std::string& arguments) { return dgd_test::RunProgram(DGD_TEST_PROGRAM_APPS, arguments); }

TEST(AppsReport, Help_NamesEveryApp) {
  const Outcome outcome = RunReport("--help");
  EXPECT_EQ(outcome.status, 0);
  for (const auto& app : dgd_apps::Apps())
    EXPECT_NE(outcome.output.find("  " + std::string(app.name) + " "), std::string::npos) << app.name;
}

TEST(AppsReport, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments :
       {"--apps none", "--rates 0", "--rates x", "--csv /no/such/folder/f.csv --quick --apps materials --rates 60"}) {
    EXPECT_EQ(RunReport(arguments).status, 2) << arguments;
  }
}

TEST(AppsReport, TwoAppsAndRates_GetRowsCasesAndBands) {
  const Outcome outcome = RunReport("--quick --apps materials,sensors --rates 60,100 --cases --bands");
  EXPECT_EQ(outcome.status, Count(outcome.output, "fails:") > 0 ? 1 : 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\nmaterials: "), 2) << outcome.output;  // Its figures.
  EXPECT_EQ(Count(outcome.output, "\nmaterials at "), 2) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\nsensors: "), 4) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\n    + "), 6) << outcome.output;
}

TEST(AppsReport, Csv_HasALinePerCaseAndFigure) {
  const std::string file = testing::TempDir() + "apps_report_" + DGD_TEST_PRECISION + ".csv";
  const Outcome outcome = RunReport("--quick --apps sensors --rates 60 --csv " + file);
  EXPECT_LE(outcome.status, 1) << outcome.output;
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  EXPECT_EQ(text.str().rfind("precision,app,rate_hz,", 0), 0U) << text.str();
  EXPECT_EQ(Count(text.str(), "\n" DGD_TEST_PRECISION ",sensors,60,"), 128 * 4) << text.str();
}

}  // namespace
