// The program as its users run it: exit statuses, its table, its sentences, and what it leaves on disk.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "motion/motion_checks.h"
#include "small_scenes.h"
#include "support/run_program.h"

namespace dgd_demos {
namespace {

using dgd_test::Count;
using dgd_test::Outcome;

class PlanMotionTest : public testing::Test {
 protected:
  Outcome Run(const std::string& arguments) const { return dgd_test::RunProgram(DGD_TEST_PLAN_MOTION, arguments); }
  // The scene with one part replaced, or as it is.
  std::string Scene(const std::string& old_part = "planar", const std::string& new_part = "planar") const {
    return folder_.Write("arm.json", With(SmallMotionSceneText(), old_part, new_part)).string();
  }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string File(const std::string& name) const { return ReadFile(Path(name)); }

  TestFolder folder_;
};

TEST_F(PlanMotionTest, OneSeed_TablePathsAndPictures) {
  const Outcome outcome = Run("--scene " + Scene() + " --time-limit 60 --compare --out " + Path("new/out"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  for (const char* row : {"1 of 1", "search and simplification (ms)", "pair checks, with kinematics (1e6/s)",
                          "decided by a cached plane (%)", "clearance after smoothing (mm)", "lower and post",
                          "FCL collide", "Bullet contactPairTest"}) {
    EXPECT_GE(Count(outcome.output, row), 1) << row << '\n' << outcome.output;
  }
  for (const char* name : {"path_found.csv", "path_simplified.csv", "path_smoothed.csv"}) {
    const std::string text = File(std::string("new/out/") + name);
    EXPECT_TRUE(
        text.starts_with("place_rad,shoulder_rad,elbow_rad,flange_x_m,flange_y_m,flange_z_m,clearance_m\n"
                         "0,-0.5,0.1,"))
        << name << text;
    EXPECT_GE(std::ranges::count(text, '\n'), 3) << name;
  }
  EXPECT_EQ(Count(File("new/out/runs.csv"), "\n1,1,"), 1);
  EXPECT_EQ(Count(File("new/out/comparison.csv"), "\n"), 6);
  EXPECT_GE(Count(File("new/out/execution.csv"), "\n"), 240);  // A second at least, the hold in it.
  for (const char* name : {"path.png", "path_other_side.png", "execution.png"}) {
    EXPECT_TRUE(File(std::string("new/out/") + name).starts_with("\x89PNG")) << name;
  }
}

TEST_F(PlanMotionTest, SameSeed_SameFiles) {
  const std::string arguments = "--scene " + Scene() + " --time-limit 60 --seed 3 --no-picture --out ";
  ASSERT_EQ(Run(arguments + Path("a")).status, 0);
  ASSERT_EQ(Run(arguments + Path("b")).status, 0);
  EXPECT_EQ(File("a/path_smoothed.csv"), File("b/path_smoothed.csv"));
  EXPECT_EQ(File("a/execution.csv"), File("b/execution.csv"));
  EXPECT_NE(File("a/path_smoothed.csv"), "");
  EXPECT_FALSE(std::filesystem::exists(Path("a/path.png")));
}

TEST_F(PlanMotionTest, SomeSeeds_ARowEachAndMedians) {
  const Outcome outcome =
      Run("--scene " + Scene() + " --planner rrt --time-limit 60 --seed 4 --seeds 3 --no-picture --out " + Path("out"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "3 of 3"), 1);
  EXPECT_EQ(Count(outcome.output, "median          least       greatest"), 1) << outcome.output;
  const std::string rows = File("out/runs.csv");
  for (const char* seed : {"4", "5", "6"}) {
    EXPECT_EQ(Count(rows, std::string("\n") + seed + ",1,"), 1) << rows;
    EXPECT_TRUE(std::filesystem::exists(Path(std::string("out/seed_") + seed + "/path_smoothed.csv")));
  }
  const Outcome other = Run("--scene " + Scene() + " --no-picture --out " + Path("out"));
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(Count(other.output, "out: has the results of another run, with --planner \"rrt\", not \"rrt_connect\""), 1)
      << other.output;
  EXPECT_EQ(File("out/runs.csv"), rows);
}

TEST_F(PlanMotionTest, UnreachableGoal_Status1AndTheNearestBranchIsKept) {
  const std::string scene = Scene(R"("plan": {)", R"("plan": { "search": { "elbow": [0, 0.2] },)");
  const Outcome outcome = Run("--scene " + scene + " --time-limit 0.2 --out " + Path("out"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(Count(outcome.output, "seed 1: no path from start to goal within 0.2 s, nearest branch ends "), 1)
      << outcome.output;
  EXPECT_EQ(Count(outcome.output, "0 of 1"), 1);
  EXPECT_EQ(Count(File("out/runs.csv"), "\n1,0,"), 1);
  EXPECT_GE(Count(File("out/path_found.csv"), "\n"), 2);
  EXPECT_FALSE(std::filesystem::exists(Path("out/path_smoothed.csv")));
}

TEST_F(PlanMotionTest, StartInCollision_Status1AndThePairIsNamed) {
  const std::string scene = Scene(R"("start": { "shoulder": -0.5)", R"("start": { "shoulder": 0.5)");
  const Outcome outcome = Run("--scene " + scene + " --out " + Path("out"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.output, scene + ": the start is in collision: lower and post overlap\n");
}

TEST_F(PlanMotionTest, TooWeakOrTooSlowMotors_Status1AndASentence) {
  const std::string weak =
      Scene(R"("max_velocity": 1, "max_effort": 10 })", R"("max_velocity": 1, "max_effort": 1e-3 })");
  const Outcome off = Run("--scene " + weak + " --no-picture --time-limit 60 --out " + Path("weak"));
  EXPECT_EQ(off.status, 1) << off.output;
  EXPECT_EQ(Count(off.output, "seed 1: in the execution, "), 1) << off.output;
  EXPECT_GE(Count(File("weak/execution.csv"), "\n"), 240);
  EXPECT_GE(Count(File("weak/path_smoothed.csv"), "\n"), 3);

  const std::string slow = Scene(R"("max_velocity": 1, )", R"("max_velocity": 1e-6, )");
  const Outcome endless = Run("--scene " + slow + " --no-picture --time-limit 60 --out " + Path("slow"));
  EXPECT_EQ(endless.status, 1) << endless.output;
  EXPECT_EQ(Count(endless.output, "more than 600 s are not simulated"), 1) << endless.output;
  EXPECT_GE(Count(File("slow/path_smoothed.csv"), "\n"), 3);
}

TEST_F(PlanMotionTest, BadInput_Status2AndASentence) {
  const std::string out = " --out " + Path("out");
  const Outcome limit = Run("--scene " + Scene(R"("shoulder": 1.5)", R"("shoulder": 3.5)") + out);
  EXPECT_EQ(limit.status, 2);
  EXPECT_EQ(Count(limit.output, "exceeds the limits of joint shoulder"), 1) << limit.output;
  const Outcome joint = Run("--scene " + Scene(R"("elbow": 0.1 },)", R"("wrist": 0.1 },)") + out);
  EXPECT_EQ(joint.status, 2);
  EXPECT_EQ(Count(joint.output, "has no joint \"wrist\""), 1) << joint.output;
  const Outcome name = Run("--scene " + Scene(R"("name": "upper")", R"("name": "up,per")") + out);
  EXPECT_EQ(name.status, 2);
  EXPECT_EQ(Count(name.output, "must have no comma"), 1) << name.output;
  for (const std::string& arguments :
       {std::string("--scene nowhere.json"), std::string("--planner prm"), std::string("--seeds 0"),
        std::string("--time-limit 0"), std::string("--time-limit nan"), std::string("--seed -1"),
        std::string("--no-such-option")}) {
    const Outcome outcome = Run(arguments + out);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.output, "") << arguments;
  }
  EXPECT_FALSE(std::filesystem::exists(Path("out")));
  const std::string scene = Scene();
  EXPECT_EQ(Run("--scene " + scene + " --out " + scene + "/out").status, 2) << "a folder in a file";
}

TEST_F(PlanMotionTest, Help_TeachesMethodFiguresAndFiles) {
  const Outcome outcome = Run("--help");
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"RRT-Connect", "certificate", "Examples:", "Exit status", "path_smoothed.csv", "--compare",
                           "growth distance", "--time-limit", "tracking error"}) {
    EXPECT_GE(Count(outcome.output, part), 1) << part;
  }
}

}  // namespace
}  // namespace dgd_demos
