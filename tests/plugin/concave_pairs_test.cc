// Concave against concave stays Bullet's: GImpact's own contacts are the same to the last bit, and two meshes have
// none.
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "dgd_bullet/register.h"

namespace dgd_test {
namespace {

btVector3 V(double x, double y, double z) { return {btScalar(x), btScalar(y), btScalar(z)}; }

double HeightOf(int i, int j) { return 0.1 * ((7 * i + 3 * j + 70) % 3); }

class ConcavePairs : public testing::Test {
 protected:
  ConcavePairs() {
    const std::array<btVector3, 4> corners = {V(-0.5, -0.5, -0.4), V(0.6, -0.5, -0.35), V(0, 0.6, -0.3),
                                              V(0.05, 0.02, 0.6)};
    for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
      tetrahedron_.addTriangle(corners[face[0]], corners[face[1]], corners[face[2]]);
    }
    const auto point = [](int i, int j) { return V(i, j, HeightOf(i, j)); };
    for (int i = -3; i < 3; ++i) {
      for (int j = -3; j < 3; ++j) {
        ground_.addTriangle(point(i, j), point(i + 1, j), point(i, j + 1));
        ground_.addTriangle(point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
        heights_.push_back(float(HeightOf(i, j)));
      }
    }
  }

  // The contacts of each step, as text that tells any two numbers apart.
  std::vector<std::string> Fall(btCollisionShape& ground, btCollisionShape& body, bool with_ours) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher);
    if (with_ours) dgd_bullet::Register(dispatcher);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(V(0, 0, -10));
    btRigidBody below(0, nullptr, &ground);
    std::vector<std::unique_ptr<btRigidBody>> bodies;
    world.addRigidBody(&below);
    for (const double height : {1.0, 2.0}) {
      bodies.push_back(std::make_unique<btRigidBody>(btScalar(1), nullptr, &body, V(0.1, 0.1, 0.1)));
      bodies.back()->setWorldTransform(
          btTransform(btQuaternion(V(1, 2, 3).normalized(), btScalar(0.4 * height)), V(0.1 * height, 0.2, height)));
      world.addRigidBody(bodies.back().get());
    }
    std::vector<std::string> steps;
    for (int step = 0; step < 240; ++step) {
      world.stepSimulation(btScalar(1) / 240, 0);
      steps.push_back(ContactsOf(dispatcher));
    }
    for (auto& each : bodies) world.removeRigidBody(each.get());
    world.removeRigidBody(&below);
    return steps;
  }

  btTriangleMesh tetrahedron_, ground_;
  std::vector<float> heights_;

 private:
  static std::string ContactsOf(btCollisionDispatcher& dispatcher) {
    std::string text;
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      for (int c = 0; c < manifold.getNumContacts(); ++c) {
        const btManifoldPoint& point = manifold.getContactPoint(c);
        for (const btVector3& vector : {point.m_positionWorldOnA, point.m_positionWorldOnB, point.m_normalWorldOnB}) {
          for (int i = 0; i < 3; ++i) text += Exact(vector[i]);
        }
        text += Exact(point.getDistance()) + Exact(point.getAppliedImpulse()) + '\n';
      }
    }
    return text;
  }
  static std::string Exact(btScalar number) {
    std::array<char, 64> digits;
    std::snprintf(digits.data(), digits.size(), "%a ", double(number));
    return digits.data();
  }
};

std::size_t ContactSteps(const std::vector<std::string>& steps) {
  std::size_t count = 0;
  for (const std::string& step : steps) count += step.empty() ? 0 : 1;
  return count;
}

TEST_F(ConcavePairs, GImpactOnGImpact_HasBulletsContactsToTheLastBit) {
  btGImpactMeshShape body(&tetrahedron_), ground(&ground_);
  body.updateBound();
  ground.updateBound();
  btStaticPlaneShape plane(V(0, 0, 1), 0);
  for (btCollisionShape* below : {static_cast<btCollisionShape*>(&ground), static_cast<btCollisionShape*>(&plane)}) {
    const std::vector<std::string> builtin = Fall(*below, body, false);
    EXPECT_GT(ContactSteps(builtin), 100u);
    EXPECT_EQ(Fall(*below, body, true), builtin);
  }
}

TEST_F(ConcavePairs, MeshOnMesh_HasNoContacts) {
  btBvhTriangleMeshShape body(&tetrahedron_, true), ground(&ground_, true);
  btHeightfieldTerrainShape terrain(6, 6, heights_.data(), 1, -1, 1, 2, PHY_FLOAT, false);
  for (btCollisionShape* below : {static_cast<btCollisionShape*>(&ground), static_cast<btCollisionShape*>(&terrain)}) {
    EXPECT_EQ(ContactSteps(Fall(*below, body, false)), 0u);
    EXPECT_EQ(ContactSteps(Fall(*below, body, true)), 0u);
  }
}

// Its pairs of triangles are ours.
TEST_F(ConcavePairs, GImpactOnMesh_LiesOnIt) {
  btGImpactMeshShape body(&tetrahedron_);
  body.updateBound();
  btBvhTriangleMeshShape ground(&ground_, true);
  EXPECT_GT(ContactSteps(Fall(ground, body, true)), 100u);
}

}  // namespace
}  // namespace dgd_test
