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

TEST_P(BigScenesTest, Settled_BothGoOnFromThere) {
  const Outcome outcome = RunProgram(GetParam(), "--settle 1 --duration 0.1 --scenes rubble");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // Of a wall that was just built, and stands, not a tenth moves.
  EXPECT_EQ(Count(outcome.output, "     0.10     0.10"), 2) << outcome.output;
}

TEST_P(BigScenesTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--duration 0", "--settle -1", "--scenes none"}) {
    EXPECT_EQ(RunProgram(GetParam(), arguments).status, 2) << arguments;
  }
}

}  // namespace
