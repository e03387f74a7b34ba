// The program as its users run it: one CSV whoever carries out the runs, whatever is killed on the way.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "small_scenes.h"
#include "support/run_program.h"

namespace dgd_demos {
namespace {

using dgd_test::Count;
using dgd_test::Outcome;

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// The CSV without its times. No cell here has a comma.
std::string Timeless(const std::filesystem::path& csv) {
  std::string kept;
  std::vector<bool> is_time;
  for (const std::string& line : Split(ReadFile(csv), '\n')) {
    const std::vector<std::string> cells = Split(line, ',');
    if (is_time.empty()) {
      for (const std::string& cell : cells) {
        is_time.push_back(cell == "narrowphase_us_per_query" || cell == "wall_time_s");
      }
    }
    for (std::size_t i = 0; i < cells.size(); ++i) kept += is_time.at(i) ? "" : cells[i] + ",";
    kept += '\n';
  }
  return kept;
}

class SweepTest : public testing::Test {
 protected:
  SweepTest() {
    std::string text = ValidSceneText();
    const std::size_t start = text.find("{ \"type\"");
    const std::string group =
        R"({ "type": "random_polytopes", "count": 4, "vertices": { "min": 8, "max": 20 }, "diameter": 0.5,
             "region": { "min": [-1, -1, 0.5], "max": [1, 1, 2] }, "mass": 1 })";
    text.replace(start, text.find("}\n  ]") + 1 - start, group);
    folder_.Write("random.json", text);
    study_ = folder_
                 .Write("study.json", R"({ "about": "a", "worlds": ["random.json"], "seeds": { "from": 1, "to": 5 },
        "vary": { "/time_step": [0.002, 0.004] }, "precisions": ["float", "double"] })")
                 .string();
  }

  static Outcome Run(const std::string& arguments) { return dgd_test::RunProgram(DGD_TEST_HEADLESS_SIM, arguments); }
  Outcome Sweep(const std::string& arguments, const std::string& out) const {
    return Run("sweep " + study_ + " --out " + Path(out) + " " + arguments);
  }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string Csv(const std::string& out) const { return Timeless(folder_.path() / out / "runs.csv"); }

  TestFolder folder_;
  std::string study_;
};

TEST_F(SweepTest, OneProcessTwoJobsAndShards_GiveTheSameCsv) {
  const Outcome one = Sweep("", "one");
  ASSERT_EQ(one.status, 0) << one.output;
  EXPECT_EQ(Count(one.output, "40 of 40 runs are done"), 1);
  EXPECT_EQ(Count(one.output, "median of 5 runs"), 4);
  EXPECT_EQ(Count(Csv("one"), "\n"), 41);
  EXPECT_EQ(ReadFile(Path("one/tables.txt")).find("random.json, /time_step 0.002, Bullet in float"), 0U);

  EXPECT_EQ(Sweep("--jobs 2", "two").status, 0);
  EXPECT_EQ(Csv("two"), Csv("one"));

  for (const std::string shard : {"1", "2", "3"}) EXPECT_EQ(Sweep("--shard " + shard + "/3", "part" + shard).status, 0);
  const Outcome partly = Sweep("--merge " + Path("part1") + "," + Path("part2"), "merged");
  EXPECT_EQ(partly.status, 130) << "a third is missing";
  EXPECT_EQ(Count(partly.output, "runs not done yet"), 4) << partly.output;
  EXPECT_EQ(Sweep("--merge " + Path("part3"), "merged").status, 0);
  EXPECT_EQ(Csv("merged"), Csv("one"));
}

TEST_F(SweepTest, Mpi_GivesTheSameCsv) {
  if (dgd_test::RunProgram("mpirun", "--allow-run-as-root --version").status != 0 || !DGD_TEST_HAS_MPI)
    GTEST_SKIP() << "no MPI here";
  ASSERT_EQ(Sweep("--jobs 2", "one").status, 0);
  const Outcome outcome =
      dgd_test::RunProgram("mpirun", std::string("--allow-run-as-root --oversubscribe -n 3 ") + DGD_TEST_HEADLESS_SIM +
                                         " sweep " + study_ + " --out " + Path("mpi"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Csv("mpi"), Csv("one"));

  // A rank that dies takes the others with it, and nothing that is done.
  const std::string killed = " sweep " + study_ + " --out " + Path("killed");
  dgd_test::RunProgram("sh", std::string("-c 'mpirun --allow-run-as-root --oversubscribe -n 3 ") +
                                 DGD_TEST_HEADLESS_SIM + killed + " & sleep 0.6; pkill -KILL -n -f \"" + killed +
                                 "\"; wait'");
  EXPECT_EQ(Run(killed).status, 0);
  EXPECT_EQ(Csv("killed"), Csv("one"));

  const Outcome wrong = dgd_test::RunProgram("mpirun", std::string("--allow-run-as-root --oversubscribe -n 3 ") +
                                                           DGD_TEST_HEADLESS_SIM + " sweep nowhere.json");
  EXPECT_NE(wrong.status, 0);
  EXPECT_EQ(Count(wrong.output, "nowhere.json: cannot be opened"), 1) << wrong.output;
}

// Killed at three moments, whatever was then going on.
TEST_F(SweepTest, KilledAndResumed_GivesTheSameCsv) {
  ASSERT_EQ(Sweep("--jobs 2", "one").status, 0);
  int killed = 0;
  for (const char* moment : {"0.05", "0.08", "0.12"}) {
    const Outcome outcome =
        dgd_test::RunProgram("timeout", std::string("-s KILL ") + moment + " " + DGD_TEST_HEADLESS_SIM + " sweep " +
                                            study_ + " --out " + Path("killed"));
    killed += outcome.status != 0;
  }
  EXPECT_GT(killed, 0);
  const Outcome outcome = Sweep("", "killed");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Csv("killed"), Csv("one"));
}

TEST_F(SweepTest, Terminated_LeavesWholeFilesOfWhatIsDone) {
  // Far too long for the test; its first run is short.
  const std::string study = folder_
                                .Write("long.json", R"({ "about": "a", "worlds": ["random.json"], "seeds": [1],
      "narrowphases": ["dgd"], "vary": [ { "/duration": 0.1 }, { "/duration": 3000 } ] })")
                                .string();
  const Outcome outcome = dgd_test::RunProgram("timeout", std::string("-s TERM 1 ") + DGD_TEST_HEADLESS_SIM +
                                                              " sweep " + study + " --jobs 2 --out " + Path("out"));
  EXPECT_EQ(Count(outcome.output, "1 of 2 runs are done"), 1) << outcome.output;
  EXPECT_EQ(Split(ReadFile(Path("out/runs.csv")), '\n').size(), 2U);
}

// A crash is a record, and the others go on; asked to, it is done again.
TEST_F(SweepTest, CrashedRun_IsToldAndCanBeDoneAgain) {
  const std::string study = folder_
                                .Write("crash.json", R"({ "about": "a", "worlds": ["random.json"], "seeds": [1],
      "narrowphases": ["dgd"], "vary": [ { "/duration": 3000 }, { "/duration": 0.1 } ] })")
                                .string();
  const std::string sweep = std::string(DGD_TEST_HEADLESS_SIM) + " sweep " + study + " --out " + Path("out");
  const Outcome outcome =
      dgd_test::RunProgram("sh", "-c '" + sweep + " & sweep=$!; sleep 0.5; pkill -SEGV -P $sweep; wait $sweep'");
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "run 0, seed 1, dgd: failed: ended by signal 11 (Segmentation fault)"), 1)
      << outcome.output;
  EXPECT_EQ(Count(outcome.output, "2 of 2 runs are done"), 1);
  EXPECT_EQ(Run("sweep " + study + " --out " + Path("out")).status, 1) << "it is not done again by itself";
  std::filesystem::remove(Path("out/study.json"));
  const Outcome of_any = Run("sweep " + study + " --out " + Path("out"));
  EXPECT_EQ(of_any.status, 2);
  EXPECT_EQ(Count(of_any.output, "out: has results, and no study.json; choose another folder"), 1) << of_any.output;
}

TEST_F(SweepTest, SceneByName_IsFoundFromAnyFolder) {
  const std::string study = folder_
                                .Write("named.json", R"({ "about": "a", "worlds": ["rest_on_plane"],
      "narrowphases": ["dgd"], "duration": 0.1 })")
                                .string();
  const Outcome outcome = dgd_test::RunProgram(
      "sh", "-c 'cd " + folder_.path().string() + " && " + DGD_TEST_HEADLESS_SIM + " sweep named.json'");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(ReadFile(Path("out/named/runs.csv")), "\n0,rest_on_plane,1,dgd,"), 1);
}

TEST_F(SweepTest, LostBody_Status1) {
  std::string text = ValidSceneText();
  text.replace(text.find("[0, 0, 1]"), 9, "[9, 0, 1]");  // Beside the ground.
  folder_.Write("lost.json", text);
  const std::string study = folder_.Write("s.json", R"({ "about": "a", "worlds": ["lost.json"] })").string();
  const Outcome outcome = Run("sweep " + study + " --out " + Path("out"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(Count(outcome.output, "lost: box at /bodies/0 left the world at (9, 0, "), 2) << outcome.output;
}

TEST_F(SweepTest, BadInput_Status2BeforeAnythingRuns) {
  const std::string options = folder_
                                  .Write("o.json", R"({ "about": "a", "worlds": ["random.json"],
      "narrowphases": ["dgd:patch_size=x"] })")
                                  .string();
  const std::string none = folder_
                               .Write("n.json", R"({ "about": "a", "worlds": ["random.json"],
      "narrowphases": ["gjk"] })")
                               .string();
  for (const auto& [arguments, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"sweep nowhere.json", "nowhere.json: cannot be opened"},
           {"sweep", "is required"},
           {"sweep " + options, "o.json: /narrowphases/0: option patch_size must be an integer, not 'x'"},
           {"sweep " + none, "n.json: /narrowphases/0: there is no narrowphase 'gjk'"},
           {"sweep " + study_ + " --shard 4/3", "--shard: must be I/N"},
           {"sweep " + study_ + " --shard 0/3", "--shard: must be I/N"},
           {"sweep " + study_ + " --jobs 0", "--jobs"},
           {"sweep " + study_ + " --shard 1/2 --merge x", "--merge: runs nothing"},
           {"sweep " + study_ + " --retry-failed --merge x", "--merge: runs nothing"},
           {"sweep " + study_ + " --merge nowhere", "nowhere has no results"},
           {"swep", "swep is not a command"},
           {"", "Usage: headless_sim COMMAND"}}) {
    const Outcome outcome = Run(arguments + (arguments.empty() ? "" : " --out " + Path("bad")));
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(Count(outcome.output, complaint), 1) << arguments << " gives: " << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "bad" / "runs.csv")) << arguments;
  }
}

TEST_F(SweepTest, HelpAndList_Teach) {
  EXPECT_EQ(Run("--help").status, 0);
  const Outcome help = Run("sweep --help");
  EXPECT_EQ(help.status, 0);
  for (const char* part : {"Examples:", "Exit status", "jitter", "IQR"}) EXPECT_GE(Count(help.output, part), 1) << part;
  const std::string list = "\n" + Run("list").output;
  for (const std::filesystem::path& scene : SimulatedScenes(DGD_TEST_SCENES)) {
    EXPECT_EQ(Count(list, "\n" + scene.stem().string() + " "), 1) << scene;
    // Whoever adds a scene adds it to the study that all are judged by; mixed_shapes is no scene to judge by.
    const std::string study = ReadFile(std::filesystem::path(DGD_TEST_SCENES) / "studies" / "contacts.json");
    EXPECT_EQ(Count(study, "/" + scene.filename().string()), scene.stem() == "mixed_shapes" ? 0 : 1) << scene;
  }
}

}  // namespace
}  // namespace dgd_demos
