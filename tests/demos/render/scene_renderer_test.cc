// Contract: pictures of the size asked for, in which bodies can be seen, are coloured by their speed or as asked for,
// and cast shadows; the same state gives the same picture.
#include "render/scene_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "picture_file.h"
#include "render/png_file.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

constexpr int kWidth = 320, kHeight = 180;

struct Colour {
  double red = 0, green = 0, blue = 0;
};

Colour MeanAround(const Image& image, int column, int row) {
  Colour mean;
  constexpr int kReach = 3;
  constexpr double kCount = (2 * kReach + 1) * (2 * kReach + 1);
  for (int y = row - kReach; y <= row + kReach; ++y) {
    for (int x = column - kReach; x <= column + kReach; ++x) {
      const std::uint8_t* pixel = image.Pixel(x, y);
      mean.red += pixel[0] / kCount;
      mean.green += pixel[1] / kCount;
      mean.blue += pixel[2] / kCount;
    }
  }
  return mean;
}

// A single ball in the middle of the picture, at a height, at a speed.
class SceneRendererTest : public testing::Test {
 protected:
  SceneRendererTest() : renderer_(DrawnBodiesOf(Bodies()), SpeedScale(10), kWidth, kHeight) {}

  static std::vector<Body> Bodies() {
    std::vector<Body> bodies = MakeBodies(SmallDropScene(), 1);
    bodies.resize(2);
    bodies[1].shape = Sphere{0.5};
    return bodies;
  }
  static Snapshot State(double speed) {
    Pose ground, ball;
    ground.position.z() = -0.5;
    ball.position.z() = 0.5;
    return {0, {ground, ball}, {0, speed}};
  }
  Image Draw(const Snapshot& state, const std::string& title = "") {
    const Camera camera{Eigen::Vector3d(0, 0, 0.5), 10};
    return renderer_.Render({state, camera, title, ""});
  }

  SceneRenderer renderer_;
};

TEST_F(SceneRendererTest, Picture_HasTheSizeAndIsNotBlank) {
  const Image image = Draw(State(0));
  EXPECT_EQ(image.width, kWidth);
  EXPECT_EQ(image.height, kHeight);
  ASSERT_EQ(image.rgb.size(), 3u * kWidth * kHeight);
  std::set<std::tuple<int, int, int>> colours;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    colours.emplace(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
  EXPECT_GT(colours.size(), 500u);
}

TEST_F(SceneRendererTest, StillBody_IsBlueAndFastBodyIsRed) {
  const Colour still = MeanAround(Draw(State(0)), kWidth / 2, kHeight / 2);
  const Colour fast = MeanAround(Draw(State(10)), kWidth / 2, kHeight / 2);
  EXPECT_GT(still.blue, still.red + 50);
  EXPECT_GT(fast.red, fast.blue + 50);
}

TEST_F(SceneRendererTest, ColourOfTheRequest_IsTheBodysWhateverItsSpeed) {
  const Snapshot state = State(10);
  PictureRequest request{state, Camera{Eigen::Vector3d(0, 0, 0.5), 10}, "", ""};
  request.colours = {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.1, 0.8, 0.1)};
  const Colour green = MeanAround(renderer_.Render(request), kWidth / 2, kHeight / 2);
  EXPECT_GT(green.green, green.red + 50);
  EXPECT_GT(green.green, green.blue + 50);
}

TEST_F(SceneRendererTest, Legend_StandsInPlaceOfTheScale) {
  const Snapshot state = State(0);
  PictureRequest request{state, Camera{Eigen::Vector3d(0, 0, 0.5), 10}, "", ""};
  const Image scale = renderer_.Render(request);
  request.legend = {{Eigen::Vector3d(0.1, 0.1, 0.9), "ball"}, {Eigen::Vector3d(0.9, 0.1, 0.1), "trace"}};
  const Image legend = renderer_.Render(request);
  int bluest = 0, reddest = 0;  // How much more of the colour than of its opposite, lower left.
  for (int row = kHeight * 3 / 4; row < kHeight; ++row) {
    for (int column = 0; column < kWidth / 4; ++column) {
      const std::uint8_t* pixel = legend.Pixel(column, row);
      bluest = std::max(bluest, pixel[2] - pixel[0]);
      reddest = std::max(reddest, pixel[0] - pixel[2]);
    }
  }
  EXPECT_GT(bluest, 100);
  EXPECT_GT(reddest, 100);
  // The scale of speeds was lower right.
  EXPECT_NE(scale.Pixel(kWidth - 60, kHeight - 15)[0], legend.Pixel(kWidth - 60, kHeight - 15)[0]);
}

TEST_F(SceneRendererTest, FasterBodies_AreRedderAndLessBlue) {
  Colour slower = MeanAround(Draw(State(0)), kWidth / 2, kHeight / 2);
  for (const double speed : {0.6, 2.5, 5.6, 10.0}) {
    const Colour faster = MeanAround(Draw(State(speed)), kWidth / 2, kHeight / 2);
    EXPECT_GT(faster.red - faster.blue, slower.red - slower.blue) << speed;
    slower = faster;
  }
}

TEST_F(SceneRendererTest, Body_DarkensTheGroundBesideIt) {
  Snapshot elsewhere = State(0);
  elsewhere.poses[1].position = Eigen::Vector3d(-3, 3, 0.5);  // Towards the back: its shadow falls elsewhere, too.
  const Image with = Draw(State(0)), without = Draw(elsewhere);
  // The sun is on the left, so the shadow is right of the ball.
  const int column = kWidth / 2 + 26, row = kHeight / 2 + 12;
  EXPECT_LT(MeanAround(with, column, row).green, MeanAround(without, column, row).green - 15);
}

TEST_F(SceneRendererTest, Title_IsDrawnTopLeft) {
  const Image with = Draw(State(0), "Title"), without = Draw(State(0));
  int darkest = 255;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const bool is_title = row < kHeight / 6 && column < kWidth / 3;
      if (is_title) {
        darkest = std::min<int>(darkest, with.Pixel(column, row)[0]);
      } else {
        ASSERT_EQ(with.Pixel(column, row)[0], without.Pixel(column, row)[0]) << column << ", " << row;
      }
    }
  }
  EXPECT_LT(darkest, 120);
}

TEST_F(SceneRendererTest, SameState_SamePicture) { EXPECT_EQ(Draw(State(3)).rgb, Draw(State(3)).rgb); }

TEST_F(SceneRendererTest, TwoRenderers_DoNotDisturbEachOther) {
  const Image before = Draw(State(3));
  SceneRenderer other(DrawnBodiesOf(Bodies()), SpeedScale(10), 64, 64);
  EXPECT_EQ(other.Render({State(3), Camera{Eigen::Vector3d::Zero(), 10}, "", ""}).width, 64);
  EXPECT_EQ(Draw(State(3)).rgb, before.rgb);
}

TEST_F(SceneRendererTest, PngFile_ReadsBackToTheSamePixels) {
  const TestFolder folder;
  const Image image = Draw(State(3));
  WritePng(folder.path() / "picture.png", image);

  const Image read = ReadPng(folder.path() / "picture.png");
  EXPECT_EQ(read.width, kWidth);
  EXPECT_EQ(read.height, kHeight);
  EXPECT_EQ(read.rgb, image.rgb);
}

TEST(PngFileTest, FolderThatDoesNotExist_IsNamed) {
  try {
    WritePng("nowhere/picture.png", Image(2, 2));
    FAIL() << "no complaint";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere/picture.png: cannot be written"), std::string::npos);
  }
}

TEST(ImageTest, SideBySide_KeepsBothPictures) {
  Image left(2, 3), right(4, 3);
  std::ranges::fill(left.rgb, std::uint8_t{10});
  std::ranges::fill(right.rgb, std::uint8_t{200});
  const Image both = SideBySide(left, right);
  EXPECT_GT(both.width, 6);
  EXPECT_EQ(both.height, 3);
  EXPECT_EQ(both.Pixel(1, 2)[2], 10);
  EXPECT_EQ(both.Pixel(both.width - 4, 0)[0], 200);
}

}  // namespace
}  // namespace dgd_demos
