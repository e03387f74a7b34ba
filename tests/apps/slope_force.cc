// A force sensor under a load that rests on a slope: what it reads is the weight, steadily.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Load {
  Ground ground;
  Form form;
  double slope;    // rad
  bool is_double;  // Another body on top.
  int index;
};

Case RunLoad(const Conditions& conditions, const Load& it) {
  constexpr double kHalf = 0.25, kMass = 50, kSettleTime = 1.5, kMeasureTime = 0.5;  // m, kg, s
  Lab lab(conditions);
  const btTransform frame = At(Vec(0, 0, 0), btQuaternion(Direction(HeadingOf(it.index)), btScalar(it.slope)));
  btRigidBody& ground = lab.AddGround(it.ground, frame);
  btConvexShape& shape = lab.MakeForm(it.form, kHalf);
  const double foot = FootOf(shape);
  const Surface rough = {.friction = 1};
  lab.AddBody(shape, kMass, frame * At(Vec(0.23, 0.31, foot)), rough);
  if (it.is_double) lab.AddBody(MakeCube(lab, 0.1), kMass, frame * At(Vec(0.25, 0.33, 2 * foot + 0.1)), rough);
  const double weight = (it.is_double ? 2 : 1) * kMass * kGravity;
  lab.Run(kSettleTime);
  double least = 1e9, most = -1e9;
  RootMeanSquare error;
  for (int step = lab.StepsIn(kMeasureTime); step > 0; --step) {
    lab.Step();
    const btVector3 force = ContactForceOn(lab, ground) / btScalar(weight);
    const double normal = -double(force.dot(frame.getBasis().getColumn(2))) / std::cos(it.slope);
    least = std::min(least, normal);
    most = std::max(most, normal);
    error.Add(double((force + Vec(0, 0, 1)).length()));
  }
  return {it.is_double ? "two" : "one",
          std::string(it.is_double ? "two on " : "") + NameOf(it.form) + " on " + NameOf(it.ground) + ", " +
              Text(it.slope) + " rad",
          {most - least, error.Value()}};
}

std::vector<Load> Loads() {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder};
  constexpr std::array kGrounds = {Ground::kBox, Ground::kPlane, Ground::kMesh, Ground::kHeightfield};
  std::vector<Load> loads;
  for (const bool is_double : {false, true}) {
    for (const double slope : {0.3, 0.1}) {
      for (const Form form : kForms) {
        for (const Ground ground : kGrounds) loads.push_back({ground, form, slope, is_double, int(loads.size())});
      }
    }
  }
  return loads;
}

Cases RunSlopeForce(const Conditions& conditions) { return RunCases(conditions, Loads(), 5, RunLoad); }

}  // namespace

App SlopeForce() {
  return {"slope_force",
          "loads at rest on slopes: how much the force that a sensor under them reads varies",
          {{"spread of the normal force, share", Combine::kMean, 0.1, 0.02, "sensors are good to a percent or two"},
           {"rms error of the force, share", Combine::kMean, 0.1, 0.01, "the same"}},
          RunSlopeForce};
}

}  // namespace dgd_apps
