// The speed benchmark as its users run it: exit statuses, and a table with all its rows, in which both algorithms found
// what the certificate confirms. No times are judged.
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;

Outcome RunSpeed(const std::string& arguments) { return dgd_test::RunProgram(DGD_TEST_PROGRAM_SPEED, arguments); }

TEST(SpeedTest, FewPairs_TableHoldsEveryClassAndRow) {
  const Outcome outcome = RunSpeed("--pairs 20 --poses 3 --repeats 1 --rounds 1");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  constexpr const char* kClasses[] = {
      "curved",     "rounded-hulls", "sharp-hulls",  "meshes",       "dsf",           "2d",
      "vertices-8", "vertices-32",   "vertices-128", "vertices-512", "vertices-2048", "vertices-4096"};
  const int count = static_cast<int>(std::size(kClasses));
  for (const char* each : kClasses) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + each + ": "), 1) << each << '\n' << outcome.output;
  }
  EXPECT_EQ(Count(outcome.output, "\n  cold "), count);
  EXPECT_EQ(Count(outcome.output, "\n  warm "), count);
  EXPECT_EQ(Count(outcome.output, "\n  collision check, cold "), count);
  EXPECT_EQ(Count(outcome.output, "\n    plain "), 3 * count);
  EXPECT_EQ(Count(outcome.output, "\nFrom 8 to 4096 vertices, times grow as"), 1);
}

// The yardstick measures something only if it solves the same problem. Its gaps, by the certificate, are below its
// tolerance; on curved sets it may need more than its iterations, so hulls are asked for.
TEST(SpeedTest, PlainAlgorithm_FindsTheSame) {
  const std::string output = RunSpeed("--pairs 50 --poses 5 --repeats 1 --rounds 1 --classes sharp-hulls,2d").output;
  const std::regex row(R"(\n    plain +\S+ +\S+ +\S+ +(\S+) +(\S+) +(\S+) +(\d+))");
  int rows = 0;
  for (std::sregex_iterator match(output.begin(), output.end(), row), end; match != end; ++match, ++rows) {
    EXPECT_LT(std::stod((*match)[2]), 2e-8) << output;
    EXPECT_LT(std::stod((*match)[3]), 1e-9) << output;
    EXPECT_EQ((*match)[4], "0") << output;
  }
  EXPECT_EQ(rows, 4) << output;  // Cold and warm of two classes.
}

TEST(SpeedTest, BadOption_Status2AndItsName) {
  for (const char* arguments : {"--pairs 0", "--repeats 0", "--rounds -1", "--classes none", "--meshes /nowhere"}) {
    EXPECT_EQ(RunSpeed(arguments).status, 2) << arguments;
  }
  EXPECT_GE(Count(RunSpeed("--help").output, "Exit status"), 1);
}

}  // namespace
