// The program as its users run it: exit statuses, what it prints, what it leaves on disk.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "picture_file.h"
#include "small_scenes.h"

#ifdef DGD_DEMOS_RECORD
#include <dgd_bullet/record_file.h>
#endif

namespace dgd_demos {
namespace {

struct Outcome {
  int status;
  std::string output, errors;
};

class PolytopeDropTest : public testing::Test {
 protected:
  // Runs the program with its output in pipes' stead in files, as in a script.
  Outcome Run(const std::string& arguments) {
    const std::string command =
        std::string(DGD_TEST_PROGRAM) + " " + arguments + " > " + Path("stdout") + " 2> " + Path("stderr");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadFile(Path("stdout")), ReadFile(Path("stderr"))};
  }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }
  bool Exists(const std::string& name) const { return std::filesystem::exists(Path(name)); }

  TestFolder folder_;
};

TEST_F(PolytopeDropTest, BothNarrowphases_LeaveCsvPicturesTableAndSilenceOnStandardError) {
  const auto scene = folder_.Write("scene.json", ValidSceneText());
  const Outcome outcome = Run("--scene " + scene.string() + " --out " + Path("out"));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "") << "a progress bar in a pipe?";
  for (const char* part : {"builtin", "dgd", " ratio\n", "deepest penetration, true (cm)", "wall time"}) {
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part;
  }
  for (const char* name : {"builtin.csv", "dgd.csv", "summary.csv", "builtin_t00.00s.png", "builtin_t00.10s.png",
                           "dgd_t00.00s.png", "dgd_t00.10s.png", "end_state.png"}) {
    EXPECT_TRUE(Exists(std::string("out/") + name)) << name;
  }
  const Image picture = ReadPng(Path("out/dgd_t00.10s.png"));
  EXPECT_EQ(picture.width, 1280);
  EXPECT_EQ(picture.height, 720);
}

TEST_F(PolytopeDropTest, OneNarrowphaseWithoutPictures_LeavesOnlyItsCsvAndTheTable) {
  const auto scene = folder_.Write("scene.json", ValidSceneText());
  const Outcome outcome =
      Run("--scene " + scene.string() + " --narrowphase dgd --no-snapshots --duration 0.1 --out " + Path("out"));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(Exists("out/dgd.csv"));
  EXPECT_FALSE(Exists("out/builtin.csv"));
  EXPECT_FALSE(Exists("out/end_state.png"));
  EXPECT_EQ(outcome.output.find(" ratio\n"), std::string::npos);
}

#ifdef DGD_DEMOS_RECORD
TEST_F(PolytopeDropTest, Record_LeavesTheQueriesOfEachNarrowphase) {
  const auto scene = folder_.Write("scene.json", ValidSceneText());
  const Outcome outcome =
      Run("--scene " + scene.string() + " --no-snapshots --duration 0.6 --record --out " + Path("out"));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* name : {"out/builtin.rec", "out/dgd.rec"}) {
    const dgd_bullet::Record record = dgd_bullet::ReadRecord(Path(name));
    EXPECT_FALSE(record.problem) << *record.problem;
    EXPECT_EQ(record.shapes.size(), 2U) << "the box and the ground";
    EXPECT_GT(record.pairs.size(), 0U);
  }
}
#else
TEST_F(PolytopeDropTest, Record_WithoutARecorderStatus2SaysSo) {
  const Outcome outcome = Run("--record --out " + Path("out"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("DGD_BUILD_RECORD"), std::string::npos) << outcome.errors;
}
#endif

TEST_F(PolytopeDropTest, BodyLeavesTheWorld_Status1NamesItAndKeepsTheCsv) {
  std::string text = ValidSceneText();
  text.replace(text.find("[0, 0, 1]"), 9, "[9, 0, 1]");  // Beside the ground.
  const auto scene = folder_.Write("scene.json", text);
  const Outcome outcome = Run("--scene " + scene.string() + " --no-snapshots --out " + Path("out"));
  EXPECT_EQ(outcome.status, 1);
  for (const char* narrowphase : {"builtin", "dgd"}) {
    EXPECT_NE(outcome.errors.find(std::string(narrowphase) + ": box at /bodies/0 left the world at (9, 0, "),
              std::string::npos)
        << outcome.errors;
    EXPECT_NE(ReadFile(Path(std::string("out/") + narrowphase + ".csv")).find("\n0.004"), std::string::npos);
  }
}

TEST_F(PolytopeDropTest, BadInput_Status2AndOneSentence) {
  std::string text = ValidSceneText();
  text.replace(text.find("0.004"), 5, "-1");
  const auto scene = folder_.Write("scene.json", text);
  const Outcome outcome = Run("--scene " + scene.string() + " --out " + Path("out"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.errors, scene.string() + ": /time_step: must be above 0 up to 0.1, not -1\n");
  EXPECT_FALSE(Exists("out")) << "nothing is made for a scene that cannot run";
}

TEST_F(PolytopeDropTest, WrongCommandLine_Status2) {
  for (const char* arguments : {"--narrowphase none", "--no-such-option", "--seed minus-one", "--seed -1", "--seed 1.5",
                                "--seed 99999999999999999999", "--duration nan", "--duration 1e9", "--oracle-every 0",
                                "--scene nowhere.json"}) {
    const Outcome outcome = Run(std::string(arguments) + " --out " + Path("out"));
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.errors, "") << arguments;
    EXPECT_FALSE(Exists("out")) << arguments;
  }
}

TEST_F(PolytopeDropTest, OutputThatCannotBeWritten_Status2) {
  const auto scene = folder_.Write("scene.json", ValidSceneText());
  EXPECT_EQ(Run("--scene " + scene.string() + " --out " + scene.string()).status, 2);
}

TEST_F(PolytopeDropTest, Help_TeachesColumnsAndStatuses) {
  const Outcome outcome = Run("--help");
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"Examples:", "narrowphase_us", "deepest_true_penetration_m", "Exit status"}) {
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace dgd_demos
