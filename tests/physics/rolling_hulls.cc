// A hull that rolls goes over from corner to corner, and loses speed at each: Housner's impact (The behavior of
// inverted pendulum structures during earthquakes, 1963), or that of the rimless wheel (McGeer, Passive dynamic
// walking, 1990, eq. 4). Between two corners it loses nothing. The way is integrated from impact to impact
// (rolling_solid.h).
#include "physics/rolling_hulls.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "physics/lab.h"
#include "physics/rolling_solid.h"

namespace dgd_physics {
namespace {

using Eigen::Vector3d;

constexpr double kFriction = 0.8;  // Of both together.

Vector3d ToEigen(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }
btVector3 ToBullet(const Vector3d& v) { return Vec(v.x(), v.y(), v.z()); }
btQuaternion ToBullet(const Eigen::Quaterniond& q) {
  return {btScalar(q.x()), btScalar(q.y()), btScalar(q.z()), btScalar(q.w())};
}

/// Of a box, which is sharp, or of a hull.
Solid SolidOf(btRigidBody& body) {
  Solid solid;
  solid.inertia = ToEigen(body.getInvInertiaDiagLocal()).cwiseInverse() * double(body.getInvMass());
  const auto& shape = static_cast<const btPolyhedralConvexShape&>(ShapeOf(body));
  for (int i = 0; i < shape.getNumVertices(); ++i) {
    btVector3 corner;
    shape.getVertex(i, corner);
    solid.corners.push_back(ToEigen(corner));
  }
  if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE) solid.margin = double(shape.getMargin());
  return solid;
}

/// Ground that falls along x, and a body on it; motions are in the ground's frame.
class Ramp {
 public:
  Ramp(const Conditions& conditions, Ground ground, double slope, double heading)
      : lab_(conditions), frame_(At(Vec(0, 0, 0), Yaw(heading) * btQuaternion(Vec(0, 1, 0), btScalar(slope)))) {
    lab_.AddGround(ground, frame_, {.cells = 60}, Surface{.friction = 1});
    gravity_ = ToEigen(Vec(0, 0, -kGravity) * frame_.getBasis());
  }
  Lab& lab() { return lab_; }

  void Put(btConvexShape& shape) { body_ = &lab_.AddBody(shape, 1, frame_, Surface{.friction = kFriction}); }
  Solid solid() const { return SolidOf(*body_); }

  /// Ways along x: of the body, and in theory.
  std::pair<double, double> Run(const SolidMotion& start, double seconds) {
    const btTransform pose = frame_ * At(ToBullet(start.position), ToBullet(start.rotation));
    body_->setCenterOfMassTransform(pose);
    body_->setInterpolationWorldTransform(pose);
    body_->updateInertiaTensor();
    body_->setLinearVelocity(frame_.getBasis() * ToBullet(start.velocity));
    body_->setAngularVelocity(frame_.getBasis() * ToBullet(start.spin));
    lab_.Run(seconds);
    const SolidMotion end = Integrate(solid(), start, gravity_, kFriction, lab_.StepsIn(seconds) * lab_.dt());
    return {double((frame_.inverse() * PositionOf(*body_)).x()) - start.position.x(),
            end.position.x() - start.position.x()};
  }

 private:
  Lab lab_;
  btTransform frame_;
  Vector3d gravity_;
  btRigidBody* body_ = nullptr;
};

struct Wheel {
  int sides;
  double radius, width;  // m
  double speed;          // m/s
  double margin;         // m
  double slope;          // rad
  Ground ground;
  int index;
};

std::vector<Wheel> WheelCases() {
  constexpr std::array kSides = {32, 16, 64, 8, 24, 48};
  constexpr std::array<double, 3> kRadii = {0.3, 0.1, 0.03};  // m
  constexpr std::array<double, 3> kWidths = {0.6, 0.2, 2};    // Over the radius.
  constexpr std::array<double, 3> kSpeeds = {0.3, 0.6, 0.9};  // Over sqrt(g r), at which wheels leave the ground.
  std::vector<Wheel> cases;
  for (int i = 0; i < 24; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    const int sides = kSides[j % 6];
    // On the level a wheel of 8 sides stops on its second or third.
    const double radius = kRadii[(j + j / 6) % 3], slope = i % 4 == 3 || sides == 8 ? 0.6 * kPi / sides : 0;
    const double speed = slope > 0 ? 0.3 : kSpeeds[(j + j / 3) % 3];
    cases.push_back({sides, radius, kWidths[j / 2 % 3] * radius, speed * std::sqrt(kGravity * radius),
                     i % 2 == 0 ? 0.001 : 0.1 * radius, slope, i / 2 % 2 == 0 ? Ground::kPlane : Ground::kBox, i});
  }
  return cases;
}

Sample MeasureWheel(const Conditions& conditions, const Wheel& it) {
  Ramp ramp(conditions, it.ground, it.slope, HeadingOf(it.index));
  ramp.Put(ramp.lab().MakePrism(it.sides, it.radius - it.margin, it.width / 2 - it.margin, it.margin));
  // On a corner, its axis across the slope; then up to half a side farther.
  const double turn = kPi / 2 + kPi / it.sides * (1 + 0.9 * PhaseOf(it.index));
  const Eigen::Quaterniond rotation =
      Eigen::AngleAxisd(turn, Vector3d::UnitY()) * Eigen::Quaterniond(Eigen::AngleAxisd(-kPi / 2, Vector3d::UnitX()));
  const SolidMotion start = RollOnLowestCorner(ramp.solid(), rotation, Vector3d::UnitX(), it.speed);
  const auto [way, theory] = ramp.Run(start, 3 * std::sqrt(it.radius / 0.3));
  return RelativeToTheory("wheel of " + Text(it.sides) + " sides, " + Text(it.radius) + " m on " + NameOf(it.ground) +
                              (it.slope > 0 ? ", slope " + Text(it.slope) : "") + ", margin " + Text(it.margin) + ", " +
                              Text(it.speed) + " m/s: way, m",
                          way, theory, it.slope > 0 ? "ramps" : "wheels");
}

/// Points spread evenly over a sphere.
btConvexHullShape& MakeBall(Lab& lab, int points, double radius, double margin) {
  const double golden_angle = kPi * (3 - std::sqrt(5.0));
  auto& hull = lab.Make<btConvexHullShape>();
  for (int i = 0; i < points; ++i) {
    const double z = 1 - (2 * i + 1.0) / points, ring = std::sqrt(1 - z * z), angle = golden_angle * i;
    hull.addPoint(Vec(ring * std::cos(angle), ring * std::sin(angle), z) * btScalar(radius - margin), false);
  }
  hull.recalcLocalAabb();
  hull.setMargin(btScalar(margin));
  return hull;
}

/// Any orientation, another for each.
Eigen::Quaterniond OrientationOf(int index) {
  const Vector3d axis(PhaseOf(3 * index) - 0.5, PhaseOf(3 * index + 1) - 0.5, PhaseOf(3 * index + 2) - 0.5);
  return Eigen::Quaterniond(Eigen::AngleAxisd(2 * kPi * PhaseOf(7 * index), axis.normalized()));
}

struct Ball {
  int points;
  double radius, speed;  // m, m/s
  double margin;         // m
  double slope;          // rad
  Ground ground;
  int index;
};

std::vector<Ball> BallCases() {
  constexpr std::array kPoints = {92, 162, 42};
  constexpr std::array<double, 2> kRadii = {0.2, 0.05};       // m
  constexpr std::array<double, 3> kSpeeds = {0.6, 0.4, 0.9};  // Over sqrt(g r).
  std::vector<Ball> cases;
  for (int i = 0; i < 12; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    const double radius = kRadii[j / 3 % 2], slope = i % 4 == 3 ? 0.05 : 0;
    cases.push_back({kPoints[j % 3], radius, kSpeeds[(j + j / 3) % 3] * std::sqrt(kGravity * radius),
                     i % 2 == 0 ? 0.001 : 0.1 * radius, slope, i / 2 % 2 == 0 ? Ground::kBox : Ground::kPlane, i});
  }
  return cases;
}

/// Which way it falls off a corner is a matter of chance: the mean way of some that start differently.
Sample MeasureBall(const Conditions& conditions, const Ball& it) {
  const int count = conditions.is_quick ? 1 : 3;
  double way = 0, theory = 0;
  for (int i = 0; i < count; ++i) {
    Ramp ramp(conditions, it.ground, it.slope, HeadingOf(it.index));
    ramp.Put(MakeBall(ramp.lab(), it.points, it.radius, it.margin));
    const SolidMotion start =
        RollOnLowestCorner(ramp.solid(), OrientationOf(it.index + 12 * i), Vector3d::UnitX(), it.speed);
    const auto [one_way, one_theory] = ramp.Run(start, 2 * std::sqrt(it.radius / 0.2));
    way += one_way / count;
    theory += one_theory / count;
  }
  return RelativeToTheory("ball of " + Text(it.points) + " points, " + Text(it.radius) + " m on " + NameOf(it.ground) +
                              (it.slope > 0 ? ", slope " + Text(it.slope) : "") + ", margin " + Text(it.margin) + ", " +
                              Text(it.speed) + " m/s: way, m",
                          way, theory, "balls");
}

/// Dice that are thrown along the ground, of one size: their mean way.
Sample MeasureThrows(const Conditions& conditions, bool is_hull, double half, double speed, Ground ground, int index) {
  const int count = conditions.is_quick ? 8 : 24;
  double way = 0, theory = 0;
  for (int i = 0; i < count; ++i) {
    Ramp ramp(conditions, ground, 0, HeadingOf(index));
    ramp.Put(is_hull ? static_cast<btConvexShape&>(ramp.lab().MakePrism(4, 1.4 * half, half, 0.02 * half))
                     : ramp.lab().Make<btBoxShape>(Vec(half, half, half)));
    SolidMotion start{Vector3d(0, 0, half * (2 + 2 * PhaseOf(i))), OrientationOf(i + 100 * index)};
    start.velocity = Vector3d(speed * (0.8 + 0.4 * PhaseOf(5 * i + 2)), 0.1 * speed * (PhaseOf(i + 1) - 0.5), 0);
    start.spin = speed / half * Vector3d(PhaseOf(3 * i) - 0.5, 2 * PhaseOf(2 * i) - 0.5, PhaseOf(4 * i) - 0.5);
    const auto [one_way, one_theory] = ramp.Run(start, 2 * std::sqrt(half / 0.05) + speed / 4);
    way += one_way / count;
    theory += one_theory / count;
  }
  return RelativeToTheory(Text(count) + (is_hull ? " hulls of " : " dice of ") + Text(half) + " m on " +
                              NameOf(ground) + ", " + Text(speed) + " m/s: mean way, m",
                          way, theory, "dice");
}

}  // namespace

Samples MeasureRollingHulls(const Conditions& conditions) {
  Samples samples = MeasureCases(conditions, WheelCases(), 7,
                                 [](const Conditions& under, const Wheel& it) { return MeasureWheel(under, it); });
  AddTo(samples, MeasureCases(conditions, BallCases(), 7,
                              [](const Conditions& under, const Ball& it) { return MeasureBall(under, it); }));
  constexpr std::array<double, 3> kSpeeds = {2, 4, 3};          // m/s
  constexpr std::array<double, 3> kHalves = {0.05, 0.1, 0.02};  // m
  for (const int i : SelectIndices(conditions, 6, 4)) {
    const std::size_t j = static_cast<std::size_t>(i);
    samples.push_back(MeasureThrows(conditions, i % 2 == 1, kHalves[j % 3], kSpeeds[(j + j / 3) % 3],
                                    i / 2 % 2 == 0 ? Ground::kBox : Ground::kPlane, i));
  }
  return samples;
}

}  // namespace dgd_physics
