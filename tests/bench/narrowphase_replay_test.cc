// The replay of recorded pairs as its users run it: exit statuses, a row for each method, and answers of ours that the
// referee finds right. No times are judged.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;
using dgd_test::RunProgram;

class NarrowphaseReplayTest : public testing::TestWithParam<const char*> {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::path(testing::TempDir()) / ("dgd_replay." + std::to_string(getpid()));
    const Outcome outcome = RunProgram(DGD_TEST_PROGRAM_DROP,
                                       "--record --no-snapshots --narrowphase builtin --duration 2"
                                       " --oracle-every 1000 --scene " +
                                           std::string(DGD_TEST_SCENE) + " --out " + Path(""));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  static std::string Path(const std::string& name) { return (folder_ / name).string(); }

  inline static std::filesystem::path folder_;
};
INSTANTIATE_TEST_SUITE_P(Bullet, NarrowphaseReplayTest,
                         testing::Values(DGD_TEST_PROGRAM_RECORDED, DGD_TEST_PROGRAM_RECORDED64),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(NarrowphaseReplayTest, RecordOfManyShapes_EachMethodHasARowAndOursIsRight) {
  const Outcome outcome =
      RunProgram(GetParam(), Path("builtin.rec") + " --pairs 300 --rounds 1 --repeats 1 --csv " + Path("figures.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // The errors of the normal, 99 % and most, of rows without a gap.
  const std::regex row(R"(\nours, signed distance(?:, warm)? +300 .* (\S+) +(\S+) +\S+ +0 +0 +0 +\d+(?=\n|$))");
  int rows = 0;
  for (std::sregex_iterator match(outcome.output.begin(), outcome.output.end(), row), end; match != end;
       ++match, ++rows) {
    EXPECT_LT(std::stod((*match)[2]), 1e-6) << outcome.output;
  }
  EXPECT_EQ(rows, 2) << outcome.output;
  for (const char* title : {"\nBullet GJK/EPA", "\nBullet MPR", "\nFCL", "\npaper's algorithm, plain "}) {
    EXPECT_EQ(Count(outcome.output, title), 1) << title << outcome.output;
  }
  std::ifstream csv(Path("figures.csv"));
  const std::string text{std::istreambuf_iterator<char>(csv), {}};
  EXPECT_EQ(Count(text, "\nbuiltin,signed_distance,"), 1) << text;
}

TEST_P(NarrowphaseReplayTest, OnePair_ItsNumbersAndEachMethodsAnswer) {
  const Outcome outcome = RunProgram(GetParam(), Path("builtin.rec") + " --pair 100 --methods growth,fcl");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\npair 100, step "), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\nours "), 1) << outcome.output;
  EXPECT_EQ(RunProgram(GetParam(), Path("builtin.rec") + " --pair 100000000").status, 2);
}

TEST_P(NarrowphaseReplayTest, DamagedRecord_IsReplayedUpToTheDamage) {
  std::filesystem::copy(Path("builtin.rec"), Path("cut.rec"), std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(Path("cut.rec"), std::filesystem::file_size(Path("cut.rec")) * 3 / 4);
  const Outcome outcome = RunProgram(GetParam(), Path("cut.rec") + " --pairs 10 --rounds 1 --repeats 1");
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "cut.rec: damaged from byte "), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\n10 pairs, Bullet linked in "), 1) << outcome.output;
}

}  // namespace
