#include "heap.h"

#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <memory>
#include <vector>

namespace {

/// What the callbacks of a run have seen.
struct Seen {
  long added = 0, ended = 0;
  double distances = 0;
};
Seen g_seen;

bool CountAdded(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*, int,
                int) {
  ++g_seen.added;
  g_seen.distances += double(point.getDistance());
  return false;
}

void CountEnded(btPersistentManifold* const&) { ++g_seen.ended; }

/// Adds up what contactTest() reports.
struct ContactSum : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    ++count;
    distances += double(point.getDistance());
    return 0;
  }
  long count = 0;
  double distances = 0;
};

std::vector<std::unique_ptr<btCollisionShape>> MakeShapes() {
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  const btScalar half = btScalar(0.5);
  shapes.push_back(std::make_unique<btBoxShape>(btVector3(half, half, half)));
  shapes.push_back(std::make_unique<btSphereShape>(half));
  shapes.push_back(std::make_unique<btCapsuleShape>(btScalar(0.3), half));
  shapes.push_back(std::make_unique<btConeShape>(half, 1));
  shapes.push_back(std::make_unique<btCylinderShape>(btVector3(half, half, half)));
  auto hull = std::make_unique<btConvexHullShape>();
  for (const int sign : {-1, 1}) {
    const btScalar end = half * btScalar(sign);
    for (const btVector3& point : {btVector3(end, 0, 0), btVector3(0, end, 0), btVector3(0, 0, end)}) {
      hull->addPoint(point);
    }
  }
  shapes.push_back(std::move(hull));
  auto compound = std::make_unique<btCompoundShape>();
  for (const int side : {-1, 1}) {
    compound->addChildShape(btTransform(btQuaternion::getIdentity(), half * btVector3(btScalar(side), 0, 0)),
                            shapes[side < 0 ? 0 : 1].get());
  }
  shapes.push_back(std::move(compound));
  return shapes;
}

void AddFloor(btTriangleMesh& mesh) {
  for (int i = -4; i < 4; ++i) {
    for (int j = -4; j < 4; ++j) {
      const auto corner = [&](int x, int y) {
        return btVector3(btScalar(i + x), btScalar(j + y), (i + x + j + y) % 2 == 0 ? 0 : btScalar(0.1));
      };
      mesh.addTriangle(corner(0, 0), corner(1, 0), corner(1, 1));
      mesh.addTriangle(corner(0, 0), corner(1, 1), corner(0, 1));
    }
  }
}

}  // namespace

bool RunHeap() {
  g_seen = {};
  gContactAddedCallback = CountAdded;
  gContactEndedCallback = CountEnded;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, btScalar(-9.81)));

  btStaticPlaneShape plane(btVector3(0, 0, 1), btScalar(-0.2));
  btTriangleMesh mesh;
  AddFloor(mesh);
  btBvhTriangleMeshShape floor(&mesh, true);
  const auto shapes = MakeShapes();
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  bodies.push_back(std::make_unique<btRigidBody>(0, nullptr, &plane));
  bodies.push_back(std::make_unique<btRigidBody>(0, nullptr, &floor));
  for (int i = 0; i < 70; ++i) {
    btCollisionShape* shape = shapes[static_cast<std::size_t>(i) % shapes.size()].get();
    btVector3 inertia;
    shape->calculateLocalInertia(1, inertia);
    bodies.push_back(std::make_unique<btRigidBody>(1, nullptr, shape, inertia));
    const btVector3 place(btScalar(i % 3) - btScalar(1.1), btScalar(i / 3 % 3) - btScalar(0.9), btScalar(1 + i / 6));
    bodies.back()->setWorldTransform(btTransform(btQuaternion(btVector3(1, 2, 3), btScalar(i)), place));
    if (i % 2 == 0) {
      bodies.back()->setCollisionFlags(bodies.back()->getCollisionFlags() |
                                       btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    }
  }
  for (const auto& body : bodies) world.addRigidBody(body.get());

  ContactSum queried;
  queried.m_closestDistanceThreshold = btScalar(0.1);
  for (int step = 0; step < 480; ++step) {
    world.stepSimulation(btScalar(1) / 120, 0);
    if (step % 20 == 0) world.contactTest(bodies[2 + static_cast<std::size_t>(step) / 20].get(), queried);
  }

  bool is_above = true;
  for (const auto& body : bodies) {
    const btTransform& pose = body->getWorldTransform();
    const btVector3 ends[] = {pose.getOrigin(), pose.getBasis()[0], pose.getBasis()[1], body->getLinearVelocity()};
    for (const btVector3& end : ends) std::printf("%a %a %a ", double(end.x()), double(end.y()), double(end.z()));
    std::printf("\n");
    is_above = is_above && pose.getOrigin().z() > btScalar(-0.3);  // False for NaN.
  }
  std::printf("%ld %ld %a %ld %a\n", g_seen.added, g_seen.ended, g_seen.distances, queried.count, queried.distances);
  for (const auto& body : bodies) world.removeRigidBody(body.get());
  gContactAddedCallback = nullptr;
  gContactEndedCallback = nullptr;
  return is_above;
}
