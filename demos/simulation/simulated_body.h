// A body of a run, from a scene or from a world file of Bullet's.
#pragma once

#include <Eigen/Core>
#include <string>

#include "scene/bodies.h"

namespace dgd_demos {

struct SimulatedBody {
  std::string name;       ///< Name in messages.
  bool moves;             ///< False: static.
  Eigen::Vector3d start;  ///< Position of the local origin at the beginning, world frame, m.
  double radius;          ///< Radius of the ball about the local origin that contains the body, m; infinite for planes.
};

inline SimulatedBody SimulatedBodyOf(const Body& body) {
  return {body.name, body.mass > 0, body.pose.position, BoundingRadius(body.shape, body.margin)};
}

}  // namespace dgd_demos
