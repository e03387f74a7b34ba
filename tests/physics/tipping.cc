#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "physics/edges.h"
#include "physics/lab.h"

namespace dgd_physics {
namespace {

constexpr double kSettleTime = 0.5;  // s

/// A box that stands on ground and does not slide; it is turned so that it tips over the edge towards the heading.
struct Standing {
  double half_width, half_height;  // m
  double mass;                     // kg
  Ground ground;
  int index;

  double Heading() const { return HeadingOf(index); }
  std::string Group() const { return ground == Ground::kMesh ? "on meshes" : "on boxes and planes"; }
  std::string Name() const {
    return "box " + Text(2 * half_width) + " x " + Text(2 * half_height) + " m on " + NameOf(ground);
  }
  /// About the edge, kg m^2.
  double EdgeInertia() const { return mass * 4 / 3 * (half_width * half_width + half_height * half_height); }
};

std::vector<Standing> StandingCases() {
  constexpr std::array<std::array<double, 2>, 4> kHalves = {{{0.1, 0.3}, {0.25, 0.3}, {0.2, 0.8}, {0.5, 0.75}}};
  constexpr std::array<double, 3> kMasses = {1, 30, 0.3};
  std::vector<Standing> cases;
  for (const Ground ground : {Ground::kPlane, Ground::kBox, Ground::kMesh}) {
    for (const auto& [half_width, half_height] : kHalves) {
      const std::size_t i = cases.size();
      cases.push_back({half_width, half_height, kMasses[i % 3], ground, static_cast<int>(i + i / 4)});
    }
  }
  return cases;
}

constexpr Surface kRough = {.friction = 2, .restitution = 0};

btRigidBody& AddStanding(Lab& lab, const Standing& it) {
  auto& shape = lab.Make<btBoxShape>(Vec(it.half_width, 0.8 * it.half_width, it.half_height));
  return lab.AddBody(shape, it.mass, At(Vec(0.23, 0.31, it.half_height), Yaw(it.Heading())), kRough);
}

/// A load that grows from 0 to `most` within kRampTime; how much of it there is when the box has turned by
/// kTippedAngle.
constexpr double kRampTime = 4;         // s
constexpr double kTippedAngle = 0.005;  // rad

/// The same for a rigid box that turns about a fixed edge, from rest, as soon as the moment is positive.
/// @param moment  double(double load, double angle): about the edge, N m.
double TippingLoad(double inertia, double most, const std::function<double(double, double)>& moment) {
  constexpr double kStep = 1e-5;  // s
  double angle = 0, velocity = 0, load = 0;
  for (double time = 0; angle < kTippedAngle && load < most; time += kStep) {
    load = most * time / kRampTime;
    velocity = std::max(0.0, velocity + moment(load, angle) / inertia * kStep);
    angle += velocity * kStep;
  }
  return load;
}

/// @param apply  Puts a load on the box or its world for the next step.
double MeasureTippingLoad(Lab& lab, const btRigidBody& body, double most, const std::function<void(double)>& apply) {
  lab.Run(kSettleTime);
  const int steps = lab.StepsIn(kRampTime);
  for (int step = 0; step < steps; ++step) {
    apply(most * (step + 0.5) / steps);
    lab.Step();
    if (TiltOf(body) >= kTippedAngle) return most * (step + 1) / steps;
  }
  return most;
}

/// A horizontal force at some height tips a box at m g b / (2 h), for its width b.
Sample MeasureForceTip(const Conditions& conditions, const Standing& it) {
  const double height = it.half_height * (1.3 + 0.6 * PhaseOf(it.index));
  const double weight = it.mass * kGravity, threshold = weight * it.half_width / height;
  const double most = 1.3 * threshold;
  const double theory = TippingLoad(it.EdgeInertia(), most, [&](double force, double angle) {
    return force * height - weight * (it.half_width - it.half_height * angle);
  });
  Lab lab(conditions);
  lab.AddGround(it.ground);
  btRigidBody& body = AddStanding(lab, it);
  const double measured = MeasureTippingLoad(lab, body, most, [&](double force) {
    body.applyForce(Direction(it.Heading()) * btScalar(force), Vec(0, 0, height - it.half_height));
  });
  return RelativeToTheory(it.Name() + ", pushed at " + Text(height) + " m: N", measured, theory, it.Group());
}

/// A slope that gets steeper tips a box when its tangent is width over height. The slope is gravity's.
Sample MeasureSlopeTip(const Conditions& conditions, const Standing& it) {
  const double weight = it.mass * kGravity, most = 1.3 * std::atan(it.half_width / it.half_height);
  const double theory = TippingLoad(it.EdgeInertia(), most, [&](double slope, double angle) {
    return weight * (std::sin(slope + angle) * it.half_height - std::cos(slope + angle) * it.half_width);
  });
  Lab lab(conditions);
  lab.AddGround(it.ground);
  btRigidBody& body = AddStanding(lab, it);
  const double measured = MeasureTippingLoad(lab, body, most, [&](double slope) {
    body.setGravity(Direction(it.Heading()) * btScalar(kGravity * std::sin(slope)) -
                    Vec(0, 0, kGravity * std::cos(slope)));
  });
  return RelativeToTheory(it.Name() + ", on a slope: rad", measured, theory, it.Group());
}

/// Whether a box on a ledge falls whose centre is so far outside of the edge.
bool FallsFromLedge(const Conditions& conditions, const Standing& it, double outside) {
  constexpr double kDuration = 3;   // s
  constexpr double kFallen = 0.02;  // m
  const Grid grid = {.cells = 8, .pitch = 0.5};
  const double edge = 0.5 * grid.cells * grid.pitch;
  Lab lab(conditions);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(it.Heading()));
  lab.AddGround(it.ground, frame, grid);
  auto& shape = lab.Make<btBoxShape>(Vec(it.half_width, 0.8 * it.half_width, it.half_height));
  btRigidBody& body = lab.AddBody(shape, it.mass, frame * At(Vec(edge + outside, 0.13, it.half_height)), kRough);
  lab.Run(kDuration);
  return HeightOf(body) < it.half_height - kFallen;
}

/// Share of boxes that fall though their centre is over the ledge, or stay though it is not.
Sample MeasureLedge(const Conditions& conditions, const Standing& it) {
  const std::vector<double> all = {0.005, 0.01, 0.02, 0.04};  // m
  const std::vector<double> offsets = SelectCases(conditions, all, 2);
  int wrong = 0;
  for (const double offset : offsets) {
    if (FallsFromLedge(conditions, it, -offset)) ++wrong;
    if (!FallsFromLedge(conditions, it, offset)) ++wrong;
  }
  return {it.Name() + ", over its edge: wrong falls", wrong / (2.0 * double(offsets.size())), 0, 1, it.Group()};
}

struct Rocking {
  double half_width, half_height;  // m
  double tilt;                     // Of the start, over the angle at which the centre is above the edge.
  Ground ground;
  int index;
};

/// A slender block that tilts on an edge and is let go comes down on the other one and tilts on that: Housner, The
/// behavior of inverted pendulum structures during earthquakes, 1963, eq. (6). The impact leaves 1 - 3/2 sin^2(a) of
/// the angular velocity, for the angle a between the height and the diagonal. Greatest tilt of the second swing.
Sample MeasureRocking(const Conditions& conditions, const Rocking& it) {
  const double slenderness = std::atan(it.half_width / it.half_height), start = it.tilt * slenderness;
  const double kept = 1 - 1.5 * std::pow(std::sin(slenderness), 2);
  const double potential = std::cos(slenderness - start) - std::cos(slenderness);
  const double theory = slenderness - std::acos(std::cos(slenderness) + kept * kept * potential);
  Lab lab(conditions);
  lab.AddGround(it.ground);
  auto& shape = lab.Make<btBoxShape>(Vec(it.half_width, 1.2 * it.half_width, it.half_height));
  const double heading = HeadingOf(it.index);
  const btTransform edge = At(Vec(0.23, 0.31, 0), Yaw(heading));
  const btTransform turned = At(Vec(0, 0, 0), btQuaternion(Vec(0, 1, 0), btScalar(start)));
  const btTransform pose = edge * turned * At(Vec(-it.half_width, 0, it.half_height));
  const btRigidBody& body = lab.AddBody(shape, 1, pose, kRough);
  // A quarter of the first swing: acosh(1 / (1 - tilt)) over the frequency; the second one is not longer.
  const double diagonal = std::hypot(it.half_width, it.half_height);
  const double quarter = std::acosh(1 / (1 - it.tilt)) / std::sqrt(0.75 * kGravity / diagonal);
  double farthest = 0;
  for (int step = lab.StepsIn(2.3 * quarter); step > 0; --step) {
    lab.Step();
    const double lean = -Along(body.getWorldTransform().getBasis().getColumn(2), heading);
    farthest = std::max(farthest, std::asin(std::clamp(lean, -1.0, 1.0)));
  }
  return RelativeToTheory("block " + Text(2 * it.half_width) + " x " + Text(2 * it.half_height) + " m on " +
                              NameOf(it.ground) + " from " + Text(start) + " rad",
                          farthest, theory);
}

}  // namespace

Samples MeasureRocking(const Conditions& conditions) {
  constexpr std::array<std::array<double, 2>, 3> kHalves = {{{0.1, 0.4}, {0.25, 0.8}, {0.2, 1.2}}};
  constexpr std::array<double, 2> kTilts = {0.5, 0.8};
  Samples samples;
  for (const int i : SelectIndices(conditions, 24, 7)) {
    const std::size_t j = static_cast<std::size_t>(i);
    const auto& [half_width, half_height] = kHalves[j % 3];
    const Rocking it = {half_width, half_height, kTilts[(j / 3 + j / 12) % 2],
                        i % 2 == 0 ? Ground::kBox : Ground::kPlane, i};
    samples.push_back(MeasureRocking(conditions, it));
  }
  return samples;
}

Samples MeasureTip(const Conditions& conditions) {
  Samples samples;
  for (const Standing& it : SelectCases(conditions, StandingCases(), 5)) {
    samples.push_back(MeasureForceTip(conditions, it));
    samples.push_back(MeasureSlopeTip(conditions, it));
    if (it.ground != Ground::kPlane) samples.push_back(MeasureLedge(conditions, it));
  }
  return samples;
}

}  // namespace dgd_physics
