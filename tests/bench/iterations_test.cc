// The iteration benchmark as its users run it: exit statuses, and a table with all its rows. No counts are judged.
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;

Outcome RunIterations(const std::string& arguments) {
  return dgd_test::RunProgram(DGD_TEST_PROGRAM_ITERATIONS, arguments);
}

TEST(IterationsTest, FewPairs_TableHoldsEveryClassAndRow) {
  const Outcome outcome = RunIterations("--pairs 20 --poses 5");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  constexpr const char* kClasses[] = {
      "curved",     "rounded-hulls", "sharp-hulls",  "meshes",       "dsf",           "2d",
      "vertices-8", "vertices-32",   "vertices-128", "vertices-512", "vertices-2048", "vertices-4096"};
  for (const char* each : kClasses) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + each + ": "), 1) << each << '\n' << outcome.output;
  }
  for (const char* row :
       {"\n  cold ", "\n  warm  ", "\n  warm, by the normal alone ", "\n  no second-order steps, cold ",
        "\n  no guess of the first, cold ", "\n  no radii apart from cores, cold ", "\n  no combined points, cold ",
        "\n  no half-way cuts, cold ", "\n  tolerance 1e-12, cold "}) {
    EXPECT_EQ(Count(outcome.output, row), static_cast<int>(std::size(kClasses))) << row << '\n' << outcome.output;
  }
}

TEST(IterationsTest, SameSeed_CountsTheSame) {
  const auto without_times = [](const std::string& output) {
    static const std::regex last_column(" +[^ \n]+\n");
    return std::regex_replace(output, last_column, "\n");
  };
  const std::string options = "--pairs 10 --poses 3 --classes curved,sharp-hulls --seed ";
  const std::string once = without_times(RunIterations(options + "5").output);
  EXPECT_EQ(once, without_times(RunIterations(options + "5").output));
  EXPECT_NE(once, without_times(RunIterations(options + "6").output));
}

TEST(IterationsTest, WrongArguments_EndWithStatusTwo) {
  for (const char* arguments : {"--pairs 0", "--poses 0", "--seed -1", "--classes boxes", "--meshes /no/such/folder"}) {
    EXPECT_EQ(RunIterations(arguments).status, 2) << arguments;
  }
  EXPECT_EQ(RunIterations("--help").status, 0);
}

}  // namespace
