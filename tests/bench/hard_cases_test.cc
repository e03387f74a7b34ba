// The hard cases as their users run them: exit statuses, and a table with a row for every method. No times are judged.
#include <gtest/gtest.h>

#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;
using dgd_test::RunProgram;

class HardCasesTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, HardCasesTest, testing::Values(DGD_TEST_PROGRAM_HARD, DGD_TEST_PROGRAM_HARD64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(HardCasesTest, FewCases_TableHoldsEveryMethodAndNoWrongGrowthDistance) {
  const Outcome outcome = RunProgram(GetParam(), "--cases 9 --rounds 1 --class touching-features");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* method : {"growth distance, double", "growth distance, float", "signed distance, double",
                             "signed distance, float", "Bullet float", "FCL (libccd), double"}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n  ") + method), 2) << method << '\n' << outcome.output;
  }
}

TEST_P(HardCasesTest, Replay_SaysWhatEachMethodSays) {
  const Outcome outcome = RunProgram(GetParam(), "--class known-failures --replay 3");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "true distance"), 4) << outcome.output;
}

TEST_P(HardCasesTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--class none", "--cases 0", "--rounds 0", "--tolerance 1", "--seed -1"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
  EXPECT_EQ(RunProgram(GetParam(), "--help").status, 0);
  EXPECT_GE(Count(RunProgram(GetParam(), "--list").output, "known-failures"), 1);
}

}  // namespace
