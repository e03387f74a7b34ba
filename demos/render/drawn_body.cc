#include "render/drawn_body.h"

#include <algorithm>
#include <cmath>

namespace dgd_demos {

using Eigen::Vector3d;
using Role = DrawnBody::Role;

std::vector<DrawnBody> DrawnBodiesOf(const std::vector<Body>& bodies) {
  std::vector<DrawnBody> drawn;
  for (const Body& body : bodies) {
    drawn.push_back({SurfaceOf(body.shape, body.margin), BoundingRadius(body.shape, body.margin),
                     drawn.size() == kGroundIndex ? Role::kFloor : Role::kBody});
  }
  return drawn;
}

std::vector<Ball> BallsAround(const std::vector<DrawnBody>& bodies, const Snapshot& state) {
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].role == Role::kBody) balls.push_back({state.poses[i].position, bodies[i].radius});
  }
  return balls;
}

Ball BallAroundAll(const std::vector<Ball>& balls) {
  Vector3d middle = Vector3d::Zero();
  for (const Ball& ball : balls) middle += ball.centre / static_cast<double>(balls.size());
  double radius = 0;
  for (const Ball& ball : balls) radius = std::max(radius, (ball.centre - middle).norm() + ball.radius);
  return {middle, radius};
}

std::vector<Ball> WithSurroundings(std::vector<Ball> balls, const std::vector<DrawnBody>& bodies,
                                   const Snapshot& state) {
  constexpr double kReach = 2;  // Scenery is near if it lies within so many radii of the ball around all balls.
  const bool nothing_moves = balls.empty();
  const Ball all = BallAroundAll(balls);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Ball ball{state.poses[i].position, bodies[i].radius};
    const bool is_near =
        bodies[i].role == Role::kScenery && (ball.centre - all.centre).norm() + ball.radius <= kReach * all.radius;
    if (is_near || (nothing_moves && std::isfinite(ball.radius))) balls.push_back(ball);
  }
  if (balls.empty()) balls.push_back({state.poses.front().position, 1});  // Planes alone.
  return balls;
}

}  // namespace dgd_demos
