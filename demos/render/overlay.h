// Title and colour scale or legend on top of a picture. Draws with the current OpenGL context.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "render/speed_colour.h"

namespace dgd_demos {

/// A colour and what has it.
struct LegendEntry {
  Eigen::Vector3d colour;  ///< sRGB, components from 0 to 1.
  std::string text;
};

struct OverlayText {
  std::string title, subtitle;
  std::vector<LegendEntry> legend;  ///< In place of the colour scale; empty for that.
};

/// @param jitter  offset of the whole drawing in pixels, for smooth edges in the mean over passes.
void DrawOverlay(const OverlayText& text, const SpeedScale& scale, int width, int height,
                 const Eigen::Vector2d& jitter);

}  // namespace dgd_demos
