// Light barriers, triggers and collectibles: a body without contact response, or a ghost, which a body flies into. It
// must report the body when that overlaps it, not before, and leave its flight alone.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Sensor { kBody, kGhost };

struct Flight {
  Form sensor_form, form;
  Sensor sensor;
  double half, speed;  // m, m/s
  int index;
};

std::vector<Flight> Flights() {
  constexpr std::array kForms = {Form::kBox, Form::kSphere, Form::kHull, Form::kCapsule};
  std::vector<Flight> flights;
  for (const Sensor sensor : {Sensor::kBody, Sensor::kGhost}) {
    for (const Form sensor_form : kForms) {
      for (const Form form : kForms) {
        for (const double half : {0.5, 0.05}) {
          const int i = static_cast<int>(flights.size());
          flights.push_back({sensor_form, form, sensor, half, i % 3 == 0 ? 2 : 0.1, i});
        }
      }
    }
  }
  return flights;
}

/// The gap at which the first point is seen, the steps of overlap until a distance below 0 is, and how much the flight
/// is disturbed.
Case RunFlight(const Conditions& conditions, const Flight& it) {
  Lab lab(conditions, 0);
  btGhostPairCallback ghost_pairs;
  lab.world().getBroadphase()->getOverlappingPairCache()->setInternalGhostPairCallback(&ghost_pairs);
  btConvexShape& sensor_shape = lab.MakeForm(it.sensor_form, it.half);
  btPairCachingGhostObject ghost;
  if (it.sensor == Sensor::kGhost) {
    ghost.setCollisionShape(&sensor_shape);
    ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    lab.world().addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger, btBroadphaseProxy::AllFilter);
  } else {
    btRigidBody& body = lab.AddStatic(sensor_shape, At(Vec(0, 0, 0)));
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  }
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  // Straight down on the sensor's top.
  const double touching = FootOf(sensor_shape) + FootOf(shape);
  const double start = 0.03 + it.speed * lab.dt() * (2 + PhaseOf(it.index));
  btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0, 0, touching + start)));
  body.setLinearVelocity(Vec(0, 0, -it.speed));
  double early = -1;
  int late = 0;
  bool is_reported = false;
  for (int step = lab.StepsIn((start + 0.01) / it.speed) + 3; step > 0 && !is_reported; --step) {
    const double gap = HeightOf(body) - touching;  // The step looks for contacts before it moves bodies.
    lab.Step();
    int points = 0;
    ForEachPoint(lab, [&](const btPersistentManifold&, const btManifoldPoint&) { ++points; });
    if (early < 0 && points > 0) early = std::max(0.0, gap);
    is_reported = DeepestOverlap(lab) > 0;
    // What is within roundoff of touching may be seen on either side.
    if (!is_reported && gap < -1e-4 * it.half) ++late;
  }
  const double disturbance = double((body.getLinearVelocity() + Vec(0, 0, it.speed)).length()) / it.speed;
  if (it.sensor == Sensor::kGhost) lab.world().removeCollisionObject(&ghost);
  lab.world().getBroadphase()->getOverlappingPairCache()->setInternalGhostPairCallback(nullptr);
  const std::string kind = it.sensor == Sensor::kGhost ? "ghost" : "sensor";
  return {kind + "s",
          kind + " " + NameOf(it.sensor_form) + " " + Text(it.half) + " m, " + NameOf(it.form) + " at " +
              Text(it.speed) + " m/s",
          {1000 * std::max(0.0, early), double(late), is_reported ? 0.0 : 1.0, disturbance}};
}

Cases RunSensors(const Conditions& conditions) { return RunCases(conditions, Flights(), 1, RunFlight); }

}  // namespace

App Sensors() {
  return {"sensors",
          "a body flies into a sensor, of six pairs of shapes: gap at the first report, and what is missed",
          {{"first point early by, mm", Combine::kMean, 0.05, 0.1, "a tenth of a millimetre is seen by nobody"},
           {"steps late", Combine::kMean, 0, 0.05, "none, but for roundoff in single cases"},
           {"not reported, share", Combine::kMean, 0, 0, "one is one too many"},
           {"disturbance of the flight, share of the speed", Combine::kWorst, 0, 1e-6, "roundoff"}},
          RunSensors};
}

}  // namespace dgd_apps
