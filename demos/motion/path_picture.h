// A motion in one picture: the arm along its path, and the way of its flange.
#pragma once

#include <string>

#include "motion/collision_model.h"
#include "motion/joint_path.h"
#include "render/image.h"

namespace dgd_demos {

struct PathPicture {
  const CollisionModel& model;
  const JointPath& path;  ///< The arm is drawn at its start, at its goal, and at some places between; its trace is red.
  const JointPath& before;  ///< Whose trace is drawn in grey, thinner: the path before it was smoothed.
  std::string title, subtitle;
  double turn = 0;  ///< Of all that is seen, about the vertical axis, rad.
};

/// Draws off screen; some seconds.
Image Draw(const PathPicture& picture);

}  // namespace dgd_demos
