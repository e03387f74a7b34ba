// The parity program as its users run it: few poses of every pair of types, and none that the plugin fails.
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;
using dgd_test::RunProgram;

class ContactParity : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, ContactParity, testing::Values(DGD_TEST_PROGRAM_FLOAT, DGD_TEST_PROGRAM_FLOAT64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(ContactParity, FewPosesOfAllTypes_NoneFails) {
  const Outcome outcome = RunProgram(GetParam(), "--poses 60");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, " - "), 14 * 15 / 2) << outcome.output;
}

TEST_P(ContactParity, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--poses 0", "--seed -1", "--only NONE"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
}

}  // namespace
