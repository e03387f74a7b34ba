// What apps are built of, the lab of tests/physics, and how they read their world.
#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "apps/app.h"
#include "physics/lab.h"

namespace dgd_apps {

using dgd_physics::Along;
using dgd_physics::At;
using dgd_physics::Direction;
using dgd_physics::FootOf;
using dgd_physics::Form;
using dgd_physics::Grid;
using dgd_physics::Ground;
using dgd_physics::HeadingOf;
using dgd_physics::HeightOf;
using dgd_physics::kGravity;
using dgd_physics::kPi;
using dgd_physics::Lab;
using dgd_physics::NameOf;
using dgd_physics::PhaseOf;
using dgd_physics::PositionOf;
using dgd_physics::SelectIndices;
using dgd_physics::Surface;
using dgd_physics::Text;
using dgd_physics::TiltOf;
using dgd_physics::Vec;
using dgd_physics::Yaw;

/// Calls visit(const btPersistentManifold&, const btManifoldPoint&) for every contact point of the last step.
template <class Visit>
void ForEachPoint(btDispatcher& dispatcher, const Visit& visit) {
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold.getNumContacts(); ++j) visit(manifold, manifold.getContactPoint(j));
  }
}
template <class Visit>
void ForEachPoint(Lab& lab, const Visit& visit) {
  ForEachPoint(*lab.world().getDispatcher(), visit);
}

inline bool IsOf(const btPersistentManifold& manifold, const btCollisionObject& object) {
  return manifold.getBody0() == &object || manifold.getBody1() == &object;
}

/// Of all contact points, or of an object's; metres, 0 without overlap.
double DeepestOverlap(Lab& lab, const btCollisionObject* object = nullptr);

/// Force on an object by all that touches it, friction included, in the last step, N.
btVector3 ContactForceOn(Lab& lab, const btCollisionObject& object);

/// Of the centre, and by rotation at a radius, m/s.
double SpeedOf(const btRigidBody& body, double radius);

class RootMeanSquare {
 public:
  void Add(double value) {
    squares_ += value * value;
    ++count_;
  }
  double Value() const { return count_ == 0 ? 0 : std::sqrt(squares_ / count_); }

 private:
  double squares_ = 0;
  int count_ = 0;
};

/// Root mean square speed of all moving bodies over the next seconds, m/s.
double RestSpeed(Lab& lab, double seconds, double radius);

/// Sets one of Bullet's global callbacks as long as it lives.
template <class Callback>
class CallbackGuard {
 public:
  CallbackGuard(Callback& global, Callback value) : global_(global), before_(global) { global_ = value; }
  ~CallbackGuard() { global_ = before_; }
  CallbackGuard(const CallbackGuard&) = delete;
  CallbackGuard& operator=(const CallbackGuard&) = delete;

 private:
  Callback& global_;
  Callback before_;
};

/// Started and ended contacts, as Bullet's callbacks report them, as long as it lives. One at a time.
class ContactEvents {
 public:
  ContactEvents();
  ~ContactEvents();
  ContactEvents(const ContactEvents&) = delete;
  ContactEvents& operator=(const ContactEvents&) = delete;

  void Reset();
  int Started() const;
  int Ended() const;
};

/// @param half  Half the edge length, margin included, m.
inline btBoxShape& MakeCube(Lab& lab, double half) { return lab.Make<btBoxShape>(Vec(half, half, half)); }

}  // namespace dgd_apps
