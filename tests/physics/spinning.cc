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
  btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0, 0, 0), rotation), Surface{.friction = 1});
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

/// A ball, or a cylinder that lies across its way: kinetic energy kept.
Sample MeasureRolling(const Conditions& conditions, bool is_ball, Ground ground, double radius, double speed, int index,
                      const std::string& group) {
  constexpr double kDuration = 4;  // s
  Lab lab(conditions);
  lab.AddGround(ground, btTransform::getIdentity(), {.cells = 40, .pitch = 0.7});
  btConvexShape& shape = is_ball ? static_cast<btConvexShape&>(lab.Make<btSphereShape>(btScalar(radius)))
                                 : lab.Make<btCylinderShape>(Vec(radius, 0.8 * radius, radius));
  const double heading = HeadingOf(index);
  const btVector3 start = Direction(heading) * btScalar(-0.5 * speed * kDuration) + Vec(0.23, 0.31, radius);
  btRigidBody& body = lab.AddBody(shape, 1, At(start, Yaw(heading)), Surface{.friction = 0.5});
  SetRolling(body, radius, speed, heading);
  const double before = KineticEnergyOf(body);
  lab.Run(kDuration);
  return RelativeToTheory(std::string(is_ball ? "ball" : "cylinder") + " of " + Text(radius) + " m on " +
                              NameOf(ground) + ", " + Text(speed) + " m/s, heading " + Text(heading),
                          KineticEnergyOf(body) / before, 1, group);
}

}  // namespace

Samples MeasureDiscCircle(const Conditions& conditions) {
  constexpr double kDuration = 3;  // s
  const std::vector<DiscCase> cases = {
      {0.4, 0.05, 0, 1.3, 1.5, Ground::kPlane, 0},     {0.4, 0.05, 0, 1.3, 1.5, Ground::kBox, 1},
      {0.2, 0.02, 0, 1.2, 3, Ground::kPlane, 2},       {0.2, 0.02, 0.001, 1.1, 4, Ground::kBox, 3},
      {0.8, 0.1, 0.001, 1.25, 1.2, Ground::kPlane, 1}, {0.8, 0.1, 0, 1.35, 0.8, Ground::kBox, 2},
      {0.4, 0.03, 0.001, 1.2, 2, Ground::kPlane, 3},   {0.4, 0.03, 0.001, 1.4, 1, Ground::kBox, 0},
      {0.3, 0.06, 0, 1.15, 2, Ground::kPlane, 1},      {0.5, 0.05, 0, 1.3, 1.2, Ground::kBox, 2}};
  return MeasureCases(conditions, cases, 3,
                      [](const Conditions& under, const DiscCase& it) { return MeasureDisc(under, it, kDuration); });
}

Samples MeasureRolling(const Conditions& conditions) {
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh, Ground::kHeightfield};
  constexpr std::array<double, 3> kRadii = {0.25, 0.1, 0.5};  // m
  constexpr std::array<double, 3> kSpeeds = {1, 3, 0.5};      // m/s
  // Within a step they go as far as bodies at rest may creep.
  constexpr std::array<double, 4> kSlowSpeeds = {0.004, 0.012, 0.001, 0.002};  // m/s
  constexpr std::array<double, 3> kLargeRadii = {0.5, 0.25, 1};                // m
  Samples samples;
  for (const int i : SelectIndices(conditions, 48, 7)) {
    const std::size_t j = static_cast<std::size_t>(i);
    samples.push_back(MeasureRolling(conditions, i % 2 == 0, kGrounds[j / 2 % 4], kRadii[(j + j / 6) % 3],
                                     kSpeeds[(j + j / 3) % 3], i, i % 2 == 0 ? "balls" : "cylinders"));
  }
  for (const int i : SelectIndices(conditions, 24, 7)) {
    const std::size_t j = static_cast<std::size_t>(i);
    samples.push_back(MeasureRolling(conditions, i % 2 == 0, kGrounds[j / 2 % 4], kLargeRadii[(j + j / 6) % 3],
                                     kSlowSpeeds[(j / 2 + j / 8) % 4], i,
                                     i % 2 == 0 ? "slow balls" : "slow cylinders"));
  }
  return samples;
}

Samples MeasureEulerDisc(const Conditions& conditions) {
  constexpr double kDuration = 5;  // s
  const std::vector<DiscCase> cases = {
      {0.4, 0.05, 0, 0.6, 0, Ground::kPlane, 0},     {0.4, 0.05, 0, 0.6, 0, Ground::kBox, 1},
      {0.2, 0.02, 0, 0.4, 0, Ground::kPlane, 2},     {0.2, 0.02, 0.001, 0.8, 0, Ground::kBox, 3},
      {0.8, 0.1, 0.001, 0.6, 0, Ground::kPlane, 1},  {0.8, 0.1, 0, 0.9, 0, Ground::kBox, 2},
      {0.4, 0.03, 0.001, 0.7, 0, Ground::kPlane, 3}, {0.4, 0.03, 0.001, 0.5, 0, Ground::kBox, 0},
      {0.3, 0.06, 0, 0.8, 0, Ground::kPlane, 1},     {0.5, 0.05, 0, 1, 0, Ground::kBox, 2}};
  return MeasureCases(conditions, cases, 3,
                      [](const Conditions& under, const DiscCase& it) { return MeasureDisc(under, it, kDuration); });
}

}  // namespace dgd_physics
