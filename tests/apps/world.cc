#include "apps/world.h"

#include <algorithm>

namespace dgd_apps {
namespace {

int started = 0, ended = 0;

void CountStarted(btPersistentManifold* const&) { ++started; }
void CountEnded(btPersistentManifold* const&) { ++ended; }

}  // namespace

double DeepestOverlap(Lab& lab, const btCollisionObject* object) {
  double deepest = 0;
  ForEachPoint(lab, [&](const btPersistentManifold& manifold, const btManifoldPoint& point) {
    if (object == nullptr || IsOf(manifold, *object)) deepest = std::max(deepest, -double(point.getDistance()));
  });
  return deepest;
}

btVector3 ContactForceOn(Lab& lab, const btCollisionObject& object) {
  btVector3 impulse = Vec(0, 0, 0);
  ForEachPoint(lab, [&](const btPersistentManifold& manifold, const btManifoldPoint& point) {
    if (!IsOf(manifold, object)) return;
    const btVector3 on_first = point.m_normalWorldOnB * point.m_appliedImpulse +
                               point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1 +
                               point.m_lateralFrictionDir2 * point.m_appliedImpulseLateral2;
    impulse += manifold.getBody0() == &object ? on_first : -on_first;
  });
  return impulse / btScalar(lab.dt());
}

double SpeedOf(const btRigidBody& body, double radius) {
  return std::hypot(double(body.getLinearVelocity().length()), radius * double(body.getAngularVelocity().length()));
}

double RestSpeed(Lab& lab, double seconds, double radius) {
  RootMeanSquare speed;
  for (int step = lab.StepsIn(seconds); step > 0; --step) {
    lab.Step();
    for (int i = 0; i < lab.world().getNumCollisionObjects(); ++i) {
      const auto* body = btRigidBody::upcast(lab.world().getCollisionObjectArray()[i]);
      if (body != nullptr && !body->isStaticOrKinematicObject()) speed.Add(SpeedOf(*body, radius));
    }
  }
  return speed.Value();
}

ContactEvents::ContactEvents() {
  Reset();
  gContactStartedCallback = CountStarted;
  gContactEndedCallback = CountEnded;
}

ContactEvents::~ContactEvents() {
  gContactStartedCallback = nullptr;
  gContactEndedCallback = nullptr;
}

void ContactEvents::Reset() { started = ended = 0; }
int ContactEvents::Started() const { return started; }
int ContactEvents::Ended() const { return ended; }

}  // namespace dgd_apps
