// From where the light of each pass comes, and where within the pixel it looks.
#pragma once

#include <Eigen/Core>

namespace dgd_demos {

struct LightSample {
  Eigen::Vector3d direction;  ///< Towards the light, unit.
  double strength;            ///< Irradiance across the direction.
};

/// Even passes have a point of the sun's disc, odd ones a point of the sky. Over `count` passes both are covered
/// evenly, and the mean irradiance of open ground is close to 1.
LightSample LightOfPass(int pass, int count);

/// In pixels, each component from -0.5 to 0.5.
Eigen::Vector2d JitterOfPass(int pass);

}  // namespace dgd_demos
