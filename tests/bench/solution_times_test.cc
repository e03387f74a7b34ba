// The comparison of all ways to a growth distance as its users run it: a row for each, and answers that the exact one
// bears out. No times are judged.
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;

Outcome RunTimes(const std::string& arguments) {
  return dgd_test::RunProgram(DGD_TEST_PROGRAM_TIMES, arguments + " --repeats 1 --rounds 1");
}

TEST(SolutionTimesTest, SharpPolytopes_AllMethodsAreAsExactAsTheySay) {
  const Outcome outcome = RunTimes("--pairs 20 --poses 3 --classes sharp-hulls,meshes");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // Title, the last column but one, failures.
  const std::regex row(
      R"(\n  (ours|ours, warm|Inc|Inc, warm|IE|DCol|paper's algorithm, plain) +\d+ .* (\S+) +(\d+)(?=\n))");
  int rows = 0;
  for (std::sregex_iterator match(outcome.output.begin(), outcome.output.end(), row), end; match != end;
       ++match, ++rows) {
    const bool is_to_rounding = (*match)[1].str().starts_with("ours") || (*match)[1].str().starts_with("Inc");
    EXPECT_LT(std::stod((*match)[2]), is_to_rounding ? 1e-12 : 1e-7) << (*match)[1] << '\n' << outcome.output;
  }
  EXPECT_EQ(rows, 2 * 7) << outcome.output;
}

TEST(SolutionTimesTest, EveryClass_HasARowForEveryMethod) {
  const Outcome outcome = RunTimes("--pairs 4 --poses 2 --tolerances --classes curved,dsf,2d");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* title : {"ours ", "ours, warm ", "ours, float ", "ours, gap 1e-12 ", "paper's algorithm, plain ",
                            "IE ", "Inc ", "DCF ", "DCol "}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n  ") + title), 3) << title << '\n' << outcome.output;
  }
  EXPECT_GE(Count(outcome.output, " unsupported\n"), 3) << outcome.output;
}

TEST(SolutionTimesTest, BadOption_Status2) {
  for (const char* arguments : {"--pairs 0", "--classes none", "--meshes /nowhere", "--csv /no/such/folder/x.csv"}) {
    EXPECT_EQ(RunTimes(arguments).status, 2) << arguments;
  }
  EXPECT_EQ(RunTimes("--help").status, 0);
}

}  // namespace
