// The replay as its users run it: exit statuses, and a table in which both narrowphases were asked the same. No times
// are judged.
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Outcome;
using dgd_test::RunProgram;

class DispatcherReplayTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, DispatcherReplayTest,
                         testing::Values(DGD_TEST_PROGRAM_REPLAY, DGD_TEST_PROGRAM_REPLAY64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(DispatcherReplayTest, ShortFall_BothAreAskedTheSamePairsAndOursMissesNone) {
  const Outcome outcome = RunProgram(GetParam(), "--duration 1.5 --rounds 2");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // Pairs, and the last column, of rows like "  dgd   123   0.4 ...  0".
  const std::regex row(R"(\n  (builtin|dgd) +(\d+) .* (\d+)(?=\n|$))");
  int rows = 0;
  std::string pairs_of_builtin;
  for (std::sregex_iterator match(outcome.output.begin(), outcome.output.end(), row), end; match != end;
       ++match, ++rows) {
    if ((*match)[1] == "builtin") {
      pairs_of_builtin = (*match)[2];
    } else {
      EXPECT_EQ((*match)[2], pairs_of_builtin) << outcome.output;
      EXPECT_EQ((*match)[3], "0") << outcome.output;
    }
    EXPECT_GT(std::stoi((*match)[2]), 100) << outcome.output;
  }
  EXPECT_EQ(rows, 6) << outcome.output;
}

TEST_P(DispatcherReplayTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--scene /no/such.json", "--duration -1", "--seed -1", "--rounds 0"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
  EXPECT_EQ(RunProgram(GetParam(), "--help").status, 0);
}

}  // namespace
