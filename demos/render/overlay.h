// Title and colour scale on top of a picture. Draws with the current OpenGL context.
#pragma once

#include <Eigen/Core>
#include <string>

#include "render/speed_colour.h"

namespace dgd_demos {

struct OverlayText {
  std::string title, subtitle;
};

/// @param jitter  offset of the whole drawing in pixels, for smooth edges in the mean over passes.
void DrawOverlay(const OverlayText& text, const SpeedScale& scale, int width, int height,
                 const Eigen::Vector2d& jitter);

}  // namespace dgd_demos
