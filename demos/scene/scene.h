// A scene as a value: what a scene file says, checked. SI units, radians, right-handed world frame with z up.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/pose.h"
#include "scene/shape.h"

namespace dgd_demos {

/// A static box whose top is the plane z = 0, centred below the origin.
struct Ground {
  Eigen::Vector3d half_extents;  ///< m
  double friction;
};

struct BodyProperties {
  double mass;                             ///< kg; 0: static (single bodies only).
  std::optional<Eigen::Vector3d> inertia;  ///< About the local axes, kg m^2; without it, Bullet's estimate.
  double friction;
  double restitution;
  double damping = 0;  ///< Share of linear and angular velocity that is lost in a second, as by air and by rolling.
};

/// Random hulls, different for each seed, at random orientations and without touching each other at the start.
struct RandomPolytopes {
  BodyProperties properties;
  int count;
  int min_vertices, max_vertices;          ///< Each body has a number drawn from this range, ends included.
  double diameter;                         ///< Greatest distance between two vertices, m; the margin comes on top.
  Eigen::Vector3d region_min, region_max;  ///< Box in which the centres start, m.
};

/// How a body moves at the start, in the world frame. Not at all, unless the file says so.
struct Motion {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< Of the centre of mass, m/s.
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s
};

struct SingleBody {
  BodyProperties properties;
  std::string kind;  ///< The file's "type", for messages.
  Shape shape;
  Pose pose;
  Motion motion = {};
};

using BodyGroup = std::variant<RandomPolytopes, SingleBody>;

inline constexpr double kMaxDuration = 3600;  ///< s; a slip if it is longer.
inline constexpr double kMaxSteps = 1e9;      ///< Of a run; an int has room for them.
inline constexpr double kMaxTimeStep = 0.1;   ///< s; a slip if it is longer.

/// Of Bullet's contact solver; as Bullet has them, unless the file says otherwise.
struct SolverSettings {
  int iterations = 10;  ///< In each step.
  /// 1: along the sliding velocity, and any while nothing slides. That lets a body creep which friction alone should
  /// hold. 2: across each other.
  int friction_directions = 1;
};

struct Scene {
  std::string file;         ///< As given by the user.
  std::string about;        ///< What the scene is, with its units and frame.
  Eigen::Vector3d gravity;  ///< m/s^2
  double time_step;         ///< s
  double duration;          ///< s
  double margin;            ///< Collision margin of every body and of the ground, m.
  Ground ground;
  bool sleeping = true;  ///< Whether Bullet may put bodies that hardly move to sleep, which ends their jitter.
  SolverSettings solver;
  std::vector<BodyGroup> bodies;
  std::vector<double> snapshots;  ///< Times of the pictures, s, ascending.
};

}  // namespace dgd_demos
