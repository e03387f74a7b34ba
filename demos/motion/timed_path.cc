#include "motion/timed_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace dgd_demos {
namespace {

// Configurations nearer to each other are the same one: the direction between them would be rounding. rad
constexpr double kLeastLength = 1e-9;

// Directions that differ less make no corner. The jump of velocity this hides is below 1e-8 rad/s.
constexpr double kLeastTurn = 1e-9;

void Check(const Arm& arm, const JointPath& path, const TimingOptions& options) {
  if (path.empty()) throw std::invalid_argument("A path to be timed has no configuration");
  for (const Configuration& configuration : path) {
    if (configuration.size() != static_cast<Eigen::Index>(arm.joints.size()) || !configuration.allFinite()) {
      throw std::invalid_argument("A path to be timed needs a finite angle for each joint of the arm " + arm.name);
    }
  }
  // False for NaN.
  const bool is_valid = options.max_acceleration > 0 && std::isfinite(options.max_acceleration) &&
                        options.max_deviation >= 0 && std::isfinite(options.max_deviation);
  if (!is_valid) throw std::invalid_argument("Timing needs an acceleration above 0 and a deviation of 0 or more");
}

}  // namespace

/// A straight part of the path between two corners; speed is the rate of the Euclidean distance in joint space.
struct TimedPath::Part {
  Configuration from, direction;  // Direction: unit vector.
  double length;                  // rad
  double max_speed, max_acceleration;
  double cut_in = 0, cut_out = 0;  // Taken from the length by the corners at its ends, rad.

  double StraightLength() const { return std::max(0.0, length - cut_in - cut_out); }
  // Of the speed at one end, if it is `speed` at the other.
  double FastestFrom(double speed) const { return std::sqrt(speed * speed + 2 * max_acceleration * StraightLength()); }
};

std::vector<TimedPath::Part> TimedPath::SplitIntoParts(const Arm& arm, const JointPath& path, double max_acceleration) {
  std::vector<Part> parts;
  Configuration from = path.front();
  for (const Configuration& to : path) {
    const double length = (to - from).norm();
    if (!(length > kLeastLength)) continue;
    Part part{from, (to - from) / length, length, std::numeric_limits<double>::infinity(), 0};
    // The joint that reaches its limit first decides.
    for (std::size_t i = 0; i < arm.joints.size(); ++i) {
      const double share = std::abs(part.direction[static_cast<Eigen::Index>(i)]);
      part.max_speed = std::min(part.max_speed, arm.joints[i].max_velocity / share);
    }
    part.max_acceleration = max_acceleration / part.direction.cwiseAbs().maxCoeff();
    parts.push_back(part);
    from = to;
  }
  return parts;
}

/// Chooses how much of each part its corners take.
/// @return the greatest speed at the parts' ends: one more than parts, 0 at the first and the last.
std::vector<double> TimedPath::CutCorners(std::vector<Part>& parts, const TimingOptions& options) {
  std::vector<double> speeds(parts.size() + 1, 0);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    Part &in = parts[i - 1], &out = parts[i];
    speeds[i] = std::min(in.max_speed, out.max_speed);
    const Configuration turn = out.direction - in.direction;
    if (turn.norm() <= kLeastTurn) continue;
    // The parabola from `cut` ahead of the corner to `cut` after it comes as near to the corner as cut * |turn| / 4.
    const double cut = std::min({4 * options.max_deviation / turn.norm(), in.length / 2, out.length / 2});
    in.cut_out = out.cut_in = cut;
    // It is run through in 2 * cut / speed, in which the velocity changes by speed * turn.
    speeds[i] = std::min(speeds[i], std::sqrt(2 * cut * options.max_acceleration / turn.cwiseAbs().maxCoeff()));
  }
  // What the straight parts between them can reach from the start, and brake from before the goal.
  for (std::size_t i = 0; i < parts.size(); ++i)
    speeds[i + 1] = std::min(speeds[i + 1], parts[i].FastestFrom(speeds[i]));
  for (std::size_t i = parts.size(); i-- > 0;) speeds[i] = std::min(speeds[i], parts[i].FastestFrom(speeds[i + 1]));
  return speeds;
}

TimedPath::TimedPath(const Arm& arm, const JointPath& path, const TimingOptions& options) {
  Check(arm, path, options);
  first_ = path.front();
  last_ = path.back();
  std::vector<Part> parts = SplitIntoParts(arm, path, options.max_acceleration);
  const std::vector<double> speeds = CutCorners(parts, options);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    AppendStraight(part, speeds[i], speeds[i + 1]);
    if (!(part.cut_out > 0)) continue;
    const double duration = 2 * part.cut_out / speeds[i + 1];
    const Configuration velocities = speeds[i + 1] * part.direction;
    Append(duration, part.from + (part.length - part.cut_out) * part.direction, velocities,
           (speeds[i + 1] * parts[i + 1].direction - velocities) / duration);
  }
}

void TimedPath::AppendStraight(const Part& part, double speed_in, double speed_out) {
  const double length = part.StraightLength(), acceleration = part.max_acceleration;
  if (!(length > 0)) return;
  // Speeding up all the way until braking is due would reach this speed.
  const double reached = std::sqrt(acceleration * length + (speed_in * speed_in + speed_out * speed_out) / 2);
  const double speed = std::max({std::min(reached, part.max_speed), speed_in, speed_out});
  const double up = (speed * speed - speed_in * speed_in) / (2 * acceleration);
  const double down = (speed * speed - speed_out * speed_out) / (2 * acceleration);
  const Configuration &from = part.from, &direction = part.direction;
  const Configuration no_acceleration = Configuration::Zero(from.size());
  Append((speed - speed_in) / acceleration, from + part.cut_in * direction, speed_in * direction,
         acceleration * direction);
  Append((length - up - down) / speed, from + (part.cut_in + up) * direction, speed * direction, no_acceleration);
  Append((speed - speed_out) / acceleration, from + (part.cut_in + length - down) * direction, speed * direction,
         -acceleration * direction);
}

void TimedPath::Append(double duration, const Configuration& angles, const Configuration& velocities,
                       const Configuration& accelerations) {
  if (duration > 0) pieces_.push_back({Duration(), duration, angles, velocities, accelerations});
}

double TimedPath::Duration() const { return pieces_.empty() ? 0 : pieces_.back().begin + pieces_.back().duration; }

JointState TimedPath::Sample(double time) const {
  const Configuration at_rest = Configuration::Zero(first_.size());
  if (!(time > 0)) return {first_, at_rest};
  if (time >= Duration()) return {last_, at_rest};
  const auto after = std::ranges::upper_bound(pieces_, time, {}, [](const Piece& piece) { return piece.begin; });
  const Piece& piece = *std::prev(after);
  const double t = time - piece.begin;
  return {piece.angles + t * piece.velocities + t * t / 2 * piece.accelerations,
          piece.velocities + t * piece.accelerations};
}

}  // namespace dgd_demos
