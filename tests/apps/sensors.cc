// Light barriers, triggers and collectibles: a body without contact response, or a ghost, which a body flies into. It
// must report the body when that overlaps it, not before, and leave its flight alone. The same where the app moves the
// body itself, and only queries contacts: of a world that never steps, or of an algorithm that it calls by hand.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Sensor { kBody, kGhost };

enum class Detection { kStep, kNoStep, kByHand };

struct Flight {
  Form sensor_form, form;
  Sensor sensor;
  double half, speed;  // m, m/s
  int index;
  Detection detection = Detection::kStep;

  std::string Group() const {
    if (detection == Detection::kByHand) return "by hand";
    if (detection == Detection::kNoStep) return "without steps";
    return sensor == Sensor::kGhost ? "ghosts" : "sensors";
  }
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
  const std::vector<Flight> stepped = flights;
  for (Flight flight : stepped) {
    flight.detection = flight.sensor == Sensor::kBody && flight.index % 4 < 2 ? Detection::kByHand : Detection::kNoStep;
    flights.push_back(flight);
  }
  return flights;
}

struct Report {
  int points = 0;
  bool overlaps = false;
};

Report ReportOf(const btPersistentManifold* manifold) {
  Report report;
  for (int i = 0; manifold != nullptr && i < manifold->getNumContacts(); ++i) {
    ++report.points;
    report.overlaps = report.overlaps || manifold->getContactPoint(i).getDistance() < 0;
  }
  return report;
}

Report ReportOf(Lab& lab) {
  Report report;
  ForEachPoint(lab, [&](const btPersistentManifold&, const btManifoldPoint&) { ++report.points; });
  report.overlaps = DeepestOverlap(lab) > 0;
  return report;
}

Report QueryByHand(Lab& lab, const btCollisionObject& first, const btCollisionObject& second) {
  btDispatcher& dispatcher = *lab.world().getDispatcher();
  const btCollisionObjectWrapper wrapped_first(nullptr, first.getCollisionShape(), &first, first.getWorldTransform(),
                                               -1, -1);
  const btCollisionObjectWrapper wrapped_second(nullptr, second.getCollisionShape(), &second,
                                                second.getWorldTransform(), -1, -1);
  btCollisionAlgorithm* algorithm =
      dispatcher.findAlgorithm(&wrapped_first, &wrapped_second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  btManifoldResult result(&wrapped_first, &wrapped_second);
  algorithm->processCollision(&wrapped_first, &wrapped_second, btDispatcherInfo(), &result);
  const Report report = ReportOf(result.getPersistentManifold());
  algorithm->~btCollisionAlgorithm();
  dispatcher.freeCollisionAlgorithm(algorithm);
  return report;
}

/// The gap at which the first point is seen, the steps of overlap until a distance below 0 is, and how much the flight
/// is disturbed.
Case RunFlight(const Conditions& conditions, const Flight& it) {
  Lab lab(conditions, 0);
  btGhostPairCallback ghost_pairs;
  lab.world().getBroadphase()->getOverlappingPairCache()->setInternalGhostPairCallback(&ghost_pairs);
  btConvexShape& sensor_shape = lab.MakeForm(it.sensor_form, it.half);
  btPairCachingGhostObject ghost;
  btCollisionObject* sensor = nullptr;
  if (it.sensor == Sensor::kGhost) {
    ghost.setCollisionShape(&sensor_shape);
    ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    lab.world().addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger, btBroadphaseProxy::AllFilter);
    sensor = &ghost;
  } else {
    sensor = &lab.AddStatic(sensor_shape, At(Vec(0, 0, 0)));
    sensor->setCollisionFlags(sensor->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
  }
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  // Straight down on the sensor's top.
  const double touching = FootOf(sensor_shape) + FootOf(shape);
  const double start = 0.03 + it.speed * lab.dt() * (2 + PhaseOf(it.index));
  btRigidBody& body = lab.AddBody(shape, 1, At(Vec(0, 0, touching + start)));
  body.setLinearVelocity(Vec(0, 0, -it.speed));
  // A step looks for contacts before it moves bodies.
  const auto look = [&] {
    if (it.detection == Detection::kStep) {
      lab.Step();
      return ReportOf(lab);
    }
    if (it.detection == Detection::kNoStep) lab.world().performDiscreteCollisionDetection();
    const Report report = it.detection == Detection::kByHand ? QueryByHand(lab, *sensor, body) : ReportOf(lab);
    body.setWorldTransform(At(PositionOf(body) - Vec(0, 0, it.speed * lab.dt())));
    return report;
  };
  double early = -1;
  int late = 0;
  bool is_reported = false;
  for (int step = lab.StepsIn((start + 0.01) / it.speed) + 3; step > 0 && !is_reported; --step) {
    const double gap = HeightOf(body) - touching;
    const Report report = look();
    if (early < 0 && report.points > 0) early = std::max(0.0, gap);
    is_reported = report.overlaps;
    // What is within roundoff of touching may be seen on either side.
    if (!is_reported && gap < -1e-4 * it.half) ++late;
  }
  const double disturbance = double((body.getLinearVelocity() + Vec(0, 0, it.speed)).length()) / it.speed;
  if (it.sensor == Sensor::kGhost) lab.world().removeCollisionObject(&ghost);
  lab.world().getBroadphase()->getOverlappingPairCache()->setInternalGhostPairCallback(nullptr);
  const std::string kind = it.sensor == Sensor::kGhost ? "ghost" : "sensor";
  return {it.Group(),
          it.Group() + ": " + kind + " " + NameOf(it.sensor_form) + " " + Text(it.half) + " m, " + NameOf(it.form) +
              " at " + Text(it.speed) + " m/s",
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
