// Scenes for motion planning: arms, obstacles, and which motion is wanted. scenes/README.md describes the file format.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "motion/arm.h"
#include "scene/pose.h"
#include "scene/scene_error.h"
#include "scene/shape.h"

namespace dgd_demos {

/// A fixed convex body.
struct Obstacle {
  std::string name;
  Shape shape;
  Pose pose;  ///< In the world.
};

/// An arm, where it stands still if no motion is planned for it, and which of its links are not checked.
struct SceneArm {
  Arm arm;
  Configuration rest;
  /// Names of a link and of another link or an obstacle that are never checked against each other: they are mounted on
  /// each other, or cannot meet in any configuration. Neighbouring links are not checked in any case.
  std::vector<std::pair<std::string, std::string>> unchecked;
};

struct MotionScene {
  std::string file;         ///< As given by the user.
  std::string about;        ///< What the scene is, with its units and frame.
  Eigen::Vector3d gravity;  ///< m/s^2
  std::vector<SceneArm> arms;
  std::vector<Obstacle> obstacles;

  /// The motion that is wanted: of one arm; all others stay where they are, as obstacles.
  std::size_t planned_arm;  ///< Index into arms.
  Configuration start, goal;
  /// What the search keeps to, rad: within the joints' limits, which are the default. Closer ones keep a planner from
  /// winding up an arm whose joints make several turns.
  Configuration search_lower, search_upper;

  const Arm& PlannedArm() const { return arms[planned_arm].arm; }
};

/// Reads a scene file and the meshes it names (their paths are relative to the scene file).
/// @throws SceneError that names file, JSON path and value; for broken JSON, line and column. Also for a start, goal or
///         rest that exceeds a joint's limits, and for joints, links and obstacles that are named but not there.
MotionScene LoadMotionScene(const std::filesystem::path& file);

}  // namespace dgd_demos
