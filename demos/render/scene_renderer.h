// Pictures of a scene.
//
// A picture is the mean of many passes. Each pass has one light, from a direction of its own with hard shadows, and its
// own offset within the pixel. The mean has soft shadows, of the sun's disc and of the sky (which darkens the gaps
// between bodies), and smooth edges; and each pass is as simple as a picture can be.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/drawn_body.h"
#include "render/image.h"
#include "render/overlay.h"
#include "render/speed_colour.h"
#include "simulation/snapshot.h"

namespace dgd_demos {

struct PictureRequest {
  const Snapshot& state;
  Camera camera;
  std::string title;     ///< Top left, large.
  std::string subtitle;  ///< Below the title.
  /// Colour of each body in place of its speed's, sRGB, components from 0 to 1; that of a floor is not used. Empty: by
  /// speed.
  std::vector<Eigen::Vector3d> colours = {};
  std::vector<LegendEntry> legend = {};  ///< In place of the scale of speeds; empty for that.
};

class SceneRenderer {
 public:
  /// @param bodies         in the order of each state's poses; +z is up.
  /// @param width, height  of the pictures, pixels.
  SceneRenderer(std::vector<DrawnBody> bodies, const SpeedScale& speed_scale, int width, int height);
  ~SceneRenderer();

  Image Render(const PictureRequest& request);
  double aspect() const;

 private:
  class Impl;  // Keeps OpenGL out of this header.
  std::unique_ptr<Impl> impl_;
};

}  // namespace dgd_demos
