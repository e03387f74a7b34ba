// A small font made of strokes, for titles and legends: no font file, no font library.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace dgd_demos {

/// A pen stroke: a polyline in units of the height of a capital, y upwards from the base line. One point is a dot.
using Stroke = std::vector<Eigen::Vector2d>;

struct TextStrokes {
  std::vector<Stroke> strokes;
  double width;  ///< In units of the height of a capital.
};

/// ASCII letters, digits and the punctuation of physical quantities; anything else comes out as a box.
TextStrokes StrokesOf(std::string_view text);

}  // namespace dgd_demos
