// `headless_sim render` as its users run it: pictures of what `run` has left, and the trajectories that it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "picture_file.h"
#include "small_scenes.h"
#include "support/run_program.h"

namespace dgd_demos {
namespace {

using dgd_test::Count;
using dgd_test::Outcome;

constexpr int kWidth = 320, kHeight = 180;
constexpr std::size_t kHead = 1024, kRow = 14 * sizeof(double);  // Bytes of a trajectory's head, and of a body's row.

struct Part {
  int left, right, top, bottom;  // Pixels; right and bottom are the first outside.
};
constexpr Part kMiddle = {0, kWidth, kHeight / 4, kHeight / 2};
constexpr Part kLowerLeft = {0, kWidth / 5, kHeight / 2, kHeight};  // Ground, and no shadow but that from the sky.

// Pixels of two pictures that differ by more than a soft shadow does.
int CountDifferences(const Image& a, const Image& b, const Part& part) {
  constexpr int kShadow = 6;  // Of 255.
  int count = 0;
  for (int row = part.top; row < part.bottom; ++row) {
    for (int column = part.left; column < part.right; ++column) {
      if (std::abs(a.Pixel(column, row)[1] - b.Pixel(column, row)[1]) > kShadow) ++count;
    }
  }
  return count;
}

// Pixels of bodies: the ground, the sky and the text are nearly grey.
int CountColoured(const Image& image) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const auto [least, most] = std::minmax({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    if (most > least + 60) ++count;
  }
  return count;
}

class RenderTest : public testing::Test {
 protected:
  // A box falls by 0.2 m from rest onto nothing yet: 11 samples from 0 to 0.2 s, of the ground and of the box.
  void SetUp() override {
    scene_ = folder_.Write("box.json", ValidSceneText()).string();
    const Outcome run = Sim("run " + scene_ + kRun + " --out " + Path("run"));
    ASSERT_EQ(run.status, 0) << run.output;
    trajectory_ = Path("run/dgd_trajectory.npy");
    bytes_ = ReadFile(trajectory_);
    ASSERT_EQ(bytes_.size(), kHead + 11 * 2 * kRow);
  }

  static Outcome Sim(const std::string& arguments) { return dgd_test::RunProgram(DGD_TEST_HEADLESS_SIM, arguments); }
  Outcome Render(const std::string& arguments) const {
    return Sim("render " + arguments + " --size " + std::to_string(kWidth) + "x" + std::to_string(kHeight));
  }
  Outcome RenderBytes(const std::string& name, const std::string& bytes) const {
    std::ofstream(Path(name), std::ios::binary) << bytes;
    return Render(scene_ + " " + Path(name) + " --out " + Path("refused"));
  }
  std::string With(std::size_t number, double value) const {
    std::string changed = bytes_;
    std::memcpy(&changed[kHead + number * sizeof value], &value, sizeof value);
    return changed;
  }
  // Takes blanks from the end of the head, or adds some, so that its length stays.
  std::string WithText(const std::string& old_text, const std::string& new_text) const {
    std::string changed = bytes_;
    changed.replace(changed.find(old_text), old_text.size(), new_text);
    if (new_text.size() > old_text.size()) return changed.erase(kHead - 1, new_text.size() - old_text.size());
    return changed.insert(kHead - 1 + new_text.size() - old_text.size(), old_text.size() - new_text.size(), ' ');
  }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::vector<std::string> Pictures(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(Path(folder))) {
      if (entry.path().extension() == ".png") names.push_back(entry.path().filename());
    }
    std::ranges::sort(names);
    return names;
  }

  const std::string kRun = " --no-snapshots --narrowphase dgd --trajectory --sample-every 0.02";
  TestFolder folder_;
  std::string scene_, trajectory_, bytes_;
};

using Names = std::vector<std::string>;

TEST_F(RenderTest, Pictures_AreOfTheScenesTimesOrOfThoseGiven) {
  const Outcome outcome = Render(scene_ + " " + trajectory_ + " --out " + Path("scene"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(Count(outcome.output, "Pictures: 2, in "), 1) << outcome.output;
  EXPECT_EQ(Pictures("scene"), (Names{"t00.00s.png", "t00.10s.png"}));
  const Image image = ReadPng(Path("scene/t00.00s.png"));
  EXPECT_EQ(image.width, kWidth);
  EXPECT_EQ(image.height, kHeight);
  EXPECT_GT(CountColoured(image), kWidth * kHeight / 20) << "no box";

  // Of the nearest samples, each once.
  EXPECT_EQ(Render(scene_ + " " + trajectory_ + " --times 0.21,0.066,0.079 --out " + Path("given")).status, 0);
  EXPECT_EQ(Pictures("given"), (Names{"t00.06s.png", "t00.08s.png", "t00.20s.png"}));
}

TEST_F(RenderTest, PicturesOfAnotherTrajectory_AreNotReplacedWithoutAWord) {
  const std::string folder = " --out " + Path("pictures");
  ASSERT_EQ(Render(scene_ + " " + trajectory_ + " --times 0" + folder).status, 0);
  EXPECT_EQ(Render(scene_ + " " + trajectory_ + " --times 0.2" + folder).status, 0) << "more of the same";
  folder_.Write("other.npy", With(11 * 2 * 14 - 1, 0.001));
  const std::string other = scene_ + " " + Path("other.npy") + " --times 0" + folder;
  const Outcome refused = Render(other);
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(Count(refused.output, "pictures: has the results of another run, with trajectory "), 1) << refused.output;
  EXPECT_EQ(Pictures("pictures"), (Names{"t00.00s.png", "t00.20s.png"}));
  const Outcome replaced = Render(other + " --overwrite");
  EXPECT_EQ(replaced.status, 0) << replaced.output;
  EXPECT_EQ(Count(replaced.output, "; replaced\n"), 1) << replaced.output;
  EXPECT_EQ(Pictures("pictures"), (Names{"t00.00s.png"}));
}

// The ground stays where it is while the box falls.
TEST_F(RenderTest, Frames_AreSeenFromTheSamePlace) {
  ASSERT_EQ(Render(scene_ + " " + trajectory_ + " --every 0.1 --out " + Path("film")).status, 0);
  EXPECT_EQ(Pictures("film"), (Names{"frame_00000.png", "frame_00001.png", "frame_00002.png"}));
  const Image first = ReadPng(Path("film/frame_00000.png")), last = ReadPng(Path("film/frame_00002.png"));
  EXPECT_GT(CountDifferences(first, last, kMiddle), 500) << "the box has not moved";
  EXPECT_LT(CountDifferences(first, last, kLowerLeft), 50);

  ASSERT_EQ(Render(scene_ + " " + trajectory_ + " --times 0 --out " + Path("a")).status, 0);
  ASSERT_EQ(Render(scene_ + " " + trajectory_ + " --times 0.2 --out " + Path("b")).status, 0);
  const Image alone = ReadPng(Path("a/t00.00s.png")), fallen = ReadPng(Path("b/t00.20s.png"));
  EXPECT_GT(CountDifferences(alone, fallen, kLowerLeft), 200) << "this test sees no camera move";
}

TEST_F(RenderTest, WorldFile_IsDrawnByRunAndByRender) {
  ASSERT_EQ(Sim("export " + scene_ + " " + Path("box.bullet")).status, 0);
  const Outcome run =
      Sim("run " + Path("box.bullet") + " --narrowphase dgd --trajectory --duration 0.2 --out " + Path("world"));
  ASSERT_EQ(run.status, 0) << run.output;
  for (const char* name : {"dgd_t00.00s.png", "dgd_t00.10s.png", "dgd_t00.20s.png", "end_state.png"}) {
    EXPECT_GT(CountColoured(ReadPng(Path(std::string("world/") + name))), 1280 * 720 / 50) << name;
  }
  const Outcome render =
      Render(Path("box.bullet") + " " + Path("world/dgd_trajectory.npy") + " --out " + Path("again"));
  ASSERT_EQ(render.status, 0) << render.output;
  EXPECT_EQ(Pictures("again"), (Names{"t00.00s.png", "t00.10s.png", "t00.20s.png"}));
  // Shapes from Bullet or from the scene, the picture is the same but for its title and the ends of the colour scale.
  ASSERT_EQ(Render(scene_ + " " + trajectory_ + " --times 0,0.1,0.2 --out " + Path("scene")).status, 0);
  const Image world = ReadPng(Path("again/t00.00s.png")), scene = ReadPng(Path("scene/t00.00s.png"));
  EXPECT_LT(CountDifferences(world, scene, kMiddle), kWidth * kHeight / 100);
}

TEST_F(RenderTest, KilledRunsTrajectory_IsDrawnAsFarAsItsHeadCounts) {
  std::string killed = WithText("(11, 2)", "(3, 2)");
  killed += "part of a row";
  const Outcome outcome = RenderBytes("killed.npy", killed);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const Outcome beyond = Render(scene_ + " " + Path("killed.npy") + " --times 0.1 --out " + Path("refused"));
  EXPECT_EQ(beyond.status, 2);
  EXPECT_EQ(Count(beyond.output, "killed.npy: has no sample at 0.1 s: its times are from 0 to 0.04 s"), 1)
      << beyond.output;
}

TEST_F(RenderTest, WrongTrajectory_Status2AndASentenceWithFileAndValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string beyond = "18446744073709551615";
  for (const auto& [bytes, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"", "is no .npy file"},
           {"time,position\n0,1\n", "is no .npy file"},
           {std::string(bytes_).replace(6, 1, "\x02"), "has version 2 of the .npy format"},
           {bytes_.substr(0, 500), "is cut off: its head takes 1024 bytes, and it has 500"},
           {bytes_.substr(0, bytes_.size() - 1), "is cut off: it counts 11 samples of 2 bodies"},
           {WithText("(11, 2)", "(1, " + beyond + ")"), "is cut off: it counts 1 samples of " + beyond},
           {WithText("(11, 2)", "(" + beyond + ", 2)"), "is cut off: it counts " + beyond},
           {WithText("(11, 2)", "(1" + beyond + ", 2)"), "its head is {'descr'"},
           {WithText("(11, 2)", "(11,)"), "its head is {'descr'"},
           {WithText("(11, 2)", "(-1, 2)"), "its head is {'descr'"},
           {WithText("(11, 2)", "(0, 2)"), "has no samples: its shape is (0,2)"},
           {WithText("(11, 2)", "(11, 0)"), "has no samples: its shape is (11,0)"},
           {WithText("(11, 2)", "(22, 1)"), "the time of sample 1 is 0 s, after 0 s"},
           {WithText("(11, 2)", "(7, 3)"), "has 3 bodies, and "},
           {WithText("False", "True"), "in C order"},
           {WithText("'position'", "'po\x1b'"), "('po?','<f8',(3,))"},
           {WithText("'position'", "'place'"), "its columns are [('time','<f8'),('place','<f8',(3,))"},
           {With(28, nan), "the time of sample 1 is nan s, after 0 s"},
           {With(28, -1), "the time of sample 1 is -1 s, after 0 s"},
           {With(14 + 2, nan), "the position of body 1 in sample 0 is (0, nan, 1), which is not finite"},
           {With(14 + 2, 1e300),
            "the position of body 1 in sample 0 is (0, 1e+300, 1), which is not finite, or too far"},
           {With(14 + 4, nan), "the orientation of body 1 in sample 0 is (nan, 0, "},
           {With(14 + 7, 3), "which is no unit quaternion"},
           {With(14 + 8, nan), "the velocity of body 1 in sample 0 is (nan, 0, 0), which is not finite"},
           {With(14 + 1, 0.5), "body 1 begins at (0.5, 0, 1) m, and "}}) {
    const Outcome outcome = RenderBytes("bad.npy", bytes);
    EXPECT_EQ(outcome.status, 2) << complaint << ": " << outcome.output;
    EXPECT_EQ(Count(outcome.output, "bad.npy: "), 1) << outcome.output;
    EXPECT_EQ(Count(outcome.output, complaint), 1) << complaint << ": " << outcome.output;
    EXPECT_EQ(Count(outcome.output, "\n"), 1) << outcome.output;
  }
}

TEST_F(RenderTest, BadInput_Status2) {
  for (const auto& [arguments, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"", "world is required"},
           {scene_, "trajectory is required"},
           {scene_ + " nowhere.npy", "nowhere.npy: cannot be opened"},
           {scene_ + " /", "/: cannot be read"},
           {"nowhere " + trajectory_, "nowhere: there is no such scene"},
           {"coin " + trajectory_, "body 1 begins at"},
           {scene_ + " " + trajectory_ + " --times 0,0.5", "has no sample at 0.5 s: its times are from 0 to 0.2 s"},
           {scene_ + " " + trajectory_ + " --times -1", "--times"},
           {scene_ + " " + trajectory_ + " --times nan", "--times"},
           {scene_ + " " + trajectory_ + " --times 0 --every 1", "--times and --every: give one of them"},
           {scene_ + " " + trajectory_ + " --every 0", "--every: must be above 0 s"},
           {scene_ + " " + trajectory_ + " --every nan", "--every: 'nan' is no number"},
           {scene_ + " " + trajectory_ + " --every 1e-9", "--every: 1e-09 s makes 2e+08 frames"},
           {scene_ + " " + trajectory_ + " --seed x", "--seed"}}) {
    const Outcome outcome = Render(arguments + " --out " + Path("bad"));
    EXPECT_EQ(outcome.status, 2) << arguments << ": " << outcome.output;
    EXPECT_GE(Count(outcome.output, complaint), 1) << arguments << ": " << outcome.output;
  }
  for (const std::string size : {"1280", "1280x", "x720", "1280x720x3", "10x10", "99999x100", "-1x-1", "axb"}) {
    const Outcome outcome = Sim("render " + scene_ + " " + trajectory_ + " --size " + size);
    EXPECT_EQ(outcome.status, 2) << size;
    EXPECT_EQ(Count(outcome.output, ", not " + size + "\n"), 1) << outcome.output;
  }
  EXPECT_EQ(Render(scene_ + " " + trajectory_ + " --out /dev/null/x").status, 2) << "a folder in a file";
}

}  // namespace
}  // namespace dgd_demos
