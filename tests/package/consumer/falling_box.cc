// A Bullet app as a user would write it, against the installed package: a box falls on a ground and must come to rest
// on its face, with its centre half a box above the ground. Exit status 0 if it does.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>

#include "dgd_bullet/collision_configuration.h"

static bool FallsToRest() {
  dgd_bullet::CollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);

  btBoxShape ground_shape(btVector3(5, 5, 1));  // its upper face is z = 0
  btRigidBody ground(0, nullptr, &ground_shape);
  ground.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -1)));
  world.addRigidBody(&ground);

  const btScalar half = btScalar(0.5);
  btBoxShape box_shape(btVector3(half, half, half));
  btVector3 inertia;
  box_shape.calculateLocalInertia(1, inertia);
  btRigidBody box(1, nullptr, &box_shape, inertia);
  box.setWorldTransform(btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(0.2)), btVector3(0, 0, 2)));
  world.addRigidBody(&box);

  world.setGravity(btVector3(0, 0, btScalar(-9.81)));
  for (int step = 0; step < 4 * 240; ++step) world.stepSimulation(btScalar(1) / 240, 0);

  const double height = box.getWorldTransform().getOrigin().z();
  const double speed = box.getLinearVelocity().length();
  const auto fallbacks = static_cast<unsigned long long>(configuration.statistics().Fallbacks());
  const char* const precision = sizeof(btScalar) == sizeof(double) ? "float64" : "float";
  std::printf("height %.6f m, speed %.2e m/s, %llu fallbacks, %s\n", height, speed, fallbacks, precision);
  // Bullet's solver leaves resting bodies a little deep; a wrong sign or margin is off by centimetres.
  const bool at_rest = std::abs(height - 0.5) < 0.005 && speed < 0.01;
  return at_rest && fallbacks == 0 && std::strcmp(precision, EXPECTED_PRECISION) == 0;
}

int main() {
  try {
    return FallsToRest() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
