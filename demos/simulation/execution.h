// A planned motion carried out by Bullet's dynamics: how well the arm follows, and what it touches. Free of Bullet.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/arm.h"
#include "motion/motion_scene.h"
#include "motion/timed_path.h"

namespace dgd_demos {

struct ExecutionOptions {
  double step_rate = 240;  ///< Steps a second, Hz.
  double hold_time = 0.5;  ///< After the path's end, in which the arm has to stay there, s.
  /// Share of a joint's position error that its motor corrects in a step; (0, 1]. 1 leaves no error wherever the effort
  /// suffices, as no controller does; less is as soft as a controller with that rate.
  double position_gain = 0.2;
  /// Iterations of Bullet's solver in a step. The effort of each joint's motor depends on all others, and converges by
  /// iterations, so that an arm needs more of them than Bullet's 10.
  int solver_iterations = 100;
};

/// State at the end of a step.
struct ExecutionStep {
  double time;                 ///< s
  Configuration planned;       ///< Angles of the timed path at that time, rad.
  Configuration angles;        ///< Angles of the joints in the world, rad.
  Eigen::VectorXd velocities;  ///< Velocities of the joints in the world, rad/s.
  Eigen::VectorXd efforts;     ///< Efforts of the motors in the step, N m; at most the joint's max_effort.
  Eigen::Vector3d flange;      ///< Position in the world by Bullet's pose of the last link, m.
  double tracking_error;       ///< Distance of the flange from its place at the planned angles, m.
  int contacts;                ///< Pairs in contact at the beginning of the step.
};

/// Two bodies in contact: they overlap, or one pushes the other. A link that runs into something overlaps it by up to
/// what it moves in a step before it is stopped: Bullet meets no part of a compound ahead.
struct ExecutionContact {
  std::string first, second;  ///< The first is a link of the planned arm. Links of other arms as "NAME's LINK".
  double begin, end;          ///< The first and the last time, s.
  double least_distance;      ///< m; negative for penetration.
  double greatest_force;      ///< Along the normals, N.
};

struct ExecutionResult {
  /// Why it ended before its time, in a sentence; nothing if it did not. What was found so far is kept.
  std::optional<std::string> failure;
  double duration = 0;  ///< Simulated, the hold included, s.

  double greatest_error = 0;                         ///< Greatest tracking error of the flange, m.
  double greatest_error_time = 0;                    ///< s
  Eigen::Vector3d greatest_error_place = {0, 0, 0};  ///< Position of the flange then, m.
  double rms_error = 0;                              ///< Over all steps, m.
  double final_error = 0;                            ///< At the end of the hold, m.
  double greatest_velocity_share = 0;                ///< Greatest share of a joint's max_velocity.
  double greatest_effort_share = 0;   ///< Greatest share of a joint's max_effort; 1 if a motor was too weak.
  std::string greatest_effort_joint;  ///< Whose effort that was.

  std::vector<ExecutionStep> steps;
  std::vector<ExecutionContact> contacts;  ///< Contacts in the order in which they began.
};

/// What the tracking error means: Bullet's joint motors are constraints of limited effort, solved together with the
/// arm's dynamics, so that they know the effort that each step needs. As long as no joint needs more than it has and
/// nothing is in the way, the error is of rounding, which no controller of a real arm achieves. A larger error means
/// that the motion is not one for these joints, or that the arm was held up; how near it is to the former, the shares
/// of effort and velocity say.
///
/// Simulates the scene's planned arm, with gravity and joint motors of limited effort, along the path and through the
/// hold after it. It starts at rest at the path's first configuration; obstacles and the other arms, at rest, are
/// fixed. Collisions, by the plugin, are those of the pairs that planning checks: neighbouring links and the scene's
/// unchecked pairs go through each other.
/// @param progress  Called with the share of the steps that is done, from 0 to 1; may be empty.
/// @throws std::invalid_argument for options out of their range.
ExecutionResult ExecutePath(const MotionScene& scene, const TimedPath& path, const ExecutionOptions& options = {},
                            const std::function<void(double)>& progress = {});

}  // namespace dgd_demos
