// The program as its users run it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "physics/experiment.h"
#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;

Outcome RunTruth(const std::string& arguments) { return dgd_test::RunProgram(DGD_TEST_PROGRAM_PHYSICS, arguments); }

TEST(PhysicsTruth, Help_NamesEveryClass) {
  const Outcome outcome = RunTruth("--help");
  EXPECT_EQ(outcome.status, 0);
  for (const auto& experiment : dgd_physics::Experiments()) {
    EXPECT_NE(outcome.output.find("  " + std::string(experiment.name) + " "), std::string::npos) << experiment.name;
  }
}

TEST(PhysicsTruth, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--classes none", "--rates 0", "--rates x",
                                "--csv /no/such/folder/f.csv --quick "
                                "--classes weight --rates 60"}) {
    EXPECT_EQ(RunTruth(arguments).status, 2) << arguments;
  }
}

TEST(PhysicsTruth, TwoClassesAndRates_GetARowAndTheirCases) {
  const Outcome outcome = RunTruth("--quick --classes weight,near_rod --rates 60,100 --cases");
  EXPECT_LE(outcome.status, 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\nweight "), 3) << outcome.output;  // The row, and a block of cases per rate.
  EXPECT_EQ(Count(outcome.output, "\nnear_rod "), 3) << outcome.output;
}

// Whether a class fails is listed, and is the exit status.
TEST(PhysicsTruth, ExitStatus_TellsWhetherAClassFails) {
  const Outcome outcome = RunTruth("--quick --classes weight,tip --rates 240");
  EXPECT_EQ(outcome.status, Count(outcome.output, "fails:") > 0 ? 1 : 0) << outcome.output;
}

TEST(PhysicsTruth, Csv_HasALinePerCase) {
  const std::string file = testing::TempDir() + "physics_truth_" + DGD_TEST_PRECISION + ".csv";
  const Outcome outcome = RunTruth("--quick --classes weight --rates 60 --csv " + file);
  EXPECT_LE(outcome.status, 1) << outcome.output;
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  EXPECT_EQ(text.str().rfind("precision,class,rate_hz,case,", 0), 0U) << text.str();
  EXPECT_EQ(Count(text.str(), "\n" DGD_TEST_PRECISION ",weight,60,"), 12) << text.str();
}

}  // namespace
