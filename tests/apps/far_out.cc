// Open worlds: what lies on the ground 1 to 100 km from the origin must lie still there as well. In float positions
// are whole multiples of 8 mm at 100 km.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

struct Place {
  Form form;
  Ground ground;
  double distance;  // m
  int index;
};

Case RunPlace(const Conditions& conditions, const Place& it) {
  constexpr double kHalf = 0.5, kSettleTime = 1.5, kMeasureTime = 0.5;  // m, s
  Lab lab(conditions);
  const btVector3 far = Direction(HeadingOf(it.index)) * btScalar(it.distance);
  lab.AddGround(it.ground, At(far));
  btConvexShape& shape = lab.MakeForm(it.form, kHalf);
  const double foot = FootOf(shape);
  btRigidBody& body = lab.AddBody(shape, 1, At(far + Vec(0.25, 0.5, foot + 0.1), Yaw(0.3)), Surface{.friction = 0.7});
  lab.Run(kSettleTime);
  const btVector3 start = PositionOf(body);
  const double speed = RestSpeed(lab, kMeasureTime, kHalf);
  const double way = double((PositionOf(body) - start).length());
  const double sunk = std::max(0.0, foot - HeightOf(body));
  return {Text(it.distance / 1000) + " km",
          NameOf(it.form) + " on " + NameOf(it.ground) + ", " + Text(it.distance / 1000) + " km",
          {1000 * speed, 1000 * way, 1000 * sunk, sunk > 0.5 * kHalf || !std::isfinite(sunk) ? 1.0 : 0.0}};
}

std::vector<Place> Places() {
  std::vector<Place> places;
  for (const double distance : {100e3, 1e3, 10e3}) {
    for (const Ground ground : {Ground::kBox, Ground::kPlane, Ground::kMesh, Ground::kHeightfield}) {
      for (const Form form : {Form::kBox, Form::kHull, Form::kSphere, Form::kCylinder, Form::kCapsule})
        places.push_back({form, ground, distance, int(places.size())});
    }
  }
  return places;
}

Cases RunFarOut(const Conditions& conditions) { return RunCases(conditions, Places(), 3, RunPlace); }

}  // namespace

App FarOut() {
  return {"far_out",
          "bodies come to rest 1 to 100 km from the origin: how fast they still move, and how deep they sink",
          {{"speed at rest, mm/s", Combine::kMean, 0.1, 2, "what moves 2 mm/s falls asleep all the same"},
           {"way in half a second, mm", Combine::kMean, 0.1, 0.5, "a sixteenth of what float resolves at 100 km"},
           {"sunk, mm", Combine::kMean, 0.1, 1, "an eighth of what float resolves at 100 km"},
           {"through the ground", Combine::kTotal, 0, 0, "one is one too many"}},
          RunFarOut};
}

}  // namespace dgd_apps
