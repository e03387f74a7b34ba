#include "bench/replay_world.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "simulation/bullet_math.h"
#include "simulation/bullet_shape.h"

namespace dgd_bench {
namespace {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

double MedianOfClock() {
  std::array<double, 1001> times;
  for (double& time : times) {
    const Clock::time_point start = Clock::now();
    time = Microseconds(Clock::now() - start).count();
  }
  std::ranges::sort(times);
  return times[times.size() / 2];
}

int IndexOf(const btBroadphaseProxy* proxy) {
  return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
}

// The deepest point of the pair's manifolds.
void ReadContacts(btBroadphasePair& pair, PairSample& sample) {
  if (pair.m_algorithm == nullptr) return;
  btManifoldArray manifolds;
  pair.m_algorithm->getAllContactManifolds(manifolds);
  for (int m = 0; m < manifolds.size(); ++m) {
    const btPersistentManifold& manifold = *manifolds[m];
    for (int c = 0; c < manifold.getNumContacts(); ++c) {
      const double separation = manifold.getContactPoint(c).getDistance();
      if (sample.contacts++ == 0 || separation < sample.separation) sample.separation = separation;
    }
  }
}

}  // namespace

PairTimingDispatcher::PairTimingDispatcher(btCollisionConfiguration* configuration)
    : btCollisionDispatcher(configuration), clock_us_(MedianOfClock()) {
  setNearCallback(TimePair);
}

void PairTimingDispatcher::TimePair(btBroadphasePair& pair, btCollisionDispatcher& dispatcher,
                                    const btDispatcherInfo& info) {
  auto& self = static_cast<PairTimingDispatcher&>(dispatcher);
  const Clock::time_point start = Clock::now();
  defaultNearCallback(pair, dispatcher, info);
  const double elapsed = Microseconds(Clock::now() - start).count();
  const auto [first, second] = std::minmax({IndexOf(pair.m_pProxy0), IndexOf(pair.m_pProxy1)});
  PairSample sample{{first, second}, std::max(0.0, elapsed - self.clock_us_)};
  ReadContacts(pair, sample);
  self.samples.push_back(sample);
}

ReplayWorld::ReplayWorld(const std::vector<dgd_demos::Body>& bodies, dgd_demos::Narrowphase narrowphase,
                         double time_step)
    : configuration_(MakeCollisionConfiguration(narrowphase)),
      dispatcher_(configuration_.get()),
      world_(&dispatcher_, &broadphase_, configuration_.get()),
      time_step_(dgd_demos::ToBullet(time_step)) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const dgd_demos::Body& body = bodies[i];
    shapes_.push_back(MakeBulletShape(body.shape, body.margin));
    // The inertia plays no part.
    btRigidBody::btRigidBodyConstructionInfo info(dgd_demos::ToBullet(body.mass), nullptr, shapes_.back().get(),
                                                  btVector3(1, 1, 1));
    info.m_friction = dgd_demos::ToBullet(body.friction);
    info.m_restitution = dgd_demos::ToBullet(body.restitution);
    rigid_bodies_.push_back(std::make_unique<btRigidBody>(info));
    rigid_bodies_.back()->setUserIndex(static_cast<int>(i));
    rigid_bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    const bool is_static = body.mass == 0;
    const int all_but_static = btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter;
    world_.addCollisionObject(rigid_bodies_.back().get(),
                              is_static ? btBroadphaseProxy::StaticFilter : btBroadphaseProxy::DefaultFilter,
                              is_static ? all_but_static : btBroadphaseProxy::AllFilter);
  }
  world_.getDispatchInfo().m_timeStep = time_step_;
}

std::vector<PairSample> ReplayWorld::Detect(const std::vector<dgd_demos::Pose>& poses,
                                            const std::vector<dgd_demos::Pose>& next) {
  for (std::size_t i = 0; i < rigid_bodies_.size(); ++i) {
    btRigidBody& body = *rigid_bodies_[i];
    const btTransform now = dgd_demos::ToBullet(poses[i]);
    body.setWorldTransform(now);
    if (body.isStaticObject()) continue;
    // As a dynamics world leaves it: bounding boxes reach to where the body will be.
    const btTransform then = dgd_demos::ToBullet(next[i]);
    body.setInterpolationWorldTransform(then);
    btVector3 velocity, angular_velocity;
    btTransformUtil::calculateVelocity(now, then, time_step_, velocity, angular_velocity);
    body.setLinearVelocity(velocity);
    body.setAngularVelocity(angular_velocity);
  }
  world_.performDiscreteCollisionDetection();
  return std::exchange(dispatcher_.samples, {});
}

}  // namespace dgd_bench
