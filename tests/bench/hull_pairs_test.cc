// The benchmark as its users run it: exit statuses, and a table with all its rows. No times are judged.
#include <gtest/gtest.h>

#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;
using dgd_test::RunProgram;

class HullPairsTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, HullPairsTest, testing::Values(DGD_TEST_PROGRAM_FLOAT, DGD_TEST_PROGRAM_FLOAT64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(HullPairsTest, FewPairs_TableHoldsEveryRowAndNoQueryFails) {
  const Outcome outcome = RunProgram(GetParam(), "--pairs 50 --repeats 2 --rounds 1 --margin 0 0.04");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* distance_class : {"separated, ", "nearly touching, ", "touching, within", "shallow, ", "deep, "}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + distance_class), 2) << distance_class << '\n' << outcome.output;
  }
  for (const char* method :
       {"Bullet GJK/EPA, cold  ", "FCL (libccd), cold  ", "paper's algorithm, plain, cold  ",
        "growth distance, double, cold  ", "growth distance, double, warm  ", "growth distance, float, cold  ",
        "signed distance, double, cold  ", "collision yes/no, double, cold  "}) {
    EXPECT_EQ(Count(outcome.output, method), 10) << method << '\n' << outcome.output;
  }
}

TEST_P(HullPairsTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments :
       {"--pairs 0", "--seed -1", "--margin -0.1", "--distance-of boxes", "--csv /no/such/file"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
}

}  // namespace
