// The narrowphase in a configuration that is not Bullet's default: that of soft bodies.
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <LinearMath/btPoolAllocator.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <cmath>

#include "plugin/test_world.h"

namespace dgd_test {
namespace {

using Configuration = dgd_bullet::CollisionConfigurationOf<btSoftBodyRigidBodyCollisionConfiguration>;
using Stock = btSoftBodyRigidBodyCollisionConfiguration;

TEST(SoftBodyConfiguration, TakesConvexPairsAndLeavesTheSoftOnes) {
  Configuration configuration;
  const int box = BOX_SHAPE_PROXYTYPE, soft = SOFTBODY_SHAPE_PROXYTYPE;
  const auto* ours = configuration.getCollisionAlgorithmCreateFunc(box, box);
  EXPECT_NE(ours, configuration.Stock::getCollisionAlgorithmCreateFunc(box, box));
  EXPECT_EQ(ours, configuration.getCollisionAlgorithmCreateFunc(CONE_SHAPE_PROXYTYPE, SPHERE_SHAPE_PROXYTYPE));
  for (const int type : {box, soft, int(TRIANGLE_MESH_SHAPE_PROXYTYPE)}) {
    EXPECT_EQ(configuration.getCollisionAlgorithmCreateFunc(soft, type),
              configuration.Stock::getCollisionAlgorithmCreateFunc(soft, type));
    EXPECT_EQ(configuration.getCollisionAlgorithmCreateFunc(type, soft),
              configuration.Stock::getCollisionAlgorithmCreateFunc(type, soft));
  }
}

TEST(SoftBodyConfiguration, TakesOptionsAndTheBasesOwnArguments) {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 17;
  dgd_bullet::Options options;
  options.max_iterations = 0;
  EXPECT_THROW(Configuration(options, info), std::invalid_argument);
  Configuration configuration({}, info);
  EXPECT_EQ(configuration.getPersistentManifoldPool()->getMaxCount(), 17);
}

/// A cloth, held at its corners, with a box on it, and a pile of boxes beside it.
TEST(SoftBodyConfiguration, WorldOfSoftAndRigidBodies_Runs) {
  Configuration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(Vec(0, 0, -9.81));
  world.getWorldInfo().m_gravity = Vec(0, 0, -9.81);
  world.getWorldInfo().m_dispatcher = &dispatcher;
  world.getWorldInfo().m_broadphase = &broadphase;
  world.getWorldInfo().m_sparsesdf.Initialize();

  btBoxShape ground(Vec(10, 10, 1)), box(Vec(0.25, 0.25, 0.25));
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  const auto add = [&](btBoxShape& shape, double mass, const btVector3& at) -> btRigidBody& {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(btScalar(mass), inertia);
    bodies.push_back(std::make_unique<btRigidBody>(btScalar(mass), nullptr, &shape, inertia));
    bodies.back()->setWorldTransform(btTransform(btMatrix3x3::getIdentity(), at));
    world.addRigidBody(bodies.back().get());
    return *bodies.back();
  };
  add(ground, 0, Vec(0, 0, -1));
  const btRigidBody& on_cloth = add(box, 0.2, Vec(0, 0, 1.5));
  for (int i = 0; i < 3; ++i) add(box, 1, Vec(4, 0, 0.25 + 0.5 * i));
  btSoftBody* cloth = btSoftBodyHelpers::CreatePatch(world.getWorldInfo(), Vec(-1, -1, 1), Vec(1, -1, 1), Vec(-1, 1, 1),
                                                     Vec(1, 1, 1), 9, 9, 1 + 2 + 4 + 8, true);
  cloth->getCollisionShape()->setMargin(btScalar(0.05));
  world.addSoftBody(cloth);

  for (int i = 0; i < 240; ++i) world.stepSimulation(btScalar(1.0 / 240), 0);
  EXPECT_TRUE(IsFinite(on_cloth.getWorldTransform()));
  EXPECT_GT(double(on_cloth.getWorldTransform().getOrigin().z()), 0.3) << "fell through the cloth";
  EXPECT_NEAR(double(bodies.back()->getWorldTransform().getOrigin().z()), 1.25, 0.01);
  EXPECT_EQ(configuration.statistics().Fallbacks(), 0U);

  world.removeSoftBody(cloth);
  delete cloth;
  for (const auto& body : bodies) world.removeRigidBody(body.get());
}

}  // namespace
}  // namespace dgd_test
