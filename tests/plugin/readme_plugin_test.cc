// The snippets of the plugin's README, word for word, and what they should give.
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dgd_bullet/collision_configuration.h"
#include "dgd_bullet/collision_dispatcher.h"
#include "dgd_bullet/convex_cast.h"
#include "dgd_bullet/register.h"
#include "support/readme_snippets.h"

namespace {

/// Two cubes, the upper one a millimetre deep in the lower: how many contact points they get.
int ContactsOfTwoCubes(btCollisionDispatcher& dispatcher, btCollisionConfiguration& configuration) {
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btBoxShape cube(btVector3(1, 1, 1));
  btCollisionObject lower, upper;
  lower.setCollisionShape(&cube);
  upper.setCollisionShape(&cube);
  upper.getWorldTransform().setOrigin(btVector3(0, 0, btScalar(1.999)));
  world.addCollisionObject(&lower);
  world.addCollisionObject(&upper);
  world.performDiscreteCollisionDetection();
  int contacts = 0;
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    contacts += dispatcher.getManifoldByIndexInternal(i)->getNumContacts();
  }
  world.removeCollisionObject(&lower);
  world.removeCollisionObject(&upper);
  return contacts;
}

TEST(ReadmePlugin, OneLine_ReplacesTheConfiguration) {
  dgd_bullet::CollisionConfiguration configuration;  // was: btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  EXPECT_EQ(ContactsOfTwoCubes(dispatcher, configuration), 4);
}

TEST(ReadmePlugin, TwoThreads_GiveTheSameContacts) {
  dgd_bullet::CollisionConfiguration configuration;
  dgd_bullet::DispatcherOptions dispatching;
  dispatching.threads = 2;
  dgd_bullet::CollisionDispatcher dispatcher(&configuration, dispatching);  // was: btCollisionDispatcher
  EXPECT_EQ(ContactsOfTwoCubes(dispatcher, configuration), 4);
}

TEST(ReadmePlugin, LivingDispatcher_IsRegisteredOn) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  dgd_bullet::Register(dispatcher);  // pairs that overlap already keep their algorithm until they part
  EXPECT_EQ(ContactsOfTwoCubes(dispatcher, configuration), 4);
}

TEST(ReadmePlugin, AnotherConfiguration_IsAsGood) {
  dgd_bullet::CollisionConfigurationOf<btSoftBodyRigidBodyCollisionConfiguration> configuration;
  btCollisionDispatcher dispatcher(&configuration);
  EXPECT_EQ(ContactsOfTwoCubes(dispatcher, configuration), 4);
}

TEST(ReadmePlugin, Cast_FindsTheImpact) {
  btCapsuleShapeX rod(btScalar(0.1), 2);
  btSphereShape ball(btScalar(0.2));
  btTransform from_rod = btTransform::getIdentity(), to_rod = from_rod, from_ball = from_rod, to_ball = from_rod;
  to_rod.setRotation(btQuaternion(btVector3(0, 0, 1), SIMD_HALF_PI));
  from_ball.setOrigin(btVector3(0, btScalar(0.8), 0));
  to_ball = from_ball;

  dgd_bullet::ConvexCast cast(&rod, &ball);  // was: btContinuousConvexCollision, with two solvers more
  btConvexCast::CastResult result;
  const bool hits = cast.calcTimeOfImpact(from_rod, to_rod, from_ball, to_ball, result);

  ASSERT_TRUE(hits);
  EXPECT_NEAR(double(result.m_fraction), 1 - std::asin(0.3 / 0.8) / double(SIMD_HALF_PI), 1e-6);
}

/// Snippets name their files without a folder: a new one for this precision.
void MoveToEmptyFolder() {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("dgd_readme_" + std::to_string(sizeof(btScalar)));
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
}

TEST(ReadmePlugin, Statistics_AreWrittenAsJson) {
  dgd_bullet::Options options;
  options.count_pairs = true;
  dgd_bullet::CollisionConfiguration configuration(options);
  btCollisionDispatcher dispatcher(&configuration);
  ContactsOfTwoCubes(dispatcher, configuration);
  MoveToEmptyFolder();

  std::ofstream("pairs.json") << dgd_bullet::ToJson(configuration.statistics());

  EXPECT_EQ(nlohmann::json::parse(std::ifstream("pairs.json"))["pairs"][0]["calls"], 1);
}

TEST(ReadmePlugin, Snippets_AreTheseWordForWord) {
  const std::string root = DGD_TEST_ROOT;
  const std::vector<std::string> sources = {root + "/tests/plugin/readme_plugin_test.cc",
                                            root + "/tests/plugin/recorder_test.cc"};
  EXPECT_EQ(dgd_test::ExpectSnippetsIn(root + "/bullet_plugin/README.md", sources), 7);
  EXPECT_EQ(dgd_test::ExpectSnippetsIn(root + "/README.md", sources), 1);
}

}  // namespace
