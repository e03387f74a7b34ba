// Scenes of many bodies: the program runs, and no body is lost. No times are judged.
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;
using dgd_test::RunProgram;

class BigScenesTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Bullet, BigScenesTest,
                         testing::Values(DGD_TEST_PROGRAM_BIG_SCENES, DGD_TEST_PROGRAM_BIG_SCENES64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(BigScenesTest, FirstSeconds_NoBodyIsLost) {
  const Outcome outcome =
      RunProgram(GetParam(), "--duration 1.5 --scenes ragdolls hulls_on_mesh mixed_on_terrain rubble");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "moving bodies"), 4) << outcome.output;
}

TEST_P(BigScenesTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--duration 0", "--scenes none"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
}

}  // namespace
