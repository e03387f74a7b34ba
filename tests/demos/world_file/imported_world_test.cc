// Contract: a world that Bullet's serializer wrote is read back to the last bit, with all its constraints, and
// simulated by every narrowphase; none loses a body that Bullet's own keeps. The worlds are made without the project's
// code.
#include "world_file/imported_world.h"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "simulation/bullet_math.h"
#include "simulation/drop_run.h"
#include "world_file/bullet_worlds.h"

namespace dgd_demos {
namespace {

constexpr double kDuration = 2;  // s

std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const auto& world_case : dgd_test::AllWorldCases()) names.push_back(world_case.name);
  return names;
}

class WorldFileTest : public testing::TestWithParam<std::string> {
 protected:
  ImportedWorld Load(Narrowphase narrowphase) {
    return ImportedWorld(LoadWorldBytes(GetParam(), original_->Serialize()), narrowphase);
  }
  std::unique_ptr<dgd_test::BulletWorld> original_ = dgd_test::MakeWorld(GetParam());
};

void ExpectSameBody(const btRigidBody& original, const btRigidBody& read) {
  const Pose saved = FromBullet(original.getWorldTransform()), loaded = FromBullet(read.getWorldTransform());
  EXPECT_EQ(saved.position, loaded.position);
  EXPECT_EQ(saved.rotation, loaded.rotation);
  EXPECT_EQ(FromBullet(original.getLinearVelocity()), FromBullet(read.getLinearVelocity()));
  EXPECT_EQ(FromBullet(original.getAngularVelocity()), FromBullet(read.getAngularVelocity()));
  EXPECT_EQ(FromBullet(original.getInvInertiaDiagLocal()), FromBullet(read.getInvInertiaDiagLocal()));
  EXPECT_EQ(FromBullet(original.getGravity()), FromBullet(read.getGravity()));
  // The importer takes the reciprocal of the stored reciprocal.
  EXPECT_NEAR(read.getMass(), original.getMass(), 1e-6 * original.getMass());
  EXPECT_EQ(original.getLinearDamping(), read.getLinearDamping());
  EXPECT_EQ(original.getFriction(), read.getFriction());
  EXPECT_EQ(original.getActivationState(), read.getActivationState());
  EXPECT_EQ(original.getBroadphaseProxy()->m_collisionFilterGroup, read.getBroadphaseProxy()->m_collisionFilterGroup);
  EXPECT_EQ(original.getBroadphaseProxy()->m_collisionFilterMask, read.getBroadphaseProxy()->m_collisionFilterMask);
  EXPECT_EQ(original.getCollisionShape()->getShapeType(), read.getCollisionShape()->getShapeType());
  btVector3 min_a, max_a, min_b, max_b;
  original.getAabb(min_a, max_a);
  read.getAabb(min_b, max_b);
  // Files have shapes in float.
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(min_a[k], min_b[k], 1e-5 * (1 + std::abs(min_a[k])));
    EXPECT_NEAR(max_a[k], max_b[k], 1e-5 * (1 + std::abs(max_a[k])));
  }
}

TEST_P(WorldFileTest, Read_IsAsItWasWritten) {
  ImportedWorld world = Load(Narrowphase::kDgd);
  btDiscreteDynamicsWorld& original = original_->world();
  auto& read = static_cast<btDiscreteDynamicsWorld&>(world.Bullet());
  EXPECT_EQ(world.ConstraintCount(), original.getNumConstraints());
  EXPECT_EQ(read.getNumCollisionObjects(), original.getNumCollisionObjects());
  EXPECT_EQ(FromBullet(read.getGravity()), FromBullet(original.getGravity()));
  EXPECT_EQ(read.getSolverInfo().m_numIterations, original.getSolverInfo().m_numIterations);
  EXPECT_EQ(world.time_step(), double(original.getSolverInfo().m_timeStep));

  const std::vector<const btRigidBody*> bodies = original_->Bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    SCOPED_TRACE(world.Bodies()[i].name);
    ExpectSameBody(*bodies[i], *btRigidBody::upcast(read.getCollisionObjectArray()[static_cast<int>(i)]));
  }
}

TEST_P(WorldFileTest, TwoSeconds_NoBodyIsLostThatTheBuiltinKeeps) {
  ImportedWorld builtin = Load(Narrowphase::kBuiltin), dgd = Load(Narrowphase::kDgd);
  const auto run = [](ImportedWorld& world) { return RunWorld(world, {kDuration, 20}, [](const StepRecord&) {}); };
  const DropRun with_builtin = run(builtin), with_dgd = run(dgd);
  ASSERT_FALSE(with_builtin.failure) << *with_builtin.failure;
  EXPECT_FALSE(with_dgd.failure) << *with_dgd.failure;
  EXPECT_EQ(with_dgd.summary.steps, 480);
  EXPECT_GT(with_dgd.summary.contacts, 0u);
  const bool has_mesh = GetParam().find("terrain") != std::string::npos;
  EXPECT_EQ(with_dgd.summary.unjudged_pairs > 0, has_mesh || GetParam() == "primitives");
  std::printf("%-15s true penetration at worst: builtin %.4f m, dgd %.4f m\n", GetParam().c_str(),
              with_builtin.summary.deepest_true, with_dgd.summary.deepest_true);
}

INSTANTIATE_TEST_SUITE_P(Worlds, WorldFileTest, testing::ValuesIn(Names()),
                         [](const auto& test) { return test.param; });

// The original goes on as the world that was read from its file does, by Bullet's own narrowphase, for a hundred steps:
// nothing of a body was left out that moves it. What falls freely does so to roundoff of the mass.
TEST(ImportedWorldTest, MultibodyChain_SwingsAsTheOriginal) {
  auto original = dgd_test::MakeWorld("chain");
  ImportedWorld read(LoadWorldBytes("chain", original->Serialize()), Narrowphase::kBuiltin);
  const Energy at_start = read.TotalEnergy();
  EXPECT_GT(at_start.kinetic, 0);
  for (int step = 0; step < 100; ++step) {
    original->world().stepSimulation(btScalar(read.time_step()), 0);
    read.Step();
  }
  btMultiBodyDynamicsWorld& first = original->multibody_world();
  auto& second = static_cast<btMultiBodyDynamicsWorld&>(read.Bullet());
  ASSERT_EQ(second.getNumMultibodies(), first.getNumMultibodies());
  for (int i = 0; i < first.getNumMultibodies(); ++i) {
    for (int link = 0; link < first.getMultiBody(i)->getNumLinks(); ++link) {
      const auto place = [&](btMultiBodyDynamicsWorld& world) {
        return FromBullet(world.getMultiBody(i)->getLink(link).m_cachedWorldTransform.getOrigin());
      };
      EXPECT_LT((place(first) - place(second)).norm(), 1e-4) << "multibody " << i << ", link " << link;
    }
  }
}

TEST(ImportedWorldTest, ShapesThatTheImporterDoesNotMake_AreRemarked) {
  auto original = dgd_test::MakeFallingSphere();
  auto& triangle = original->Make<btTriangleShape>(btVector3(0, 0, 0), btVector3(1, 0, 0), btVector3(0, 1, 0));
  original->Add(triangle, 1, btVector3(5, 0, 0));
  btRigidBody& hanging = original->Add(triangle, 1, btVector3(9, 0, 0));
  original->Join(std::make_unique<btPoint2PointConstraint>(hanging, btVector3(0, 0, 0)));
  ImportedWorld read(LoadWorldBytes("triangles", original->Serialize()), Narrowphase::kDgd);
  EXPECT_EQ(read.Bodies().size(), 1u);
  EXPECT_EQ(read.ConstraintCount(), 0);
  ASSERT_EQ(read.Remarks().size(), 2u);
  EXPECT_EQ(read.Remarks()[0],
            "Bullet's importer does not make these shapes: 1 triangle; without them, 2 bodies are left out.");
  EXPECT_EQ(read.Remarks()[1], "1 constraint is left out, which has a body that is not restored.");
}

TEST(ImportedWorldTest, ContactManifolds_AreRemarked) {
  auto original = dgd_test::MakeWorld("boxes");
  for (int i = 0; i < 100; ++i) original->world().stepSimulation(btScalar(1) / 240, 0);
  ImportedWorld read(LoadWorldBytes("boxes", original->Serialize(BT_SERIALIZE_CONTACT_MANIFOLDS)), Narrowphase::kDgd);
  ASSERT_EQ(read.Remarks().size(), 1u);
  EXPECT_NE(read.Remarks()[0].find("contact manifold"), std::string::npos);
}

TEST(ImportedWorldTest, BodyThatFallsForever_IsLost) {
  ImportedWorld read(LoadWorldBytes("sphere", dgd_test::MakeFallingSphere()->Serialize()), Narrowphase::kDgd, 0.01);
  const DropRun run = RunWorld(read, {10, 1}, [](const StepRecord&) {});
  ASSERT_TRUE(run.failure);
  EXPECT_NE(run.failure->find("body 0 left the world"), std::string::npos) << *run.failure;
}

}  // namespace
}  // namespace dgd_demos
