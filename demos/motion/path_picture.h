// A motion in one picture: the arm along its path, and the way of its flange.
#pragma once

#include <string>
#include <vector>

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

struct ExecutionPicture {
  const CollisionModel& model;
  const JointPath& planned;          ///< Whose trace is drawn in grey.
  const std::vector<double>& times;  ///< Of the states, s.
  const JointPath& states;           ///< As the arm was in the simulation; the trace is red.
  double turn = 0;                   ///< As above.
};

/// The arm at six moments, from the first state to the last, each with the flange's way until then.
Image DrawContactSheet(const ExecutionPicture& picture);

/// Draws off screen; some seconds.
Image Draw(const PathPicture& picture);

}  // namespace dgd_demos
