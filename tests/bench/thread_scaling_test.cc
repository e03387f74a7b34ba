// Pairs shared among threads: the program runs, and its worlds stay the same. No times are judged.
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace {

using dgd_test::Outcome;
using dgd_test::RunProgram;

class ThreadScalingTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, ThreadScalingTest,
                         testing::Values(DGD_TEST_PROGRAM_THREADS, DGD_TEST_PROGRAM_THREADS64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(ThreadScalingTest, ThreeThreads_SameBitsAsOne) {
  const Outcome outcome = RunProgram(GetParam(), "--duration 2 --threads 3");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("the same to the last bit"), std::string::npos) << outcome.output;
}

TEST_P(ThreadScalingTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--threads 0", "--duration -1"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
}

}  // namespace
