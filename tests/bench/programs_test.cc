// The benchmarks as their users run them: exit statuses, and tables with all their rows. No times are judged.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "support/run_program.h"

namespace {

using dgd_test::Count;
using dgd_test::Outcome;

Outcome RunBench(const std::string& program, const std::string& arguments) {
  return dgd_test::RunProgram((DGD_TEST_BENCH_DIR "/" + program).c_str(), arguments);
}

/// A program that runs Bullet, in either of its precisions.
class BulletBench : public testing::TestWithParam<const char*> {
 protected:
  static Outcome RunBench(const std::string& program, const std::string& arguments) {
    return ::RunBench(program + GetParam(), arguments);
  }
};
INSTANTIATE_TEST_SUITE_P(Bullet, BulletBench, testing::Values("", "_float64"),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

/// The matches of a regular expression, which must be there.
std::vector<std::smatch> MatchesOf(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), expression), {}};
}

TEST_P(BulletBench, BigScenes_FirstSecondsNoBodyIsLost) {
  const Outcome outcome =
      RunBench("big_scenes", "--duration 1.5 --scenes ragdolls hulls_on_mesh mixed_on_terrain rubble");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "moving bodies"), 4) << outcome.output;
}

TEST_P(BulletBench, BigScenes_SettledBothGoOnFromThere) {
  const Outcome outcome = RunBench("big_scenes", "--settle 1 --duration 0.1 --scenes rubble");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // Of a wall that was just built, and stands, not a tenth moves.
  EXPECT_EQ(Count(outcome.output, "     0.10     0.10"), 2) << outcome.output;
}

TEST_P(BulletBench, BigScenes_ThreeThreadsSameBitsAsOne) {
  const Outcome outcome = RunBench("big_scenes", "--duration 2 --threads 3");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "the same to the last bit"), 1) << outcome.output;
}

TEST_P(BulletBench, DispatcherReplay_BothGetTheSamePairsAndOursMissesNone) {
  const Outcome outcome = RunBench("dispatcher_replay", "--duration 1.5 --rounds 2");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // Pairs, and the last column, of rows like "  dgd   123   0.4 ...  0".
  const auto rows = MatchesOf(outcome.output, R"(\n  (builtin|dgd) +(\d+) .* (\d+)(?=\n|$))");
  ASSERT_EQ(rows.size(), 6u) << outcome.output;
  for (std::size_t i = 0; i < rows.size(); i += 2) {
    EXPECT_GT(std::stoi(rows[i][2]), 100) << outcome.output;
    EXPECT_EQ(rows[i + 1][2], rows[i][2]) << outcome.output;
    EXPECT_EQ(rows[i + 1][3], "0") << outcome.output;
  }
}

TEST_P(BulletBench, FirstQuery_FewPairsAndFramesBothTablesArePrinted) {
  const Outcome outcome = RunBench("first_query", "--pairs 2 --frames 3 --rounds 1");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* row : {"\n1000 ", "\nbuiltin ", "\ndgd "}) EXPECT_GE(Count(outcome.output, row), 1) << row;
}

TEST_P(BulletBench, HardCases_TableHoldsEveryMethodAndNoWrongGrowthDistance) {
  const Outcome outcome = RunBench("hard_cases", "--cases 9 --rounds 1 --class touching-features");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* method : {"growth distance, double", "growth distance, float", "signed distance, double",
                             "signed distance, float", "Bullet float", "FCL (libccd), double"}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n  ") + method), 2) << method << '\n' << outcome.output;
  }
  EXPECT_GE(Count(RunBench("hard_cases", "--list").output, "known-failures"), 1);
}

TEST_P(BulletBench, HardCases_ReplayPrintsEachMethodsAnswer) {
  const Outcome outcome = RunBench("hard_cases", "--class known-failures --replay 3");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "true distance"), 4) << outcome.output;
}

#ifdef DGD_TEST_RECORD
/// With a record of a simulation of many shapes.
class NarrowphaseReplay : public BulletBench {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::path(testing::TempDir()) / ("dgd_replay." + std::to_string(getpid()));
    const Outcome outcome = dgd_test::RunProgram(DGD_TEST_PROGRAM_DROP,
                                                 "--record --no-snapshots --narrowphase builtin --duration 2"
                                                 " --oracle-every 1000 --scene " +
                                                     std::string(DGD_TEST_SCENE) + " --out " + Path(""));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder_); }

  static std::string Path(const std::string& name) { return (folder_ / name).string(); }

  inline static std::filesystem::path folder_;
};
INSTANTIATE_TEST_SUITE_P(Bullet, NarrowphaseReplay, testing::Values("", "_float64"),
                         [](const auto& test) { return test.index == 0 ? "Float" : "Double"; });

TEST_P(NarrowphaseReplay, RecordOfManyShapes_EachMethodHasARowAndOursIsRight) {
  const Outcome outcome = RunBench(
      "narrowphase_replay", Path("builtin.rec") + " --pairs 300 --rounds 1 --repeats 1 --csv " + Path("figures.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // The errors of the normal, 99 % and most, of rows without a gap.
  const auto rows = MatchesOf(outcome.output,
                              R"(\nours, signed distance(?:, warm)? +300 .* (\S+) +(\S+) +\S+ +0 +0 +0 +\d+(?=\n|$))");
  EXPECT_EQ(rows.size(), 2u) << outcome.output;
  for (const std::smatch& row : rows) EXPECT_LT(std::stod(row[2]), 1e-6) << outcome.output;
  for (const char* title : {"\nBullet GJK/EPA", "\nBullet MPR", "\nFCL", "\npaper's algorithm, plain "}) {
    EXPECT_EQ(Count(outcome.output, title), 1) << title << outcome.output;
  }
  std::ifstream csv(Path("figures.csv"));
  const std::string text{std::istreambuf_iterator<char>(csv), {}};
  EXPECT_EQ(Count(text, "\nbuiltin,signed_distance,"), 1) << text;
}

TEST_P(NarrowphaseReplay, OnePair_ItsNumbersAndEachMethodsAnswer) {
  const Outcome outcome = RunBench("narrowphase_replay", Path("builtin.rec") + " --pair 100 --methods growth,fcl");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\npair 100, step "), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\nours "), 1) << outcome.output;
  EXPECT_EQ(RunBench("narrowphase_replay", Path("builtin.rec") + " --pair 100000000").status, 2);
}

TEST_P(NarrowphaseReplay, DamagedRecord_IsReplayedUpToTheDamage) {
  std::filesystem::copy(Path("builtin.rec"), Path("cut.rec"), std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(Path("cut.rec"), std::filesystem::file_size(Path("cut.rec")) * 3 / 4);
  const Outcome outcome = RunBench("narrowphase_replay", Path("cut.rec") + " --pairs 10 --rounds 1 --repeats 1");
  EXPECT_EQ(outcome.status, 3) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "cut.rec: damaged from byte "), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "\n10 pairs, Bullet linked in "), 1) << outcome.output;
}
#endif

TEST_P(BulletBench, ShapePairs_EveryKindHasATableAndOursIsRight) {
  const Outcome outcome = RunBench("shape_pairs", "--pairs 10 --repeats 1 --rounds 1 --margin 0 0.04");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  constexpr const char* kWithMargins[] = {"hulls", "boxes", "cylinders", "cylinder-hull"};
  constexpr const char* kWithout[] = {"capsule-hull", "capsules", "cones", "ellipsoids"};
  for (const char* kind : kWithMargins) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + kind + ", margin 0 m: "), 1) << kind << '\n' << outcome.output;
    EXPECT_EQ(Count(outcome.output, std::string("\n") + kind + ", margin 0.04 m: "), 1) << kind << outcome.output;
  }
  for (const char* kind : kWithout) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + kind + ", margin "), 1) << kind << '\n' << outcome.output;
  }
  constexpr int kTables = 2 * std::size(kWithMargins) + std::size(kWithout);
  for (const char* method : {"FCL", "ours, signed distance ", "ours, signed distance, warm ", "ours "}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + method), kTables) << method << '\n' << outcome.output;
  }
  EXPECT_EQ(Count(outcome.output, "\nBullet GJK/EPA"), kTables - 1) << "It has no ellipsoid.\n" << outcome.output;
}

TEST_P(BulletBench, ShapePairs_DetailsHaveATableForEveryClass) {
  const Outcome outcome = RunBench("shape_pairs",
                                   "--kinds hulls --margin 0.04 --details --pairs 30 --repeats 1 --rounds 1"
                                   " --methods bullet_mpr,signed_distance,growth,plain");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* distance_class : {"separated, ", "nearly touching, ", "touching, within", "shallow, ", "deep, "}) {
    EXPECT_EQ(Count(outcome.output, std::string("\nhulls, margin 0.04 m: ") + distance_class), 1)
        << distance_class << '\n'
        << outcome.output;
  }
  for (const char* method : {"Bullet MPR", "ours, signed distance ", "ours ", "paper's algorithm, plain "}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + method), 6) << method << '\n' << outcome.output;
  }
}

TEST_P(BulletBench, WrongArguments_EndWithStatusTwo) {
  constexpr const char* kWrong[][2] = {{"big_scenes", "--duration 0"},
                                       {"big_scenes", "--settle -1"},
                                       {"big_scenes", "--threads 0"},
                                       {"big_scenes", "--scenes none"},
                                       {"dispatcher_replay", "--scene /no.json"},
                                       {"dispatcher_replay", "--rounds 0"},
                                       {"first_query", "--pairs 0"},
                                       {"first_query", "--frames 1"},
                                       {"first_query", "--points 3"},
                                       {"hard_cases", "--class none"},
                                       {"hard_cases", "--cases 0"},
                                       {"hard_cases", "--tolerance 1"},
#ifdef DGD_TEST_RECORD
                                       {"narrowphase_replay", ""},
                                       {"narrowphase_replay", "/no/such.rec"},
                                       {"narrowphase_replay", "x.rec --methods none"},
#endif
                                       {"shape_pairs", "--kinds none"},
                                       {"shape_pairs", "--margin -0.1"},
                                       {"shape_pairs", "--csv /no/such/file"}};
  for (const auto& [program, arguments] : kWrong) {
    EXPECT_EQ(RunBench(program, arguments).status, 2) << program << ' ' << arguments;
  }
}

constexpr const char* kClasses[] = {
    "curved",     "rounded-hulls", "sharp-hulls",  "meshes",       "dsf",           "2d",
    "vertices-8", "vertices-32",   "vertices-128", "vertices-512", "vertices-2048", "vertices-4096"};

TEST(Speed, FewPairs_TableHoldsEveryClassAndRow) {
  const Outcome outcome = RunBench("speed", "--pairs 20 --poses 3 --repeats 1 --rounds 1");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  constexpr int kCount = std::size(kClasses);
  for (const char* each : kClasses) {
    EXPECT_EQ(Count(outcome.output, std::string("\n") + each + ": "), 1) << each << '\n' << outcome.output;
  }
  for (const char* row : {"\n  cold ", "\n  warm ", "\n  collision check, cold "}) {
    EXPECT_EQ(Count(outcome.output, row), kCount) << row << '\n' << outcome.output;
  }
  EXPECT_EQ(Count(outcome.output, "\n    plain "), 3 * kCount);
  EXPECT_EQ(Count(outcome.output, "\nFrom 8 to 4096 vertices, times grow as"), 1);
}

// The paper's algorithm is something to compare with only if it solves the same problem: its gaps, by the certificate,
// are below its tolerance. On curved sets it may need more than its iterations, so hulls are queried.
TEST(Speed, PlainAlgorithm_FindsTheSame) {
  const Outcome outcome = RunBench("speed", "--pairs 50 --poses 5 --repeats 1 --rounds 1 --classes sharp-hulls,2d");
  const auto rows = MatchesOf(outcome.output, R"(\n    plain +\S+ +\S+ +\S+ +(\S+) +(\S+) +(\S+) +(\d+))");
  EXPECT_EQ(rows.size(), 4u) << outcome.output;  // Cold and warm of two classes.
  for (const std::smatch& row : rows) {
    EXPECT_LT(std::stod(row[2]), 2e-8) << outcome.output;
    EXPECT_LT(std::stod(row[3]), 1e-9) << outcome.output;
    EXPECT_EQ(row[4], "0") << outcome.output;
  }
}

Outcome RunTimes(const std::string& arguments) {
  return RunBench("solution_times", arguments + " --repeats 1 --rounds 1");
}

TEST(SolutionTimes, SharpPolytopes_AllMethodsAreAsExactAsTheySay) {
  const Outcome outcome = RunTimes("--pairs 20 --poses 3 --classes sharp-hulls,meshes");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // Title, and the last column but one.
  const auto rows =
      MatchesOf(outcome.output,
                R"(\n  (ours|ours, warm|Inc|Inc, warm|IE|DCol|paper's algorithm, plain) +\d+ .* (\S+) +(\d+)(?=\n))");
  EXPECT_EQ(rows.size(), 2u * 7) << outcome.output;
  for (const std::smatch& row : rows) {
    const std::string title = row[1];
    const bool is_to_roundoff = title.starts_with("ours") || title.starts_with("Inc");
    EXPECT_LT(std::stod(row[2]), is_to_roundoff ? 1e-12 : 1e-7) << title << '\n' << outcome.output;
  }
}

TEST(SolutionTimes, EveryClass_HasARowForEveryMethod) {
  const Outcome outcome = RunTimes("--pairs 4 --poses 2 --tolerances --classes curved,dsf,2d");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* title :
       {"ours ", "ours, warm ", "ours, gap 1e-12 ", "paper's algorithm, plain ", "IE ", "Inc ", "DCF ", "DCol "}) {
    EXPECT_EQ(Count(outcome.output, std::string("\n  ") + title), 3) << title << '\n' << outcome.output;
  }
  EXPECT_GE(Count(outcome.output, " unsupported\n"), 3) << outcome.output;
}

// Only the tail's last digits move once all queries have ended.
TEST(SolutionTimes, Convergence_GapsEndBelowTheTolerance) {
  const Outcome outcome = RunTimes("--convergence --pairs 10 --poses 3 --classes sharp-hulls");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto rows = MatchesOf(outcome.output, R"(\nsharp-hulls,(growth|plain),(\d+),(\S+?),(\S+))");
  ASSERT_EQ(rows.size(), 2u * 60) << outcome.output;
  for (const std::size_t last : {59u, 119u}) EXPECT_LT(std::stod(rows[last][4]), 1e-12) << outcome.output;
}

TEST(ClassBenches, WrongArguments_EndWithStatusTwo) {
  for (const char* program : {"speed", "solution_times"}) {
    for (const char* arguments :
         {"--pairs 0", "--poses 0", "--repeats 0", "--rounds -1", "--seed -1", "--classes none", "--meshes /nowhere"}) {
      EXPECT_EQ(RunBench(program, arguments).status, 2) << program << ' ' << arguments;
    }
    EXPECT_GE(Count(RunBench(program, "--help").output, "Exit status"), 1);
  }
  EXPECT_EQ(RunTimes("--csv /no/such/folder/x.csv").status, 2);
}

}  // namespace
