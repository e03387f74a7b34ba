#include "worlds.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <string_view>

#include "heap.h"

namespace {

constexpr btScalar kHalf = btScalar(0.5);

/// A ground, and one body of each shape with its centre half a metre above its lower side, which is flat.
class World {
 public:
  World() {
    world_.setGravity(btVector3(0, 0, btScalar(-9.81)));
    ground_.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -1)));
    world_.addRigidBody(&ground_);
    for (int i = 0; i < 8; ++i) {
      hull_shape_.addPoint(btVector3(i & 1 ? kHalf : -kHalf, i & 2 ? kHalf : -kHalf, i & 4 ? kHalf : -kHalf));
    }
    hull_shape_.setMargin(0);
    compound_shape_.addChildShape(btTransform::getIdentity(), &box_shape_);
    btScalar place = -3;
    for (btRigidBody* body : {&box_, &hull_, &cylinder_, &compound_}) {
      btVector3 inertia;
      body->getCollisionShape()->calculateLocalInertia(1, inertia);
      body->setMassProps(1, inertia);
      body->updateInertiaTensor();
      body->setWorldTransform(
          btTransform(btQuaternion(btVector3(1, 0, 0), btScalar(0.1)), btVector3(place, 0, btScalar(1.2))));
      world_.addRigidBody(body);
      place += 2;
    }
  }
  ~World() {
    for (btRigidBody* body : {&compound_, &cylinder_, &hull_, &box_, &ground_}) world_.removeRigidBody(body);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void Step() { world_.stepSimulation(btScalar(1) / 240, 0); }

  /// Prints all poses.
  /// @return whether all bodies lie as they must.
  bool Print() const {
    bool lie = true;
    for (const btRigidBody* body : {&box_, &hull_, &cylinder_, &compound_}) {
      const btVector3& origin = body->getWorldTransform().getOrigin();
      const btQuaternion turn = body->getWorldTransform().getRotation();
      const double pose[] = {origin.x(), origin.y(), origin.z(), turn.x(), turn.y(), turn.z(), turn.w()};
      for (const double number : pose) std::printf("%a ", number);
      std::printf("\n");
      lie = lie && std::abs(double(origin.z()) - 0.5) < 0.005;  // False for NaN.
    }
    return lie;
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btBoxShape ground_shape_{btVector3(10, 10, 1)};
  btBoxShape box_shape_{btVector3(kHalf, kHalf, kHalf)};
  btConvexHullShape hull_shape_;
  btCylinderShapeZ cylinder_shape_{btVector3(kHalf, kHalf, kHalf)};
  btCompoundShape compound_shape_;
  btRigidBody ground_{0, nullptr, &ground_shape_};
  btRigidBody box_{1, nullptr, &box_shape_}, hull_{1, nullptr, &hull_shape_}, cylinder_{1, nullptr, &cylinder_shape_},
      compound_{1, nullptr, &compound_shape_};
};

constexpr int kSteps = 3 * 240;

bool RunOne() {
  World world;
  for (int step = 0; step < kSteps; ++step) world.Step();
  return world.Print();
}

bool RunTogether() {
  World first, second;
  for (int step = 0; step < kSteps; ++step) {
    first.Step();
    second.Step();
  }
  const bool first_lies = first.Print();
  return second.Print() && first_lies;
}

bool RunSequence() {
  bool lie = true;
  for (int i = 0; i < 3; ++i) lie = RunOne() && lie;
  return lie;
}

}  // namespace

int RunWorlds(const char* arrangement) {
  const std::string_view name = arrangement;
  if (name == "one") return RunOne() ? 0 : 1;
  if (name == "together") return RunTogether() ? 0 : 1;
  if (name == "sequence") return RunSequence() ? 0 : 1;
  if (name == "heap") return RunHeap() ? 0 : 1;
  return 2;
}
