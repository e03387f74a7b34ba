#include "physics/near_miss.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "physics/lab.h"

namespace dgd_physics {
namespace {

enum class Rod { kCapsule, kBox };

/// Along x.
btConvexShape& MakeRod(Lab& lab, Rod rod, double half_length, double radius) {
  if (rod == Rod::kBox) return lab.Make<btBoxShape>(Vec(half_length, radius, radius));
  return lab.Make<btCapsuleShapeX>(btScalar(radius), btScalar(2 * (half_length - radius)));
}

struct NearRod {
  Rod spinning, fixed;
  double half_length, radius;  // m
  double offset;               // Of the fixed rod's axis from that of the spin, m.
  double clearance;            // m
  double spin;                 // rad/s
  int index;
};

/// A rod spins in a plane above another, which lies beside the axis of the spin or across it: spin kept in four
/// seconds.
Sample MeasureNearRod(const Conditions& conditions, const NearRod& it) {
  constexpr double kDuration = 4;  // s
  Lab lab(conditions, 0);
  const double heading = HeadingOf(it.index);
  const double below = 2 * it.radius + it.clearance;
  const btVector3 aside = Direction(heading + kPi / 2) * btScalar(it.offset);
  lab.AddStatic(MakeRod(lab, it.fixed, 2 * it.half_length, it.radius), At(aside - Vec(0, 0, below), Yaw(heading)));
  btRigidBody& body =
      lab.AddBody(MakeRod(lab, it.spinning, it.half_length, it.radius), 1,
                  At(Vec(0, 0, 0), Yaw(heading + kPi / 2 + PhaseOf(it.index))), Surface{.friction = 0.5});
  body.setAngularVelocity(Vec(0, 0, it.spin));
  lab.Run(kDuration);
  return RelativeToTheory(std::string(it.spinning == Rod::kBox ? "box" : "capsule") + " rod over " +
                              (it.fixed == Rod::kBox ? "box" : "capsule") + " rod, " + Text(it.clearance) + " m clear",
                          double(body.getAngularVelocity().z()) / it.spin, 1);
}

struct Graze {
  Form form;
  double half;       // m
  double clearance;  // m
  double speed;      // m/s
  double spin;       // About the normal of the faces that pass each other, rad/s.
  bool is_free;      // Whether the body that is passed is a free one.
  int index;
};

std::vector<Graze> GrazeCases() {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder};
  constexpr std::array<double, 4> kClearances = {0.001, 0.015, 0.004, 0.008};
  constexpr std::array<double, 5> kSpeeds = {1, 10, 3, 0.5, 30};
  constexpr std::array<double, 3> kSpins = {0, 3, 10};
  constexpr std::array<double, 3> kHalves = {0.25, 0.1, 0.5};
  std::vector<Graze> cases;
  for (int i = 0; i < 72; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kForms[j % 3], kHalves[(j + j / 3) % 3], kClearances[j % 4], kSpeeds[j % 5],
                     kSpins[(j + j / 6) % 3], i % 2 == 1, i});
  }
  return cases;
}

/// A body flies past another, face along face.
Sample MeasureGraze(const Conditions& conditions, const Graze& it) {
  Lab lab(conditions, 0);
  const btQuaternion turn(Vec(0.6, 0.48, 0.64), btScalar(0.5 * (it.index % 4)));
  const btTransform frame = At(Vec(0, 0, 0), turn);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  btConvexShape& other = lab.Make<btBoxShape>(Vec(2 * it.half, it.half, it.half));
  const btTransform other_pose = frame * At(Vec(0, 0, -it.half), Yaw(HeadingOf(it.index) + 0.3));
  btRigidBody& passed = it.is_free ? lab.AddBody(other, 1, other_pose) : lab.AddStatic(other, other_pose);
  const double distance = 4 * it.half + it.speed * lab.dt() * PhaseOf(it.index);
  const btVector3 direction = Direction(HeadingOf(it.index));
  const btVector3 start = direction * btScalar(-distance) + Vec(0, 0, FootOf(shape) + it.clearance);
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(start), Surface{.friction = 0.5});
  const btVector3 velocity = quatRotate(turn, direction * btScalar(it.speed));
  const btVector3 spin = quatRotate(turn, Vec(0, 0, it.spin));
  body.setLinearVelocity(velocity);
  body.setAngularVelocity(spin);
  lab.Run(2 * distance / it.speed);
  const double passed_speed = double(passed.getLinearVelocity().length()) / it.speed;
  return {NameOf(it.form) + " " + Text(it.half) + " m, " + Text(it.clearance) + " m clear, " + Text(it.speed) +
              " m/s, " + Text(it.spin) + " rad/s" + (it.is_free ? ", past a free box" : ""),
          std::hypot(DisturbanceOf(body, velocity, spin, it.half) / it.speed, passed_speed), 0, 1, "flying bodies"};
}

struct PassingSlab {
  Form form;         // Of the body at rest.
  double half;       // m
  double clearance;  // m
  double speed;      // m/s
  int index;
};

std::vector<PassingSlab> PassingSlabCases() {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kSphere, Form::kCylinder};
  constexpr std::array<double, 3> kClearances = {0.003, 0.001, 0.008};
  constexpr std::array<double, 5> kSpeeds = {1, 4, 0.6, 8, 2.5};
  constexpr std::array<double, 3> kHalves = {0.15, 0.3, 0.08};
  std::vector<PassingSlab> cases;
  for (int i = 0; i < 36; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kForms[j % 4], kHalves[j / 2 % 3], kClearances[(j + j / 3) % 3], kSpeeds[j % 5], i});
  }
  return cases;
}

/// A slab that the app moves passes straight over a free body at rest, face along face.
Sample MeasurePassingSlab(const Conditions& conditions, const PassingSlab& it) {
  Lab lab(conditions, 0);
  const btQuaternion turn(Vec(0.48, 0.64, 0.6), btScalar(0.6 * (it.index % 4)));
  const btTransform frame = At(Vec(0, 0, 0), turn);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(Vec(0, 0, 0), Yaw(0.9 * it.index)), Surface{.friction = 0.5});
  const btVector3 half_slab = Vec(2, 4, 1.5) * btScalar(it.half);
  const double height = ExtentOf(shape, Vec(0, 0, 1)) + it.clearance + double(half_slab.z());
  const double distance = 7 * it.half + it.speed * lab.dt() * PhaseOf(it.index);
  const double heading = HeadingOf(it.index);
  const auto pose_at = [&](double time) {
    // Its front across its way, or not quite.
    return frame * At(Direction(heading) * btScalar(it.speed * time - distance) + Vec(0, 0, height),
                      Yaw(heading + 0.2 * (it.index % 3)));
  };
  btRigidBody& slab = lab.AddKinematic(lab.Make<btBoxShape>(half_slab), pose_at(0), Surface{.friction = 0.5});
  lab.RunMoving(slab, 2 * distance / it.speed, pose_at);
  return {NameOf(it.form) + " " + Text(it.half) + " m, " + Text(it.clearance) + " m below a slab at " + Text(it.speed) +
              " m/s",
          DisturbanceOf(body, Vec(0, 0, 0), Vec(0, 0, 0), it.half) / it.speed, 0, 1, "moved slabs"};
}

struct Tumble {
  Form form;
  Ground ground;
  double half;         // m
  double clearance;    // m
  double spin;         // rad/s
  double restitution;  // Of both bodies together.
  double drift;        // Along the ground, m/s.
  int index;
};

std::vector<Tumble> TumbleCases() {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder, Form::kCapsule};
  constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane, Ground::kMesh};
  constexpr std::array<double, 4> kClearances = {0.003, 0.001, 0.01, 0.005};
  constexpr std::array<double, 5> kSpins = {8, 15, 4, 22, 10};
  constexpr std::array<double, 3> kHalves = {0.25, 0.12, 0.4};
  std::vector<Tumble> cases;
  for (int i = 0; i < 72; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kForms[j % 4], kGrounds[(j + j / 12) % 3], kHalves[j / 4 % 3], kClearances[(j + j / 4) % 4],
                     kSpins[j % 5], i / 2 % 2 == 0 ? 0 : 0.8, i % 5 == 4 ? 0.4 : 0, i});
  }
  return cases;
}

/// Radius of the circle about x that a shape just turns within.
double TumblingRadius(const btConvexShape& shape) {
  constexpr int kDirections = 3600;
  double radius = 0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * kPi * i / kDirections;
    radius = std::max(radius, ExtentOf(shape, Vec(0, std::cos(angle), std::sin(angle))));
  }
  return radius;
}

/// A body turns about an axis of its own, which is level, over ground that its corners come near to and never touch.
Sample MeasureTumble(const Conditions& conditions, const Tumble& it) {
  constexpr double kDuration = 1;  // s
  Lab lab(conditions, 0);
  lab.AddGround(it.ground, btTransform::getIdentity(), {}, Surface{.friction = 1, .restitution = it.restitution});
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double radius = TumblingRadius(shape), heading = HeadingOf(it.index);
  const btQuaternion start = Yaw(heading) * btQuaternion(Vec(1, 0, 0), btScalar(2 * PhaseOf(it.index)));
  btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0.13, 0.21, radius + it.clearance), start),
                                  Surface{.friction = 0.5, .restitution = 1});
  const btVector3 spin = Direction(heading) * btScalar(it.spin), drift = Direction(heading + 1) * btScalar(it.drift);
  body.setLinearVelocity(drift);
  body.setAngularVelocity(spin);
  lab.Run(kDuration);
  const std::string name = NameOf(it.form) + " " + Text(it.half) + " m over " + NameOf(it.ground) + ", " +
                           Text(it.clearance) + " m clear, " + Text(it.spin) + " rad/s, drift " + Text(it.drift) +
                           ", e " + Text(it.restitution);
  return {name, DisturbanceOf(body, drift, spin, radius) / (radius * it.spin), 0, 1, NameOf(it.ground)};
}

struct PastEdge {
  Form form;
  double half;       // m
  double clearance;  // m
  double speed;      // m/s
  double slope;      // Of the way, below the horizontal, radians.
  Ground obstacle;   // A box, or a mesh that ends.
  int index;
};

std::vector<PastEdge> PastEdgeCases() {
  constexpr std::array kForms = {Form::kBox, Form::kSphere, Form::kHull, Form::kCapsule, Form::kCylinder};
  constexpr std::array<double, 4> kClearances = {0.002, 0.03, 0.005, 0.012};
  constexpr std::array<double, 5> kSpeeds = {5, 100, 1, 20, 50};
  constexpr std::array<double, 3> kSlopes = {0.7, 0.3, 1.1};
  constexpr std::array<double, 3> kHalves = {0.1, 0.25, 0.05};
  std::vector<PastEdge> cases;
  for (int i = 0; i < 180; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kForms[j % 5], kHalves[(j + j / 3) % 3], kClearances[j % 4], kSpeeds[(j + j / 5) % 5],
                     kSlopes[(j + j / 6) % 3], i % 4 == 3 ? Ground::kMesh : Ground::kBox, i});
  }
  return cases;
}

/// A body flies down past the edge of ground. The plane through the edge and along the way parts it from the ground:
/// all of the ground lies below, and all of the body above by the clearance.
Sample MeasurePastEdge(const Conditions& conditions, const PastEdge& it) {
  constexpr double kRange = 0.6;  // m
  Lab lab(conditions, 0);
  constexpr double kMargin = 1e-3;  // m: its edge is nearly sharp, and the clearance not much larger than it says.
  const Grid grid = {.cells = 4, .pitch = 0.5};
  const btTransform frame = At(Vec(0, 0, 0), Yaw(HeadingOf(it.index)));
  ShapeOf(lab.AddGround(it.obstacle, frame * At(Vec(-0.5 * grid.cells * grid.pitch, 0.13, 0)), grid))
      .setMargin(btScalar(it.obstacle == Ground::kMesh ? 0 : kMargin));
  const btVector3 along = quatRotate(frame.getRotation(), Vec(std::cos(it.slope), 0, -std::sin(it.slope)));
  const btVector3 normal = quatRotate(frame.getRotation(), Vec(std::sin(it.slope), 0, std::cos(it.slope)));
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  // Any orientation, a corner, an edge or a face ahead.
  const btQuaternion rotation(Vec(0.48, 0.6, 0.64), btScalar(1.3 * (it.index % 5)));
  const double reach = ExtentOf(shape, quatRotate(rotation.inverse(), -normal));
  const double start = kRange + it.speed * lab.dt() * (1 + PhaseOf(it.index));
  btRigidBody& body =
      lab.AddBody(shape, 1, At(normal * btScalar(reach + it.clearance) - along * btScalar(start), rotation));
  const btVector3 velocity = along * btScalar(it.speed);
  body.setLinearVelocity(velocity);
  lab.Run((start + kRange) / it.speed);
  return {NameOf(it.form) + " " + Text(it.half) + " m past " + NameOf(it.obstacle) + ", " + Text(it.clearance) +
              " m clear, " + Text(it.speed) + " m/s, slope " + Text(it.slope),
          DisturbanceOf(body, velocity, Vec(0, 0, 0), it.half) / it.speed,
          0,
          1,
          {}};
}

}  // namespace

Samples MeasureGraze(const Conditions& conditions) {
  Samples samples = MeasureCases(conditions, GrazeCases(), 7,
                                 [](const Conditions& under, const Graze& it) { return MeasureGraze(under, it); });
  AddTo(samples, MeasureCases(conditions, PassingSlabCases(), 7, [](const Conditions& under, const PassingSlab& it) {
          return MeasurePassingSlab(under, it);
        }));
  return samples;
}

Samples MeasureTumble(const Conditions& conditions) {
  return MeasureCases(conditions, TumbleCases(), 11,
                      [](const Conditions& under, const Tumble& it) { return MeasureTumble(under, it); });
}

Samples MeasurePastEdge(const Conditions& conditions) {
  return MeasureCases(conditions, PastEdgeCases(), 11,
                      [](const Conditions& under, const PastEdge& it) { return MeasurePastEdge(under, it); });
}

Samples MeasureNearRod(const Conditions& conditions) {
  const std::vector<NearRod> cases = {{Rod::kCapsule, Rod::kCapsule, 0.5, 0.05, 0, 5e-4, 3, 0},
                                      {Rod::kBox, Rod::kBox, 0.5, 0.05, 0, 5e-4, 3, 1},
                                      {Rod::kCapsule, Rod::kBox, 0.5, 0.05, 0.3, 5e-4, 3, 2},
                                      {Rod::kBox, Rod::kCapsule, 0.5, 0.05, 0.2, 5e-4, 3, 3},
                                      {Rod::kBox, Rod::kBox, 1, 0.1, 0.5, 5e-4, 5, 2},
                                      {Rod::kCapsule, Rod::kCapsule, 1, 0.1, 0.6, 5e-4, 2, 1},
                                      {Rod::kBox, Rod::kBox, 0.2, 0.02, 0.1, 5e-4, 3, 3},
                                      {Rod::kCapsule, Rod::kCapsule, 0.2, 0.01, 0.05, 2e-3, 6, 0},
                                      {Rod::kBox, Rod::kBox, 0.5, 0.05, 0.4, 5e-4, 3, 0},
                                      {Rod::kCapsule, Rod::kBox, 0.5, 0.05, 0, 5e-4, 3, 1},
                                      {Rod::kBox, Rod::kCapsule, 1, 0.05, 0.7, 5e-4, 3, 2},
                                      {Rod::kCapsule, Rod::kCapsule, 0.5, 0.02, 0.3, 5e-4, 3, 3},
                                      {Rod::kBox, Rod::kBox, 1, 0.05, 0, 1e-3, 8, 1},
                                      {Rod::kBox, Rod::kBox, 0.3, 0.05, 0.2, 2e-4, 3, 2}};
  return MeasureCases(conditions, cases, 4,
                      [](const Conditions& under, const NearRod& it) { return MeasureNearRod(under, it); });
}

}  // namespace dgd_physics
