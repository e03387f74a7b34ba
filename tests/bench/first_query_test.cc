// New hulls: the program runs. No times are judged.
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace {

using dgd_test::Outcome;
using dgd_test::RunProgram;

class FirstQueryTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, FirstQueryTest, testing::Values(DGD_TEST_PROGRAM_FIRST, DGD_TEST_PROGRAM_FIRST64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(FirstQueryTest, FewPairsAndFrames_BothTablesArePrinted) {
  const Outcome outcome = RunProgram(GetParam(), "--pairs 2 --frames 3 --rounds 1");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("\n1000 "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("\nbuiltin "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("\ndgd "), std::string::npos) << outcome.output;
}

TEST_P(FirstQueryTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--pairs 0", "--frames 1", "--points 3"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
}

}  // namespace
