// How a world is seen in pictures: its bodies as they are drawn, and which way is up.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "render/drawn_body.h"
#include "render/speed_colour.h"
#include "scene/bodies.h"
#include "scene/scene.h"
#include "simulation/simulated_world.h"
#include "simulation/snapshot.h"

namespace dgd_demos {

struct WorldView {
  std::vector<DrawnBody> bodies;  ///< In the order of a snapshot's poses.
  /// Rotation from the world to the view, in which +z is up.
  Eigen::Matrix3d world_to_view = Eigen::Matrix3d::Identity();
  /// Without one, ScaleFor() makes it for what is drawn.
  std::optional<SpeedScale> scale = std::nullopt;
};

/// A scene: up is z; the colour scale ends at the speed of a free fall from the highest start to the ground.
WorldView ViewOf(const Scene& scene, const std::vector<Body>& bodies);

/// A world by Bullet's shapes, where it is now: up is opposite gravity. Static planes and boxes that are level, and
/// wider than all that moves, are floors; other static bodies are scenery.
WorldView ViewOf(SimulatedWorld& world);

/// The state with its poses in the view's frame.
Snapshot InView(const WorldView& view, Snapshot state);

/// The view's own scale, or one for speeds up to that of the fastest body drawn, m/s.
SpeedScale ScaleFor(const WorldView& view, double fastest);

}  // namespace dgd_demos
