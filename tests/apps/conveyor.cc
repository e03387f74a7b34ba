// A plant of conveyors: goods ride over three belts in a row, of which each is flush with the next, along a guide rail.
#include <algorithm>

#include "apps/apps.h"
#include "apps/world.h"

namespace dgd_apps {
namespace {

enum class Drive { kTickCallback, kContactCallback };

struct Belts {
  std::vector<btRigidBody*> bodies;
  btVector3 velocity = Vec(0, 0, 0);
};

/// Outside of a step Bullet overwrites the velocity of a kinematic body.
void SetVelocities(btDynamicsWorld* world, btScalar) {
  const Belts& belts = *static_cast<const Belts*>(world->getWorldUserInfo());
  for (btRigidBody* body : belts.bodies) body->setLinearVelocity(belts.velocity);
}

/// The surface velocity is that of the second body against the first, along the first friction direction.
bool MoveSurface(btManifoldPoint& point, const btCollisionObjectWrapper* first, int, int,
                 const btCollisionObjectWrapper* second, int, int) {
  const auto* belts = static_cast<const Belts*>(second->getCollisionObject()->getUserPointer());
  const bool is_second = belts != nullptr;
  if (!is_second) belts = static_cast<const Belts*>(first->getCollisionObject()->getUserPointer());
  if (belts == nullptr) return true;
  const btScalar speed = belts->velocity.length();
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  point.m_lateralFrictionDir1 = belts->velocity / speed;
  point.m_lateralFrictionDir2 = point.m_normalWorldOnB.cross(point.m_lateralFrictionDir1);
  point.m_contactMotion1 = is_second ? speed : -speed;
  return true;
}

struct Ride {
  Form form;
  Drive drive;
  double half, speed;  // m, m/s
  bool has_rail;
  int index;
};

void AddBelts(Lab& lab, const Ride& it, const btTransform& frame, Belts& belts) {
  auto& shape = lab.Make<btBoxShape>(Vec(0.5, 0.4, 0.1));
  const Surface rough = {.friction = 1};
  for (int i = 0; i < 4; ++i) {
    btRigidBody& body = lab.AddKinematic(shape, frame * At(Vec(i, 0, -0.1)), rough);
    belts.bodies.push_back(&body);
    if (it.drive == Drive::kTickCallback) continue;
    body.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    body.setUserPointer(&belts);
  }
  if (it.drive == Drive::kTickCallback) {
    lab.world().setInternalTickCallback(SetVelocities, &belts, true);
  } else {
    // Without these Bullet computes its own friction directions.
    lab.world().getSolverInfo().m_solverMode |=
        SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
  }
}

/// How far the goods are from where the belts bring them, how far they stray aside, and how they hop.
Case RunRide(const Conditions& conditions, const Ride& it) {
  constexpr double kWay = 2.5;  // m
  const CallbackGuard<ContactAddedCallback> guard(gContactAddedCallback, MoveSurface);
  Lab lab(conditions);
  const double heading = HeadingOf(it.index);
  const btTransform frame = At(Vec(0, 0, 0), Yaw(heading));
  Belts belts{{}, Direction(heading) * btScalar(it.speed)};
  AddBelts(lab, it, frame, belts);
  btConvexShape& shape = lab.MakeForm(it.form, it.half);
  const double foot = FootOf(shape), half_width = it.form == Form::kBox ? 0.8 * it.half : it.half;
  // A rail that the goods just touch, or one that they do not.
  const double gap = it.has_rail ? 0.001 : 0.1;
  lab.AddStatic(lab.Make<btBoxShape>(Vec(3, 0.05, 0.1)), frame * At(Vec(1, half_width + gap + 0.05, 0.1)),
                {.friction = 0});
  btRigidBody& body = lab.AddBody(shape, 1, frame * At(Vec(0, 0, foot)), Surface{.friction = 0.6});
  body.setLinearVelocity(belts.velocity);
  const int steps = lab.StepsIn(kWay / it.speed);
  double hop = 0;
  for (int step = 0; step < steps; ++step) {
    lab.Step();
    hop = std::max(hop, HeightOf(body) - foot);
  }
  const btVector3 place = frame.inverse() * PositionOf(body);
  const double late = std::abs(double(place.x()) - it.speed * steps * lab.dt());
  return {it.drive == Drive::kTickCallback ? "tick callback" : "contact callback",
          NameOf(it.form) + " " + Text(it.half) + " m at " + Text(it.speed) + " m/s" +
              (it.drive == Drive::kTickCallback ? ", tick callback" : ", contact callback") +
              (it.has_rail ? ", along a rail" : ""),
          {1000 * late, 1000 * std::abs(double(place.y())), 1000 * hop}};
}

Cases RunConveyor(const Conditions& conditions) {
  constexpr std::array kForms = {Form::kBox, Form::kHull, Form::kCylinder};
  constexpr std::array<double, 3> kSpeeds = {1, 0.3, 2.5};
  Cases cases;
  for (const int i : SelectIndices(conditions, 36, 2)) {
    const std::size_t j = static_cast<std::size_t>(i);
    cases.push_back(
        RunRide(conditions, {kForms[(j / 2) % 3], (i / 6) % 2 == 0 ? Drive::kTickCallback : Drive::kContactCallback,
                             (i / 4) % 2 == 0 ? 0.1 : 0.2, kSpeeds[(j / 2 + j / 6) % 3], (i / 12) % 2 == 1, i}));
  }
  return cases;
}

}  // namespace

App Conveyor() {
  return {"conveyor",
          "goods ride over four flush belts, free or along a guide rail: how far they are off",
          {{"late or early, mm", Combine::kMean, 0.1, 1, "a millimetre in 2.5 m is nothing to a plant"},
           {"aside, mm", Combine::kMean, 0.1, 1, "the same"},
           {"hop, mm", Combine::kWorst, 0.1, 0.5, "half a millimetre is the built-in's push-out of a resting box"}},
          RunConveyor};
}

}  // namespace dgd_apps
