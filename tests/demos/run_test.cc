// `headless_sim run` as its users run it: what it leaves, what NumPy makes of it, and what it refuses. What it has in
// common with polytope_drop is tested there.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "report/whole_file.h"
#include "run/pair_recorder.h"
#include "small_scenes.h"
#include "support/run_program.h"

namespace dgd_demos {
namespace {

using dgd_test::Count;
using dgd_test::Outcome;

const std::string kPython = "/usr/bin/python3";  // Debian's modules are for Debian's interpreter.

class RunTest : public testing::Test {
 protected:
  RunTest() : scene_(folder_.Write("box.json", ValidSceneText()).string()) {}

  static Outcome Run(const std::string& arguments) { return dgd_test::RunProgram(DGD_TEST_HEADLESS_SIM, arguments); }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }

  TestFolder folder_;
  std::string scene_;
};

// The snippet of the README, with this test's file.
TEST_F(RunTest, Numpy_OpensTrajectoryAndContacts) {
  if (dgd_test::RunProgram(kPython, "-c 'import numpy'").status != 0) GTEST_SKIP() << "no NumPy here";
  const Outcome outcome =
      Run("run " + scene_ + " --no-snapshots --trajectory --contacts --sample-every 0.02 --out " + Path("out"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;

  std::ifstream readme(DGD_TEST_DEMOS_README);
  std::string script, line;
  while (std::getline(readme, line) && line != "```python") {
  }
  while (std::getline(readme, line) && line != "```") script += line + '\n';
  ASSERT_NE(script.find("numpy.load(\"out/dgd_trajectory.npy\")"), std::string::npos) << script;
  script += R"(
assert poses.shape == (11, 2), poses.shape  # 0.2 s
assert numpy.allclose(poses["time"][:, 0], numpy.arange(11) * 0.02)
height = poses["position"][:, 1, 2]
assert abs(height[0] - 1) < 1e-6
fall = height[0] - 9.81 / 2 * poses["time"][:, 1] ** 2
assert numpy.abs(height - fall)[:5].max() < 0.01, height
assert abs(poses["velocity"][4, 1, 2] + 9.81 * 0.08) < 1e-3
assert numpy.allclose(numpy.linalg.norm(poses["orientation"], axis=-1), 1)
assert contacts.dtype.names[:3] == ("time", "body_a", "body_b")
assert numpy.allclose(numpy.linalg.norm(contacts["normal"], axis=-1), 1)
)";
  folder_.Write("script.py", script);
  const Outcome python =
      dgd_test::RunProgram("sh", "-c 'cd " + folder_.path().string() + " && " + kPython + " script.py'");
  EXPECT_EQ(python.status, 0) << python.output;
}

// What is there can be read, whenever the run was ended.
TEST_F(RunTest, KilledRun_LeavesATrajectoryThatOpens) {
  if (dgd_test::RunProgram(kPython, "-c 'import numpy'").status != 0) GTEST_SKIP() << "no NumPy here";
  const std::string program = DGD_TEST_HEADLESS_SIM;
  dgd_test::RunProgram("timeout", "-s KILL 0.7 " + program + " run " + scene_ +
                                      " --duration 3000 --narrowphase dgd --trajectory --out " + Path("out"));
  const std::string script = folder_
                                 .Write("script.py", R"(import numpy, sys
poses = numpy.load(sys.argv[1])
assert len(poses) > 10, poses.shape
assert numpy.allclose(numpy.diff(poses["time"][:, 0]), 0.004)
)")
                                 .string();
  const Outcome python = dgd_test::RunProgram(kPython, script + " " + Path("out/dgd_trajectory.npy"));
  EXPECT_EQ(python.status, 0) << python.output;
}

// The CSV without the column of measured times.
std::string WithoutTimes(const std::string& csv) {
  constexpr int kNarrowphaseTime = 5;
  std::string rows;
  std::istringstream stream(csv);
  for (std::string row; std::getline(stream, row);) {
    std::istringstream cells(row);
    std::string cell;
    for (int column = 0; std::getline(cells, cell, ','); ++column) {
      if (column != kNarrowphaseTime) rows += cell + ',';
    }
    rows += '\n';
  }
  return rows;
}

TEST_F(RunTest, KilledAndResumed_LeavesTheFilesOfARunThatWasNot) {
  const std::string run =
      "run polytopes_50"
      " --no-snapshots --duration 3 --trajectory --contacts --sample-every 0.01 --oracle-every 40"
      " --set warm_start=off --out ";
  ASSERT_EQ(Run(run + Path("whole")).status, 0);
  const std::string resumed = run + Path("out") + " --checkpoint 0.02 --resume";
  for (const std::string seconds : {"0.2", "0.3", "0.25", "0.4"}) {
    dgd_test::RunProgram("timeout", "-s KILL " + seconds + " " + DGD_TEST_HEADLESS_SIM + " " + resumed);
  }
  const Outcome outcome = Run(resumed);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  for (const std::string file : {"builtin", "dgd"}) {
    EXPECT_TRUE(WithoutTimes(ReadFile(Path("out/" + file + ".csv"))) ==
                WithoutTimes(ReadFile(Path("whole/" + file + ".csv"))));
    for (const std::string kind : {"_trajectory.npy", "_contacts.npy"}) {
      EXPECT_TRUE(ReadFile(Path("out/" + file + kind)) == ReadFile(Path("whole/" + file + kind))) << file << kind;
    }
  }

  const Outcome again = Run(resumed);
  EXPECT_EQ(again.status, 0) << "what is done is done";
  EXPECT_EQ(again.output, outcome.output);
  const Outcome other = Run(resumed + " --seed 2");
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(Count(other.output, "out: has the results of another run, with --seed 1, not 2"), 1) << other.output;
  EXPECT_EQ(Run(resumed + " --record").status, 2);
  std::filesystem::remove(Path("out/dgd.csv"));
  EXPECT_EQ(Count(Run(resumed).output, "dgd.csv: cannot be continued: No such file"), 1);
  EXPECT_FALSE(std::filesystem::exists(Path("out/dgd.csv")));
  std::filesystem::copy_file(Path("whole/dgd.csv"), Path("out/dgd.csv"));
  std::filesystem::remove(Path("out/dgd_contacts.npy"));
  EXPECT_EQ(Count(Run(resumed).output, "dgd_contacts.npy: cannot be continued: No such file"), 1);
  std::filesystem::copy_file(Path("out/dgd.csv"), Path("out/builtin.csv"),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(Count(Run(resumed).output, "builtin.csv cannot be continued: it is "), 1);
  std::filesystem::remove(Path("out/builtin.checkpoint"));
  std::filesystem::create_directory(Path("out/builtin.checkpoint"));
  const Outcome folder = Run(resumed);
  EXPECT_EQ(folder.status, 2);
  EXPECT_EQ(Count(folder.output, "builtin.checkpoint: is a folder"), 1) << folder.output;
  EXPECT_EQ(Run(run + Path("out") + " --checkpoint -1").status, 2);
}

TEST_F(RunTest, StoppedRun_LeavesCompleteFilesAndCanBeResumed) {
  const std::string run = "run " + scene_ + " --no-snapshots --duration 2000 --narrowphase dgd --out " + Path("out");
  // Long after the program has started, on a busy machine as well.
  const std::string stop = std::string("-s TERM 1.5 ") + DGD_TEST_HEADLESS_SIM + " ";
  const Outcome stopped = dgd_test::RunProgram("timeout", "--preserve-status " + stop + run + " --checkpoint 1000");
  EXPECT_EQ(stopped.status, 130) << stopped.output;
  EXPECT_EQ(Count(stopped.output, "Stopped at "), 1) << stopped.output;
  const std::string rows = ReadFile(Path("out/dgd.csv"));
  EXPECT_EQ(rows.back(), '\n');

  const Outcome resumed =
      dgd_test::RunProgram("timeout", "--preserve-status " + stop + run + " --checkpoint 1000 --resume");
  EXPECT_EQ(resumed.status, 130) << resumed.output;
  const std::string more = ReadFile(Path("out/dgd.csv"));
  EXPECT_GT(more.size(), rows.size());
  EXPECT_EQ(more.substr(0, rows.size()), rows);

  // In the other precision, by the other program, which gets the signal as well.
  const Outcome other = dgd_test::RunProgram("timeout", "--preserve-status " + stop + run + " --precision both");
  EXPECT_EQ(other.status, 130) << other.output;
  EXPECT_EQ(Count(other.output, "Stopped at "), 1) << other.output;
}

// Whatever becomes of the pictures, the figures are there.
TEST_F(RunTest, PictureThatCannotBeWritten_LeavesTheTable) {
  std::filesystem::create_directories(Path("out/end_state.png"));
  const Outcome outcome = Run("run " + scene_ + " --duration 0.05 --out " + Path("out"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(Count(outcome.output, "end_state.png: cannot be written: "), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "wall time of the steps"), 1) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(Path("out/summary.csv")));
}

// A program that cannot draw says so before it runs, and runs without pictures.
TEST_F(RunTest, WithoutOsMesa_OnlyPicturesAreRefused) {
  folder_.Write("libOSMesa.so.8", "");
  const std::string run = "LD_LIBRARY_PATH=" + folder_.path().string() + " " + DGD_TEST_HEADLESS_SIM + " run " +
                          scene_ + " --duration 0.05 --out " + Path("out");
  const Outcome outcome = dgd_test::RunProgram("env", run);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(Count(outcome.output, "no pictures can be drawn: "), 1) << outcome.output;
  EXPECT_FALSE(std::filesystem::exists(Path("out/dgd.csv")));
  EXPECT_EQ(dgd_test::RunProgram("env", run + " --no-snapshots").status, 0);
}

// At whatever moment it is stopped.
TEST_F(RunTest, StoppedWhileItDraws_EndsAsOneThatIsStoppedWhileItRuns) {
  const Outcome outcome =
      dgd_test::RunProgram("timeout", std::string("--preserve-status -s TERM 1.5 ") + DGD_TEST_HEADLESS_SIM +
                                          " run polytopes_50 --duration 0.05 --out " + Path("out"));
  EXPECT_TRUE(outcome.status == 130 || outcome.status == 0) << outcome.status << outcome.output;
}

// Two at once would write the same files.
TEST_F(RunTest, SecondRunInAFolder_IsRefused) {
  const std::string run = std::string(DGD_TEST_HEADLESS_SIM) + " run " + scene_ +
                          " --no-snapshots --duration 3000 --narrowphase dgd --out " + Path("out");
  const Outcome outcome = dgd_test::RunProgram(
      "sh", "-c '" + run + " 2>/dev/null & first=$!; sleep 0.5; " + run + "; echo status $?; kill $first; wait'");
  EXPECT_EQ(Count(outcome.output, "out: another process writes its results there\nstatus 2\n"), 1) << outcome.output;
}

// A scene is not the same with another mesh.
TEST_F(RunTest, MeshChangedSinceTheCheckpoint_IsRefused) {
  const auto write_mesh = [&](const std::string& height) {
    folder_.Write("tetrahedron.obj",
                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 " + height + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  };
  write_mesh("1");
  std::string text = ValidSceneText();
  const std::size_t start = text.find("{ \"type\"");
  text.replace(start, text.find("}\n  ]") + 1 - start,
               R"({ "type": "mesh", "file": "tetrahedron.obj", "mass": 1, "position": [0, 0, 1] })");
  const std::string run = "run " + folder_.Write("mesh.json", text).string() +
                          " --no-snapshots --duration 0.1 --checkpoint 0 --resume --out " + Path("out");
  ASSERT_EQ(Run(run).status, 0) << Run(run).output;
  EXPECT_EQ(Run(run).status, 0);
  write_mesh("1.1");
  const Outcome changed = Run(run);
  EXPECT_EQ(changed.status, 2);
  EXPECT_EQ(Count(changed.output, "out: has the results of another run, with world \"mesh.json "), 1) << changed.output;
}

TEST_F(RunTest, BothPrecisions_HaveAFolderEach) {
  const Outcome outcome =
      Run("run " + scene_ + " --precision both --no-snapshots --duration 0.05 --out=" + Path("out"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "Bullet in float precision"), 1) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "Bullet in double precision"), 1);
  EXPECT_NE(ReadFile(Path("out/float/dgd.csv")).find("# precision: float"), std::string::npos);
  EXPECT_NE(ReadFile(Path("out/double/dgd.csv")).find("# precision: double"), std::string::npos);
}

TEST_F(RunTest, Options_ReachThePlugin) {
  const std::string run = "run " + scene_ + " --no-snapshots --narrowphase dgd --contacts --duration 1 --out ";
  EXPECT_EQ(Run(run + Path("full")).status, 0);
  EXPECT_EQ(Run(run + Path("one") + " --set patch_size=1,friction_anchors=off").status, 0);
  EXPECT_NE(ReadFile(Path("one/dgd.csv")).find("# narrowphase: dgd:patch_size=1,friction_anchors=off\n"),
            std::string::npos);
  EXPECT_LT(std::filesystem::file_size(Path("one/dgd_contacts.npy")),
            std::filesystem::file_size(Path("full/dgd_contacts.npy")));
}

// Out and in again: the world that the scene is.
TEST_F(RunTest, WorldFile_RunsAsTheSceneThatItWasWrittenFrom) {
  const Outcome exported = Run("export " + scene_ + " " + Path("box.bullet"));
  ASSERT_EQ(exported.status, 0) << exported.output;
  EXPECT_EQ(Count(exported.output, "box.bullet: 2 bodies"), 1) << exported.output;
  const std::string options = " --duration 0.2 --time-step 0.004 --trajectory --out ";
  const Outcome outcome = Run("run " + Path("box.bullet") + options + Path("world"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Run("run " + scene_ + " --no-snapshots" + options + Path("scene")).status, 0);
  EXPECT_EQ(ReadFile(Path("world/dgd_trajectory.npy")), ReadFile(Path("scene/dgd_trajectory.npy")));
  EXPECT_TRUE(std::filesystem::exists(Path("world/end_state.png")));
  EXPECT_FALSE(std::filesystem::exists(Path("scene/end_state.png")));

  const std::string study =
      folder_.Write("study.json", R"({ "about": "a", "worlds": ["box.bullet"], "duration": 0.1 })").string();
  EXPECT_EQ(Run("sweep " + study + " --out " + Path("study")).status, 0);
  const std::string both = folder_
                               .Write("both.json", R"({ "about": "a", "worlds": ["box.bullet"],
      "precisions": ["float", "double"] })")
                               .string();
  const Outcome other = Run("sweep " + both + " --out " + Path("both"));
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(Count(other.output, "both.json: /worlds/0: box.bullet was written by a Bullet in "), 1) << other.output;

  const Outcome run_of_both = Run("run " + Path("box.bullet") + " --precision both --out " + Path("both"));
  EXPECT_EQ(run_of_both.status, 2);
  EXPECT_EQ(Count(run_of_both.output, "box.bullet: was written by a Bullet in "), 1) << run_of_both.output;
  EXPECT_EQ(Count(run_of_both.output, "Results are in"), 0) << run_of_both.output;

  EXPECT_EQ(Run("run " + Path("box.bullet") + " --duration 1e9 --out " + Path("bad")).status, 2);
  folder_.Write("cut.bullet", ReadFile(Path("box.bullet")).substr(0, 1000));
  const Outcome cut = Run("run " + Path("cut.bullet") + " --out " + Path("bad"));
  EXPECT_EQ(cut.status, 2);
  EXPECT_EQ(Count(cut.output, "cut.bullet: "), 1) << cut.output;
  EXPECT_EQ(Run("export " + scene_ + " " + Path("box.world")).status, 2) << "the name says what it is";
  EXPECT_EQ(Run("export " + scene_ + " /dev/null/box.bullet").status, 2);
}

TEST_F(RunTest, BadInput_Status2) {
  for (const auto& [arguments, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"", "world is required"},
           {"nowhere", "nowhere: there is no such scene; `headless_sim list` names"},
           {"nowhere.json", "nowhere.json: cannot be opened"},
           {scene_ + " --set patch=1", "there is no option 'patch'"},
           {scene_ + " --set patch_size=0", "patch_size"},
           {scene_ + " --sample-every -1", "--sample-every"},
           {scene_ + " --time-step 1e-12", "--duration: 0.02 s are 2e+10 time steps of 1e-12 s"},
           {scene_ + " --oracle-every 2.5", "--oracle-every: '2.5' is no whole number"},
           {scene_ + " --checkpoint inf", "--checkpoint: must be finite, not inf"},
           {scene_ + " --checkpoint ''", "--checkpoint: '' is no number"},
           {"ur5e_five_obstacles", "/arms: is of a scene for plan_motion"},
           {scene_ + " --precision half", "--precision"},
           {scene_ + " --seed x", "--seed"}}) {
    const Outcome outcome = Run("run " + arguments + " --no-snapshots --duration 0.02 --out " + Path("bad"));
    EXPECT_EQ(outcome.status, 2) << arguments << ": " << outcome.output;
    EXPECT_GE(Count(outcome.output, complaint), 1) << arguments << ": " << outcome.output;
  }
}

TEST_F(RunTest, FolderThatCannotBeMade_IsNamedWithTheReason) {
  for (const std::string& out : {scene_, std::string("/dev/null/x"), std::string("/proc/x")}) {
    const Outcome outcome = Run("run " + scene_ + " --no-snapshots --out " + out);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(Count(outcome.output, out + ": the folder cannot be made: "), 1) << outcome.output;
    EXPECT_EQ(Count(outcome.output, "filesystem error"), 0) << outcome.output;
  }
}

TEST_F(RunTest, FullDisk_IsToldOfATrajectory) {
  const std::string run = std::string(DGD_TEST_HEADLESS_SIM) + " run " + scene_ +
                          " --no-snapshots --narrowphase dgd --duration 2 --trajectory --out " + Path("out");
  // For want of a small disk, small files.
  const Outcome outcome = dgd_test::RunProgram("sh", "-c 'trap \"\" XFSZ; ulimit -f 100; " + run + "'");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(Count(outcome.output, "dgd_trajectory.npy: cannot be written: File too large"), 1) << outcome.output;
}

TEST_F(RunTest, AnotherRunsFiles_AreNotReplacedWithoutAWord) {
  const std::string run = "run " + scene_ + " --no-snapshots --narrowphase dgd --duration 0.1";
  const std::string in_folder = run + " --out " + Path("out");
  ASSERT_EQ(Run(in_folder).status, 0);
  const std::string first = ReadFile(Path("out/dgd.csv"));
  const Outcome again = Run(in_folder + " --trajectory");
  EXPECT_EQ(again.status, 0) << "the same, with another file: " << again.output;
  for (const std::string more : {" --seed 2", " --seed 2 --resume", " --duration 0.05", " --set patch_size=1"}) {
    const Outcome other = Run(in_folder + more);
    EXPECT_EQ(other.status, 2) << more;
    EXPECT_EQ(Count(other.output, "out: has the results of another run, with "), 1) << other.output;
  }
  EXPECT_EQ(WithoutTimes(ReadFile(Path("out/dgd.csv"))), WithoutTimes(first));
  const Outcome replaced = Run(in_folder + " --seed 2 --overwrite --overwrite");
  EXPECT_EQ(replaced.status, 0) << replaced.output;
  EXPECT_EQ(Count(replaced.output, "out: had the results of another run, with --seed 1, not 2; replaced\n"), 1);
  EXPECT_FALSE(std::filesystem::exists(Path("out/dgd_trajectory.npy"))) << "it is not of this run";

  // The folder that nobody has named is that of the last run.
  const auto run_there = [&](const std::string& more) {
    return dgd_test::RunProgram("sh", "-c 'cd " + folder_.path().string() + " && mkdir -p there && cd there && " +
                                          DGD_TEST_HEADLESS_SIM + " " + run + more + "'");
  };
  EXPECT_EQ(Count(run_there("").output, "replaced"), 0);
  const Outcome next = run_there(" --seed 2");
  EXPECT_EQ(next.status, 0);
  EXPECT_EQ(Count(next.output, "out: had the results of another run, with --seed 1, not 2; replaced\n"), 1);
  EXPECT_EQ(run_there(" --seed 3 --resume").status, 2) << "what is to go on must not be lost by a slip";
  const Outcome both = run_there(" --seed 3 --precision both");
  EXPECT_EQ(both.status, 0) << both.output;
  EXPECT_EQ(run_there(" --seed 4 --precision both").status, 0);
}

TEST_F(RunTest, LinksInTheFolder_AreNotWrittenThrough) {
  const std::string record = kHasRecorder ? " --record" : "";
  const std::string run =
      "run " + scene_ + " --no-snapshots --duration 0.1" + record + " --trajectory --contacts --out " + Path("out");
  ASSERT_EQ(Run(run).status, 0);
  folder_.Write("precious", "precious");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(Path("out"))) files.push_back(entry.path());
  EXPECT_GE(files.size(), 9u);
  for (const std::filesystem::path& file : files) {
    const std::string content = ReadFile(file);
    std::filesystem::remove(file);
    std::filesystem::create_symlink(Path("precious"), file);
    const Outcome linked = Run(run);
    EXPECT_EQ(linked.status, 2) << file << linked.output;
    EXPECT_EQ(ReadFile(Path("precious")), "precious") << file;
    std::filesystem::remove(file);
    folder_.Write("out/" + file.filename().string(), content);
  }
  std::filesystem::create_directory_symlink(Path("out"), Path("elsewhere"));
  EXPECT_EQ(Run("run " + scene_ + " --duration 0.1 --no-snapshots --out " + Path("elsewhere")).status, 0)
      << "the folder itself may be one";
}

// Processes of the program whose arguments have the folder's name; after a moment, in which one that is killed ends.
int CountRunsIn(const std::string& folder) {
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  int count = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const std::string arguments = ReadFile(entry.path() / "cmdline");
    if (arguments.starts_with(DGD_TEST_HEADLESS_SIM) && arguments.find(folder) != std::string::npos) ++count;
  }
  return count;
}

// Of a mesh whose import never ends.
TEST_F(RunTest, StoppedWhileItReadsAMesh_EndsAtOnceWithItsChild) {
  folder_.Write("endless.ply", "ply\nformat ascii 1.0\nelement vertex 1\n");
  std::string text = ValidSceneText();
  const std::size_t start = text.find("{ \"type\"");
  text.replace(start, text.find("}\n  ]") + 1 - start,
               R"({ "type": "mesh", "file": "endless.ply", "mass": 1, "position": [0, 0, 1] })");
  const std::string run = std::string(DGD_TEST_HEADLESS_SIM) + " run " + folder_.Write("mesh.json", text).string() +
                          " --no-snapshots --out " + Path("out");
  for (const std::string signal : {"TERM", "INT"}) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = dgd_test::RunProgram("timeout", "-s " + signal + " 0.7 " + run);
    EXPECT_EQ(outcome.status, 124) << signal << outcome.output;
    EXPECT_EQ(CountRunsIn(folder_.path().string()), 0) << signal;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(8)) << signal;
  }
}

// Its hash is right, whatever is in it.
TEST_F(RunTest, ForgedCheckpoint_IsASentenceOrARun) {
  const std::string run = "run " + scene_ +
                          " --narrowphase dgd --no-snapshots --duration 0.2 --trajectory --contacts --out " +
                          Path("out") + " --checkpoint 0.05 --resume";
  ASSERT_EQ(Run(run).status, 0);
  const std::string file = ReadFile(Path("out/dgd.checkpoint"));
  const std::size_t hash = file.find('\n') + 1, content = file.find('\n', hash) + 1;
  const auto resume = [&](const std::string& forged) {
    folder_.Write("out/dgd.checkpoint", file.substr(0, hash) + HashOf(forged) + "\n" + forged);
    return Run(run);
  };
  const std::string whole = file.substr(content);
  ASSERT_EQ(resume(whole).status, 0);
  int turn = 0;
  for (std::size_t i = 0; i + 4 <= whole.size(); i += whole.size() / 50) {
    std::string forged = whole;
    for (std::size_t byte = 0; byte < 4; ++byte) forged[i + byte] = "\xff\x7f\x00"[turn % 3];
    ++turn;
    const Outcome outcome = resume(forged);
    EXPECT_TRUE(outcome.status >= 0 && outcome.status <= 2) << i << ": " << outcome.status << outcome.output;
    EXPECT_TRUE(outcome.status != 2 || Count(outcome.output, "dgd.checkpoint: ") > 0) << outcome.output;
  }
  const std::string state = whole.substr(whole.find('\n'));
  for (const std::string& forged : {state, std::string(), std::string("{}"), "{}" + state, "[1]" + state,
                                    std::string(200'000, '[') + state, whole.substr(0, whole.find('\n'))}) {
    const Outcome outcome = resume(forged);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(Count(outcome.output, "dgd.checkpoint: "), 1) << outcome.output;
  }
}

}  // namespace
}  // namespace dgd_demos
