// From a scene and a seed to the bodies that are simulated.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/pose.h"
#include "scene/scene.h"
#include "scene/shape.h"

namespace dgd_demos {

struct Body {
  std::string name;  ///< Where it stands in the scene file, for messages.
  Shape shape;
  double margin;                           ///< Collision margin asked for, m; see RoundingRadius().
  double mass;                             ///< kg; 0: static.
  std::optional<Eigen::Vector3d> inertia;  ///< About the local axes, kg m^2; without it, Bullet's estimate.
  double friction;
  double restitution;
  double damping;  ///< Share of linear and angular velocity lost in a second.
  Pose pose;       ///< At the start.
  Motion motion;   ///< At the start.
};

/// The static ground is always the first body.
inline constexpr std::size_t kGroundIndex = 0;

/// Same scene and seed: same bodies, to the bit.
/// @throws SceneError if the random bodies of a group do not fit into their region without touching.
std::vector<Body> MakeBodies(const Scene& scene, std::uint64_t seed);

}  // namespace dgd_demos
