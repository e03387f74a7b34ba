// The program as its users run it: exit statuses, its tables, and the rows that it leaves on disk.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "report/figures.h"
#include "small_scenes.h"
#include "support/run_program.h"

namespace dgd_demos {
namespace {

using dgd_test::Count;
using dgd_test::Outcome;

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class ContactReportTest : public testing::Test {
 protected:
  Outcome Run(const std::string& arguments) const { return dgd_test::RunProgram(DGD_TEST_CONTACT_REPORT, arguments); }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }

  // Two small polytopes, for a moment.
  std::string RandomScene() const {
    std::string text = ValidSceneText();
    const std::size_t start = text.find("{ \"type\"");
    const std::string group =
        R"({ "type": "random_polytopes", "count": 2, "vertices": { "min": 8, "max": 20 }, "diameter": 0.5,
             "region": { "min": [-1, -1, 1], "max": [1, 1, 4] }, "mass": 1 })";
    text.replace(start, text.find("}\n  ]") + 1 - start, group);
    return folder_.Write("random.json", text).string();
  }

  TestFolder folder_;
};

TEST_F(ContactReportTest, TwoScenes_ATableEachAndARowARun) {
  const std::string box = folder_.Write("box.json", ValidSceneText()).string();
  const Outcome outcome = Run("--scenes " + box + "," + RandomScene() + " --seeds 2 --out " + Path("new/report.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "box: 0.2 s in steps of 4 ms"), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "one run"), 1);
  EXPECT_EQ(Count(outcome.output, "median of 2 seeds"), 1);
  EXPECT_EQ(Count(outcome.output, " ratio\n"), 2);
  for (const Figure& figure : Figures()) EXPECT_EQ(Count(outcome.output, figure.title), 2) << figure.title;

  const std::vector<std::string> rows = Lines(ReadFile(Path("new/report.csv")));
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[0].substr(0, rows[0].find(",deepest")), "scene,seed,narrowphase,precision,build_type");
  const char* const kRuns[] = {"box,1,builtin,", "box,1,dgd,",        "random,1,builtin,",
                               "random,1,dgd,",  "random,2,builtin,", "random,2,dgd,"};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_TRUE(rows[i].starts_with(kRuns[i - 1])) << rows[i];
    EXPECT_EQ(std::ranges::count(rows[i], ','), std::ranges::count(rows[0], ',')) << rows[i];
  }
}

TEST_F(ContactReportTest, OneNarrowphase_HasNoRatio) {
  const std::string box = folder_.Write("box.json", ValidSceneText()).string();
  const Outcome outcome =
      Run("--scenes " + box + " --narrowphases dgd --duration 0.02 --oracle-every 2 --out " + Path("report.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, " ratio\n"), 0);
  EXPECT_EQ(Lines(ReadFile(Path("report.csv"))).size(), 2u);
}

// The other scenes are told of nonetheless.
TEST_F(ContactReportTest, BodyLeavesTheWorld_Status1AndTheReportGoesOn) {
  std::string text = ValidSceneText();
  text.replace(text.find("[0, 0, 1]"), 9, "[9, 0, 1]");  // Beside the ground.
  const std::string lost = folder_.Write("lost.json", text).string();
  const std::string box = folder_.Write("box.json", ValidSceneText()).string();
  const Outcome outcome = Run("--scenes " + lost + "," + box + " --out " + Path("report.csv"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(Count(outcome.output, "lost, seed 1, dgd: box at /bodies/0 left the world at (9, 0, "), 1)
      << outcome.output;
  EXPECT_EQ(Lines(ReadFile(Path("report.csv"))).size(), 5u);
}

TEST_F(ContactReportTest, BadInput_Status2BeforeAnythingRuns) {
  const std::string box = folder_.Write("box.json", ValidSceneText()).string();
  for (const std::string& arguments :
       {std::string("--scenes no_such_scene"), std::string("--scenes nowhere.json"),
        "--scenes " + box + ",nowhere.json", std::string("--narrowphases none"), std::string("--seeds 0"),
        std::string("--oracle-every 0"), "--duration 0 --scenes " + box, std::string("--no-such-option")}) {
    const Outcome outcome = Run(arguments + " --out " + Path("report.csv"));
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.output, "") << arguments;
    EXPECT_FALSE(std::filesystem::exists(Path("report.csv"))) << arguments;
  }
  EXPECT_EQ(Run("--scenes " + box + " --out " + box + "/report.csv").status, 2) << "a folder that is a file";
}

TEST_F(ContactReportTest, Help_NamesTheScenesAndTeachesTheFigures) {
  const Outcome outcome = Run("--help");
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"tower_20", "arch", "thrown_at_wall", "sleeping", "Examples:", "Exit status", "jitter"}) {
    EXPECT_GE(Count(outcome.output, part), 1) << part;
  }
}

// Whoever adds a scene to the defaults must ship it, and the other way round; mixed_shapes is no scene to judge by.
TEST_F(ContactReportTest, DefaultScenes_AreThoseShipped) {
  const std::string help = Run("--help").output;
  for (const std::filesystem::path& scene : SimulatedScenes(DGD_TEST_SCENES)) {
    if (scene.stem() == "mixed_shapes") continue;
    EXPECT_GE(Count(help, scene.stem().string()), 1) << scene;
  }
}

}  // namespace
}  // namespace dgd_demos
