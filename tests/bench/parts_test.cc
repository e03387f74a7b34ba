// The parts' benchmark as its users run it. No times are judged.
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace {

TEST(PartsTest, ShortRun_TimesEveryPart) {
  const dgd_test::Outcome outcome =
      dgd_test::RunProgram(DGD_TEST_PROGRAM_PARTS, "--benchmark_min_time=0.0001 --benchmark_format=csv");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* part :
       {"SupportByScan/vertices:8", "SupportByClimb/vertices:8192", "SupportByClimbFromHint/", "TimeSupport/ellipsoid",
        "QueryCold/sharp", "QueryWarm/margin_4_cm", "SeparatedAlongLastNormal", "CollisionCheckCold/apart",
        "SignedDistanceStep", "Face", "Patch", "Certificate", "HullBuilding/vertices:4096"}) {
    EXPECT_GE(dgd_test::Count(outcome.output, std::string("\n\"") + part), 1) << part << '\n' << outcome.output;
  }
}

}  // namespace
