// Bodies as the renderer takes them, whoever made them: surfaces, and what each of them means for a picture.
#pragma once

#include <vector>

#include "render/camera.h"
#include "render/surface_mesh.h"
#include "scene/bodies.h"
#include "simulation/snapshot.h"

namespace dgd_demos {

/// A body in a view whose z axis points up.
struct DrawnBody {
  enum class Role {
    kBody,     ///< Always in the frame; its colour is that of its speed.
    kScenery,  ///< Static, grey; in the frame where it lies near the bodies.
    kFloor,    ///< Chequered, fades into the background, casts no shadow; not in the frame.
  };

  SurfaceMesh surface;  ///< In the body's frame, m.
  double radius;        ///< Radius of the ball about the local origin that contains the body, m; infinite for planes.
  Role role = Role::kBody;
};

/// Bodies of a scene, see MakeBodies(): the ground as the floor, and all others as bodies.
std::vector<DrawnBody> DrawnBodiesOf(const std::vector<Body>& bodies);

/// Balls around all bodies with the role kBody.
std::vector<Ball> BallsAround(const std::vector<DrawnBody>& bodies, const Snapshot& state);

/// The smallest ball about the mean of the centres that contains all balls; radius 0 for none.
Ball BallAroundAll(const std::vector<Ball>& balls);

/// What must be in a picture, for FrameAll(): the given balls, and those of the scenery that lies near them. Without
/// balls, as in a world where nothing moves, all that is finite; at least one ball.
/// @param balls  from BallsAround(), of one state or of several.
/// @param state  where the scenery is. @pre at least one body.
std::vector<Ball> WithSurroundings(std::vector<Ball> balls, const std::vector<DrawnBody>& bodies,
                                   const Snapshot& state);

}  // namespace dgd_demos
