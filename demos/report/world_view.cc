#include "report/world_view.h"

#include <btBulletDynamicsCommon.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "render/shortest_turn.h"
#include "report/bullet_surface.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Role = DrawnBody::Role;

constexpr double kLeastFastest = 1;  // m/s, for what starts on the ground or has no gravity.

Matrix3d TurnUpwards(const Vector3d& gravity) {
  const double length = gravity.norm();
  if (!(length > 0)) return Matrix3d::Identity();
  const Vector3d up = -gravity / length;
  // Opposite directions have no shortest turn.
  if (up.z() <= -1) return Vector3d(1, -1, -1).asDiagonal();
  return ShortestTurn(up, Vector3d::UnitZ()).toRotationMatrix();
}

// @param pose  in the view.
bool IsLevelPlane(const btStaticPlaneShape& plane, const Pose& pose) {
  constexpr double kSteepest = 0.7;  // Cosine; on steeper ones the chequers would be stretched.
  return (pose.rotation * FromBullet(plane.getPlaneNormal())).z() > kSteepest;
}

// @param pose   in the view.
// @param width  least half extent along the horizontal axes, m.
bool IsLevelBox(const btBoxShape& box, const Pose& pose, double width) {
  constexpr double kLevel = 0.999;  // Cosine.
  const Vector3d half_extents = FromBullet(box.getHalfExtentsWithMargin());
  int up = 0;
  if (pose.rotation.row(2).cwiseAbs().maxCoeff(&up) < kLevel) return false;
  const double narrowest = std::min(half_extents[(up + 1) % 3], half_extents[(up + 2) % 3]);
  return narrowest >= width && narrowest >= half_extents[up];
}

Role RoleOfStatic(const btCollisionShape& shape, const Pose& pose, double width) {
  const int type = shape.getShapeType();
  const bool is_floor =
      (type == STATIC_PLANE_PROXYTYPE && IsLevelPlane(static_cast<const btStaticPlaneShape&>(shape), pose)) ||
      (type == BOX_SHAPE_PROXYTYPE && width > 0 && IsLevelBox(static_cast<const btBoxShape&>(shape), pose, width));
  return is_floor ? Role::kFloor : Role::kScenery;
}

// Whether a body counts for the frame; a plane does not, not even one with a mass.
bool IsFramed(const SimulatedBody& body) { return body.moves && std::isfinite(body.radius); }

// Radius of the ball that has all starts of bodies that move, m; 0 if none does.
double RadiusOfMoving(const std::vector<SimulatedBody>& bodies) {
  std::vector<Ball> balls;
  for (const SimulatedBody& body : bodies) {
    if (IsFramed(body)) balls.push_back({body.start, body.radius});
  }
  return BallAroundAll(balls).radius;
}

}  // namespace

WorldView ViewOf(const Scene& scene, const std::vector<Body>& bodies) {
  double highest = 0;
  for (const Body& body : bodies) highest = std::max(highest, body.pose.position.z());
  const double fastest = std::max(kLeastFastest, std::ceil(std::sqrt(2 * scene.gravity.norm() * highest)));
  return {DrawnBodiesOf(bodies), Matrix3d::Identity(), SpeedScale(fastest)};
}

WorldView ViewOf(SimulatedWorld& world) {
  const std::vector<SimulatedBody>& bodies = world.Bodies();
  const double width = RadiusOfMoving(bodies);
  const Eigen::AlignedBox3d room = world.Room();
  WorldView view{std::vector<DrawnBody>(bodies.size()), TurnUpwards(FromBullet(world.Bullet().getGravity()))};
  const btCollisionObjectArray& objects = world.Bullet().getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    const btCollisionShape& shape = *objects[i]->getCollisionShape();
    const Pose pose = FromBullet(objects[i]->getWorldTransform());
    const PlaneSquare square{pose.rotation.transpose() * (room.center() - pose.position), room.diagonal().norm()};
    const auto index = static_cast<std::size_t>(objects[i]->getUserIndex());
    const Pose in_view{view.world_to_view * pose.rotation, view.world_to_view * pose.position};
    SurfaceMesh surface = SurfaceOf(shape, square);
    // Bullet's own, of its bounding box, is half as large again.
    const double radius = std::isfinite(bodies[index].radius) ? BoundingRadius(surface) : bodies[index].radius;
    view.bodies[index] = {std::move(surface), radius,
                          IsFramed(bodies[index]) ? Role::kBody : RoleOfStatic(shape, in_view, width)};
  }
  return view;
}

Snapshot InView(const WorldView& view, Snapshot state) {
  for (Pose& pose : state.poses) pose = Pose{view.world_to_view, Vector3d::Zero()} * pose;
  return state;
}

SpeedScale ScaleFor(const WorldView& view, double fastest) {
  return view.scale.value_or(SpeedScale(std::max(kLeastFastest, std::ceil(fastest))));
}

}  // namespace dgd_demos
