// When an arm is where on a path: angles and velocities over time, within the joints' limits.
#pragma once

#include <vector>

#include "motion/arm.h"
#include "motion/joint_path.h"

namespace dgd_demos {

struct TimingOptions {
  /// Of every joint, rad/s^2. Makers publish velocity limits, but no accelerations. With this much, a stretched-out
  /// UR5e needs less than two thirds of its shoulder's effort, gravity included.
  double max_acceleration = 5;
  /// How far the corners are cut at most, rad: the Euclidean distance in joint space from the nearest configuration of
  /// the path. 0: the arm stops at each corner. A point at most a metre from all axes is then off its path by at most
  /// this many metres times the root of the number of joints: a path needs that much clearance.
  double max_deviation = 1e-3;
};

struct JointState {
  Configuration angles;      ///< rad
  Configuration velocities;  ///< rad/s
};

/// Starts and ends at rest, in the path's first and last configuration. Each joint's velocity is continuous and within
/// its limit; its acceleration is constant but for jumps.
///
/// Corners are replaced by parabolas, which are run through under constant acceleration, as fast as the limits allow;
/// between them, the speed along the straight part goes up, stays and goes down again (linear segments with parabolic
/// blends: Craig, Introduction to Robotics, section 7.3; here with speeds that the deviation allows).
class TimedPath {
 public:
  /// @param path  At least one configuration; those equal to the one before are skipped.
  /// @throws std::invalid_argument if the path is empty or has a configuration of another size or that is not finite,
  ///         or for options that are negative, not finite, or an acceleration of 0.
  TimedPath(const Arm& arm, const JointPath& path, const TimingOptions& options = {});

  double Duration() const;  ///< s

  /// At a time from 0 to Duration(); earlier and later, the arm rests at the path's ends.
  JointState Sample(double time) const;

 private:
  /// A piece of constant acceleration.
  struct Piece {
    double begin, duration;  // s
    Configuration angles, velocities, accelerations;
  };
  struct Part;

  void Append(double duration, const Configuration& angles, const Configuration& velocities,
              const Configuration& accelerations);
  void AppendStraight(const Part& part, double speed_in, double speed_out);
  static std::vector<Part> SplitIntoParts(const Arm& arm, const JointPath& path, double max_acceleration);
  static std::vector<double> CutCorners(std::vector<Part>& parts, const TimingOptions& options);

  std::vector<Piece> pieces_;
  Configuration first_, last_;
};

}  // namespace dgd_demos
