// An app with Bullet's own threads: boxes fall on a ground, in a world whose dispatcher, solvers and motion run on two
// threads, and must come to rest on their faces. Exit status 0 if they do.
#include <BulletCollision/CollisionDispatch/btCollisionDispatcherMt.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorldMt.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "dgd_bullet/collision_configuration.h"

// Not defined for a Bullet without threads; here it must be, by the package.
static_assert(BT_THREADSAFE);

int main() {
  const std::unique_ptr<btITaskScheduler> scheduler(btCreateDefaultTaskScheduler());
  btSetTaskScheduler(scheduler.get());
  scheduler->setNumThreads(2);

  dgd_bullet::CollisionConfiguration configuration;
  btCollisionDispatcherMt dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btConstraintSolverPoolMt solvers(2);
  btDiscreteDynamicsWorldMt world(&dispatcher, &broadphase, &solvers, nullptr, &configuration);
  world.setGravity(btVector3(0, 0, btScalar(-9.81)));

  btBoxShape ground_shape(btVector3(50, 50, 1));  // its upper face is z = 0
  btRigidBody ground(0, nullptr, &ground_shape);
  ground.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -1)));
  world.addRigidBody(&ground);
  btBoxShape box_shape(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.5)));
  btVector3 inertia;
  box_shape.calculateLocalInertia(1, inertia);
  std::vector<std::unique_ptr<btRigidBody>> boxes;
  for (int i = 0; i < 400; ++i) {
    boxes.push_back(std::make_unique<btRigidBody>(btScalar(1), nullptr, &box_shape, inertia));
    const btVector3 place(btScalar(4 * (i % 20) - 38), btScalar(4 * (i / 20) - 38), 2);
    boxes.back()->setWorldTransform(btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(0.3)), place));
    world.addRigidBody(boxes.back().get());
  }
  for (int step = 0; step < 480; ++step) world.stepSimulation(btScalar(1) / 120, 0, btScalar(1) / 120);

  double worst = 0;  // m
  for (const auto& box : boxes) {
    worst = std::max(worst, std::abs(double(box->getWorldTransform().getOrigin().z()) - 0.5));
    world.removeRigidBody(box.get());
  }
  world.removeRigidBody(&ground);
  btSetTaskScheduler(nullptr);
  const auto fallbacks = static_cast<unsigned long long>(configuration.statistics().Fallbacks());
  std::printf("two threads: heights of rest off by up to %.6f m, %llu fallbacks\n", worst, fallbacks);
  return worst < 0.005 && fallbacks == 0 ? 0 : 1;
}
