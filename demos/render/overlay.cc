#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "render/colour_space.h"
#include "render/gl.h"
#include "render/shaders.h"
#include "render/stroke_font.h"

namespace dgd_demos {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Sizes are in pixels of a picture of this height, and grow with it; of one at least this wide.
constexpr double kDesignHeight = 720, kDesignWidth = 960;
constexpr double kMarginSize = 36;
constexpr double kTitleHeight = 24, kSubtitleHeight = 15, kLabelHeight = 12;
constexpr double kBarWidth = 260, kBarHeight = 12;
constexpr double kPenShare = 0.13;      // Pen width in heights of a capital.
const Vector3d kInk(0.17, 0.20, 0.25);  // sRGB

void SetColour(const Vector3d& srgb) {
  const Vector3d encoded = EncodeLinear(LinearFromSrgb(srgb));
  glColor3d(encoded.x(), encoded.y(), encoded.z());
}

void DrawDisc(const Vector2d& centre, double radius) {
  constexpr int kCorners = 12;
  glBegin(GL_TRIANGLE_FAN);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    glVertex2d(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle));
  }
  glEnd();
}

void DrawLine(const Vector2d& start, const Vector2d& end, double width) {
  const Vector2d along = (end - start).normalized();
  const Vector2d side = width / 2 * Vector2d(-along.y(), along.x());
  glBegin(GL_TRIANGLE_FAN);
  for (const Vector2d& corner :
       {Vector2d(start + side), Vector2d(start - side), Vector2d(end - side), Vector2d(end + side)}) {
    glVertex2d(corner.x(), corner.y());
  }
  glEnd();
}

// `origin`: left end of the base line.
void DrawText(const TextStrokes& text, const Vector2d& origin, double height) {
  const double pen = kPenShare * height;
  for (const Stroke& stroke : text.strokes) {
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      const Vector2d point = origin + height * stroke[i];
      DrawDisc(point, pen / 2);  // Round ends and joints.
      if (i > 0) DrawLine(origin + height * stroke[i - 1], point, pen);
    }
  }
}

void DrawCentred(const std::string& text, const Vector2d& middle, double height) {
  const TextStrokes strokes = StrokesOf(text);
  DrawText(strokes, middle - Vector2d(strokes.width * height / 2, 0), height);
}

void DrawGradient(const Vector2d& corner, double width, double height) {
  constexpr int kSteps = 64;
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i <= kSteps; ++i) {
    const double place = static_cast<double>(i) / kSteps;
    SetColour(SpeedScale::ColourAt(place));
    glVertex2d(corner.x() + place * width, corner.y());
    glVertex2d(corner.x() + place * width, corner.y() + height);
  }
  glEnd();
}

// Speeds to mark: the ends, and powers of two between them that leave room for their labels.
std::vector<double> MarkedSpeeds(double fastest) {
  std::vector<double> speeds = {0};
  for (int power = int(std::ceil(std::log2(fastest / 14))); std::exp2(power) < 0.75 * fastest; ++power) {
    speeds.push_back(std::exp2(power));
  }
  speeds.push_back(fastest);
  return speeds;
}

void DrawScale(const SpeedScale& scale, double width, double unit) {
  const Vector2d corner(width - (kMarginSize + kBarWidth) * unit, (kMarginSize + kLabelHeight + 8) * unit);
  DrawGradient(corner, kBarWidth * unit, kBarHeight * unit);
  SetColour(kInk);
  double free_from = 0;  // Right end of the last label, with a gap.
  for (const double speed : MarkedSpeeds(scale.fastest())) {
    const Vector2d tick = corner + Vector2d(scale.PlaceOf(speed) * kBarWidth * unit, 0);
    std::array<char, 16> label;
    std::snprintf(label.data(), label.size(), "%.3g", speed);
    const double half_width = StrokesOf(label.data()).width * kLabelHeight * unit / 2;
    if (tick.x() - half_width < free_from) continue;
    free_from = tick.x() + half_width + 3 * unit;
    DrawLine(tick, tick - Vector2d(0, 4 * unit), 1.2 * unit);
    DrawCentred(label.data(), tick - Vector2d(0, (kLabelHeight + 8) * unit), kLabelHeight * unit);
  }
  const Vector2d above = corner + Vector2d(kBarWidth / 2 * unit, (kBarHeight + 8) * unit);
  DrawCentred("speed (m/s)", above, kLabelHeight * unit);
}

// One entry above the other, from the lower left corner.
void DrawLegend(const std::vector<LegendEntry>& legend, double unit) {
  constexpr double kLine = 24, kSwatch = 14;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double from_below = static_cast<double>(legend.size() - 1 - i);
    const Vector2d corner(kMarginSize * unit, (kMarginSize + kLine * from_below) * unit);
    const Vector2d along(kSwatch * unit, 0), middle(0, kSwatch / 2 * unit);
    SetColour(legend[i].colour);
    DrawLine(corner + middle, corner + middle + along, kSwatch * unit);
    SetColour(kInk);
    DrawText(StrokesOf(legend[i].text), corner + 1.6 * along + Vector2d(0, 1.5 * unit), kLabelHeight * unit);
  }
}

}  // namespace

void DrawOverlay(const OverlayText& text, const SpeedScale& scale, int width, int height, const Vector2d& jitter) {
  const double unit = std::min(height / kDesignHeight, width / kDesignWidth);
  glUseProgram(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(jitter.x(), width + jitter.x(), jitter.y(), height + jitter.y(), -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();

  SetColour(kInk);
  const double title_base = height - (kMarginSize + kTitleHeight) * unit;
  DrawText(StrokesOf(text.title), Vector2d(kMarginSize * unit, title_base), kTitleHeight * unit);
  const double subtitle_base = title_base - (kSubtitleHeight + 18) * unit;
  DrawText(StrokesOf(text.subtitle), Vector2d(kMarginSize * unit, subtitle_base), kSubtitleHeight * unit);
  if (text.legend.empty()) {
    DrawScale(scale, width, unit);
  } else {
    DrawLegend(text.legend, unit);
  }
}

}  // namespace dgd_demos
