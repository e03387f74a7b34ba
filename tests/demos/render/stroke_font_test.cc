// Contract: every character that the pictures use has a glyph of its own, within the line; others come out as a box.
#include "render/stroke_font.h"

#include <gtest/gtest.h>

#include <string>

namespace dgd_demos {
namespace {

TEST(StrokeFontTest, EveryLetterAndDigit_HasAGlyphWithinTheLine) {
  const std::string all = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz.,:;-+=_/()%<>";
  const auto box = StrokesOf("@").strokes;
  for (const char letter : all) {
    const TextStrokes glyph = StrokesOf(std::string(1, letter));
    EXPECT_NE(glyph.strokes, box) << letter;
    EXPECT_FALSE(glyph.strokes.empty()) << letter;
    for (const Stroke& stroke : glyph.strokes) {
      for (const Eigen::Vector2d& point : stroke) {
        EXPECT_GE(point.x(), 0) << letter;
        EXPECT_LE(point.x(), glyph.width + 1e-12) << letter;
        EXPECT_GE(point.y(), -0.34) << letter;  // Descenders.
        EXPECT_LE(point.y(), 1) << letter;
      }
    }
  }
}

TEST(StrokeFontTest, Text_IsAsWideAsItsLettersAndTheGapsBetween) {
  const double one = StrokesOf("n").width, two = StrokesOf("nn").width, three = StrokesOf("nnn").width;
  EXPECT_GT(two, 2 * one);
  EXPECT_NEAR(three - two, two - one, 1e-12);
  EXPECT_EQ(StrokesOf("").width, 0);
}

}  // namespace
}  // namespace dgd_demos
