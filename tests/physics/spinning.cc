#include "physics/spinning.h"

#include <cmath>
#include <vector>

#include "physics/lab.h"
#include "physics/steady_disc.h"

namespace dgd_physics {
namespace {

/// A disc in a lab, and its motion.
struct DiscCase {
  double radius, half_thickness, margin;  // m; a margin of 0 stands for Bullet's own.
  double tilt;                            // Of the axis from the vertical, radians.
  double precession;                      // rad/s; 0 for the one that leaves the centre in place.
  Ground ground;
  int index;

  std::string Name() const {
    return "disc of " + Text(radius) + " m, tilt " + Text(tilt) + " on " + NameOf(ground) + ", margin " +
           (margin > 0 ? Text(margin) : std::string("default"));
  }
};

Disc PropertiesOf(const btRigidBody& body, const btCylinderShape& shape) {
  const btVector3 extents = shape.getHalfExtentsWithMargin();
  const btVector3& inverse_inertia = body.getInvInertiaDiagLocal();
  return {double(extents.x()),
          double(extents.z()),
          double(shape.getMargin()),
          1 / double(body.getInvMass()),
          1 / double(inverse_inertia.z()),
          1 / double(inverse_inertia.x())};
}

/// Kinetic, and potential above that of the disc lying flat.
double DiscEnergy(const btRigidBody& body, double half_thickness) {
  return KineticEnergyOf(body) + kGravity / double(body.getInvMass()) * (HeightOf(body) - half_thickness);
}

/// Share of its energy that the disc still has after a while.
Sample MeasureDisc(const Conditions& conditions, const DiscCase& it, double seconds) {
  Lab lab(conditions);
  lab.AddGround(it.ground);
  auto& shape = lab.Make<btCylinderShapeZ>(Vec(it.radius, it.radius, it.half_thickness));
  if (it.margin > 0) shape.setMargin(btScalar(it.margin));
  // Leaning towards x of a frame turned by the heading.
  const btQuaternion frame = Yaw(HeadingOf(it.index));
  const btQuaternion rotation = frame * btQuaternion(Vec(0, 1, 0), btScalar(it.tilt));
  btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0, 0, 0), rotation), {.friction = 1});
  const Disc disc = PropertiesOf(body, shape);
  const SteadyMotion motion =
      it.precession == 0 ? RollInPlace(disc, it.tilt) : RollInCircle(disc, it.tilt, it.precession);
  const btTransform pose = At(Vec(0.23, 0.31, motion.height), rotation);
  body.setWorldTransform(pose);
  body.setInterpolationWorldTransform(pose);
  body.updateInertiaTensor();
  body.setLinearVelocity(quatRotate(frame, Vec(0, motion.center_speed, 0)));
  body.setAngularVelocity(quatRotate(frame, Vec(motion.spin_x, 0, motion.spin_z)));
  const double before = DiscEnergy(body, it.half_thickness);
  lab.Run(seconds);
  return RelativeToTheory(it.Name(), DiscEnergy(body, it.half_thickness) / before, 1);
}

}  // namespace

Samples MeasureEulerDisc(const Conditions& conditions) {
  constexpr double kDuration = 5;  // s
  const std::vector<DiscCase> cases = {
      {0.4, 0.05, 0, 0.6, 0, Ground::kPlane, 0},    {0.4, 0.05, 0, 0.6, 0, Ground::kBox, 1},
      {0.2, 0.02, 0, 0.4, 0, Ground::kPlane, 2},    {0.2, 0.02, 0.001, 0.8, 0, Ground::kBox, 3},
      {0.8, 0.1, 0.001, 0.6, 0, Ground::kPlane, 1}, {0.8, 0.1, 0, 0.9, 0, Ground::kBox, 2}};
  Samples samples;
  for (const DiscCase& it : SelectCases(conditions, cases, 3)) {
    samples.push_back(MeasureDisc(conditions, it, kDuration));
  }
  return samples;
}

}  // namespace dgd_physics
