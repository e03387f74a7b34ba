// Poles, posts and stelae that stand upright where they were put. Statics: any body on a face, its centre above
// the middle of it, stands still.
#include <cmath>
#include <vector>

#include "physics/lab.h"
#include "physics/resting.h"

namespace dgd_physics {
namespace {

struct Pole {
  Form form;
  double half_width;   // m
  double slenderness;  // Height over width.
  Ground ground;
  int index;
};

std::vector<Pole> PoleCases() {
  constexpr std::array kForms = {Form::kBox, Form::kCylinder, Form::kHull};
  constexpr std::array<double, 4> kHalfWidths = {0.02, 0.1, 0.05, 0.5};  // m
  constexpr std::array<double, 4> kSlendernesses = {10, 5, 20, 3};
  constexpr std::array kGrounds = {Ground::kPlane, Ground::kBox, Ground::kMesh};
  std::vector<Pole> cases;
  for (int i = 0; i < 36; ++i) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back({kForms[j % 3], kHalfWidths[(j + j / 12) % 4], kSlendernesses[(j / 4 + j / 6) % 4],
                     kGrounds[(j + j / 3) % 3], i});
  }
  return cases;
}

btConvexShape& MakePole(Lab& lab, const Pole& it) {
  const double width = it.half_width, height = it.slenderness * width;
  const btVector3 half = Vec(width, width, height);
  if (it.form == Form::kBox) return lab.Make<btBoxShape>(half);
  if (it.form == Form::kCylinder) return lab.Make<btCylinderShapeZ>(half);
  const double margin = 0.1 * width;
  return lab.MakePrism(6, width - margin, height - margin, margin);
}

/// Root mean square speed, of the centre and at the top, in the fourth second; over 5 cm/s as in `rest`.
Sample MeasurePole(const Conditions& conditions, const Pole& it) {
  constexpr double kSettleTime = 3, kMeasureTime = 1;  // s
  constexpr double kAtRest = 0.05;                     // m/s
  Lab lab(conditions);
  lab.AddGround(it.ground, btTransform::getIdentity(), {}, Surface{.friction = 1});
  btConvexShape& shape = MakePole(lab, it);
  const double foot = FootOf(shape);
  const btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0.23, 0.31, foot), Yaw(HeadingOf(it.index))));
  lab.Run(kSettleTime);
  double squares = 0;
  const int steps = lab.StepsIn(kMeasureTime);
  for (int step = 0; step < steps; ++step) {
    lab.Step();
    squares += double(body.getLinearVelocity().length2()) + foot * foot * double(body.getAngularVelocity().length2());
  }
  return {NameOf(it.form) + " of " + Text(2 * it.half_width) + " x " + Text(2 * foot) + " m on " + NameOf(it.ground) +
              ": m/s",
          std::sqrt(squares / steps), 0, kAtRest, NameOf(it.form)};
}

}  // namespace

Samples MeasurePoles(const Conditions& conditions) {
  return MeasureCases(conditions, PoleCases(), 5,
                      [](const Conditions& under, const Pole& it) { return MeasurePole(under, it); });
}

}  // namespace dgd_physics
