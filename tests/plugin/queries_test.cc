// The narrowphase behind Bullet's other doors: contact tests, compounds, meshes, heightfields and ghosts.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

/// Remembers what a contact test reports, seen so that `first` is A.
class Collector : public btCollisionWorld::ContactResultCallback {
 public:
  explicit Collector(const btCollisionObject& first, double threshold = 0) : first_(first) {
    m_closestDistanceThreshold = btScalar(threshold);
  }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* object_0, int, int,
                           const btCollisionObjectWrapper* object_1, int, int) override {
    const bool swapped = object_0->getCollisionObject() != &first_;
    EXPECT_TRUE(!swapped || object_1->getCollisionObject() == &first_);
    const double sign = swapped ? -1 : 1;
    contacts.push_back({sign * ToEigen(point.m_normalWorldOnB),
                        ToEigen(swapped ? point.getPositionWorldOnA() : point.getPositionWorldOnB()),
                        double(point.getDistance())});
    return 0;
  }

  std::vector<Contact> contacts;

 private:
  const btCollisionObject& first_;
};

class ContactQueries : public testing::TestWithParam<Route> {
 protected:
  btCollisionObject& Object(btCollisionShape& shape, const btTransform& pose) {
    objects_.push_back(std::make_unique<btCollisionObject>());
    objects_.back()->setCollisionShape(&shape);
    objects_.back()->setWorldTransform(pose);
    return *objects_.back();
  }
  std::vector<Contact> PairTest(btCollisionObject& a, btCollisionObject& b, double threshold = 0) {
    Collector collector(a, threshold);
    world_.world().contactPairTest(&a, &b, collector);
    return collector.contacts;
  }

  TestWorld world_{GetParam()};
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

TEST_P(ContactQueries, PairTest_SeesOverlap) {
  btSphereShape sphere(btScalar(0.5));
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  const std::vector<Contact> contacts = PairTest(Object(sphere, At(0, 0, 0.9)), Object(box, At(0, 0, 0)));
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].depth, -0.1, kLength);
  EXPECT_NEAR((contacts[0].on_b - Vector(0, 0, 0.5)).norm(), 0, kLength);
  EXPECT_NEAR((contacts[0].normal_b_to_a - Vector::UnitZ()).norm(), 0, 1e-5);
}

TEST_P(ContactQueries, PairTest_SeesDistancesUpToTheThreshold) {
  btSphereShape sphere(btScalar(0.5));
  btCollisionObject& a = Object(sphere, At(0, 0, 1.8));
  btCollisionObject& b = Object(sphere, At(0, 0, 0));
  EXPECT_TRUE(PairTest(a, b).empty());
  EXPECT_TRUE(PairTest(a, b, 0.5).empty());
  const std::vector<Contact> contacts = PairTest(a, b, 1);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].depth, 0.8, kLength);
  EXPECT_NEAR((contacts[0].on_b - Vector(0, 0, 0.5)).norm(), 0, kLength);
}

// However far an app asks, the depth stays as exact as the bodies.
TEST_P(ContactQueries, PairTest_AWideThresholdCostsNoAccuracy) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  btBoxShape box(Vec(0.5, 0.4, 0.3));
  for (const double tilt : {0.0, 1e-4, 1e-3, 0.01, 0.1}) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(tilt, Vector(1, 0.3, 0).normalized()).toRotationMatrix();
    btCollisionObject& a = Object(*hull, MakeTransform(rotation, {0.05, 0.02, 0.7}));
    btCollisionObject& b = Object(box, At(0, 0, 0));
    for (const double threshold : {0.1, 1.0, 10.0, 1000.0}) {
      SCOPED_TRACE(std::to_string(tilt) + " rad, threshold " + std::to_string(threshold));
      const std::vector<Contact> contacts = PairTest(a, b, threshold);
      ASSERT_FALSE(contacts.empty());
      const Contact& deepest = Deepest(contacts);
      const double separation =
          PlaneSeparation({*hull, a.getWorldTransform()}, {box, b.getWorldTransform()}, deepest.normal_b_to_a);
      EXPECT_NEAR(deepest.depth, separation, 3e-5);
      EXPECT_NEAR(Outside({box, b.getWorldTransform()}, deepest.on_b), 0, 1e-4);
    }
  }
}

// Of bodies that are far apart, the distance of two certain parallel planes between them: never more than the true one,
// and the same but for the turn of the growth distance's normal.
TEST_P(ContactQueries, PairTest_DistanceOfBodiesApartIsASafeOne) {
  std::vector<ZooShape> zoo = MakeShapeZoo(1);
  Random random(TestSeed());
  for (const ZooShape& shape : zoo) {
    SCOPED_TRACE(shape.name);
    btBoxShape box(Vec(0.5, 0.4, 0.3));
    btCollisionObject& a = Object(*shape.shape, MakeTransform(random.Rotation(), {0.9, 0.8, 1}));
    btCollisionObject& b = Object(box, MakeTransform(random.Rotation(), {0, 0, 0}));
    const std::vector<Contact> contacts = PairTest(a, b, 3);
    ASSERT_FALSE(contacts.empty());
    const double exact = DistanceOfShapes({*shape.shape, a.getWorldTransform()}, {box, b.getWorldTransform()}).value;
    EXPECT_LE(Deepest(contacts).depth, exact + 1e-5);
    EXPECT_GE(Deepest(contacts).depth, 0.7 * exact);
  }
}

// Bullet's box-box and plane algorithms ask needsCollision() first and then show nothing of sleeping or filtered pairs.
TEST_P(ContactQueries, PairTest_SeesPairsThatDoNotCollideInTheWorld) {
  auto& box = world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  btRigidBody& a = world_.Add(box, 0, At(0, 0, 0.99));
  btRigidBody& b = world_.Add(box, 0, At(0, 0, 0));
  EXPECT_EQ(PairTest(a, b).size(), 1U) << "two static bodies";
  btRigidBody& c = world_.Add(box, 1, At(0, 0, 0.99));
  btRigidBody& d = world_.Add(box, 1, At(0, 0, 0));
  c.setIgnoreCollisionCheck(&d, true);
  EXPECT_EQ(PairTest(c, d).size(), 1U) << "ignoring each other";
  c.setIgnoreCollisionCheck(&d, false);
  c.forceActivationState(ISLAND_SLEEPING);
  d.forceActivationState(ISLAND_SLEEPING);
  EXPECT_EQ(PairTest(c, d).size(), 1U) << "asleep";
}

TEST_P(ContactQueries, ContactTest_SeesWhatTheBodyTouches) {
  world_.AddGround();
  auto& box = world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  btRigidBody& body = world_.Add(box, 1, At(0, 0, 0.499));
  world_.Add(box, 1, At(3, 0, 0.499));
  world_.Detect();
  Collector collector(body);
  world_.world().contactTest(&body, collector);
  EXPECT_EQ(collector.contacts.size(), 1U);
  for (const Contact& contact : collector.contacts) {
    EXPECT_NEAR(contact.depth, -0.001, kLength);
    EXPECT_NEAR(contact.on_b.z(), 0, kLength);
    EXPECT_NEAR(contact.normal_b_to_a.z(), 1, kLength);
  }
}

TEST_P(ContactQueries, Compound_ItsChildrenTouch) {
  btBoxShape brick(Vec(0.2, 0.2, 0.1)), floor(Vec(5, 5, 1));
  btCompoundShape table;
  table.addChildShape(At(0.5, 0, 0), &brick);
  table.addChildShape(At(-0.5, 0, 0), &brick);
  btCollisionObject& a = Object(table, At(0, 0, 0.099));
  btCollisionObject& b = Object(floor, At(0, 0, -1));
  for (const bool swapped : {false, true}) {
    const std::vector<Contact> contacts = swapped ? PairTest(b, a) : PairTest(a, b);
    EXPECT_EQ(contacts.size(), 2U);
    for (const Contact& contact : contacts) {
      EXPECT_NEAR(contact.depth, -0.001, kLength);
      EXPECT_NEAR(contact.normal_b_to_a.z(), swapped ? -1 : 1, kLength);
    }
  }
  EXPECT_EQ(PairTest(a, b, 0.5).size(), 2U);
}

TEST_P(ContactQueries, Compounds_TheirChildrenTouch) {
  btBoxShape brick(Vec(0.2, 0.2, 0.1));
  btSphereShape ball(btScalar(0.2));
  btCompoundShape bricks, balls;
  bricks.addChildShape(At(0.5, 0, 0), &brick);
  bricks.addChildShape(At(-0.5, 0, 0), &brick);
  balls.addChildShape(At(0.5, 0, 0), &ball);
  balls.addChildShape(At(-0.5, 0, 0.1), &ball);
  const std::vector<Contact> contacts = PairTest(Object(balls, At(0, 0, 0.299)), Object(bricks, At(0, 0, 0)));
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].depth, -0.001, kLength);
  EXPECT_NEAR((contacts[0].on_b - Vector(0.5, 0, 0.1)).norm(), 0, kLength);
  EXPECT_EQ(PairTest(Object(balls, At(0, 0, 0.299)), Object(bricks, At(0, 0, 0)), 0.3).size(), 2U);
}

TEST_P(ContactQueries, Ghost_SeesTheManifoldsOfItsPairs) {
  world_.world().getPairCache()->setInternalGhostPairCallback(&world_.Make<btGhostPairCallback>());
  auto& box = world_.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  auto& ghost = world_.Make<btPairCachingGhostObject>();
  ghost.setCollisionShape(&box);
  ghost.setWorldTransform(At(0.9, 0, 0));
  world_.world().addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger, btBroadphaseProxy::AllFilter);
  world_.Add(box, 1, At(0, 0, 0));
  world_.Detect();
  int points = 0;
  btBroadphasePairArray& pairs = ghost.getOverlappingPairCache()->getOverlappingPairArray();
  ASSERT_EQ(pairs.size(), 1);
  // As the character controller does it: the ghost's own pair cache has no algorithms, the world's has.
  const btBroadphasePair* pair = world_.world().getPairCache()->findPair(pairs[0].m_pProxy0, pairs[0].m_pProxy1);
  ASSERT_NE(pair, nullptr);
  ASSERT_NE(pair->m_algorithm, nullptr);
  btManifoldArray manifolds;
  pair->m_algorithm->getAllContactManifolds(manifolds);
  for (int i = 0; i < manifolds.size(); ++i) points += manifolds[i]->getNumContacts();
  EXPECT_EQ(points, 4);
  world_.world().removeCollisionObject(&ghost);
}

// A world that only detects never steps: a box of one metre was in contact 17 mm before it touched.
TEST_P(ContactQueries, SensorWithoutAStep_IsInContactWhenItOverlaps) {
  btBoxShape slab(Vec(9, 9, 1));
  for (const ZooShape& shape : MakeShapeZoo(1)) {
    SCOPED_TRACE(shape.name);
    PairQuery pair(world_.dispatcher(), *shape.shape, slab);
    pair.body_a().setCollisionFlags(pair.body_a().getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    const double touching = 1 + double(shape.shape->localGetSupportingVertex(Vec(0, 0, 1)).z());
    for (const double gap : {0.01, -0.01}) {
      pair.SetPoses(At(0, 0, 0), At(0, 0, touching + gap));
      EXPECT_EQ(pair.Step(nullptr, 0).empty(), gap > 0) << gap;
    }
    // An app that queries the pair by hand gets what is within its threshold.
    pair.SetPoses(At(0, 0, 0), At(0, 0, touching + 0.01));
    const btCollisionObjectWrapper a(nullptr, shape.shape.get(), &pair.body_a(), pair.body_a().getWorldTransform(), -1,
                                     -1);
    const btCollisionObjectWrapper b(nullptr, &slab, &pair.body_b(), pair.body_b().getWorldTransform(), -1, -1);
    btManifoldResult near(&a, &b);
    near.m_closestPointDistanceThreshold = btScalar(0.02);
    pair.algorithm()->processCollision(&a, &b, btDispatcherInfo(), &near);
    EXPECT_GT(pair.manifold()->getNumContacts(), 0);
  }
}

// Apps take any contact for a collision: boxes and spheres have none before they touch.
TEST_P(ContactQueries, BodiesWithoutAStep_AreInContactWhereTheyAreWithBulletsOwn) {
  Dispatching builtin(Route::kBuiltin);
  btBoxShape slab(Vec(9, 9, 1));
  btSphereShape ball(btScalar(1));
  for (const ZooShape& shape : MakeShapeZoo(1)) {
    for (btConvexShape* other : {static_cast<btConvexShape*>(&slab), static_cast<btConvexShape*>(&ball)}) {
      SCOPED_TRACE(shape.name + " on " + other->getName());
      PairQuery ours(world_.dispatcher(), *shape.shape, *other), theirs(builtin.dispatcher(), *shape.shape, *other);
      const double touching = 1 + double(shape.shape->localGetSupportingVertex(Vec(0, 0, 1)).z());
      for (const double gap : {0.01, -0.01}) {
        for (PairQuery* pair : {&ours, &theirs}) pair->SetPoses(At(0, 0, 0), At(0, 0, touching + gap));
        EXPECT_EQ(ours.Step(nullptr, 0).empty(), theirs.Step(nullptr, 0).empty()) << gap;
      }
    }
  }
}

/// A flat ground of triangles: a grid of 2 x `cells` x `cells` triangles, `width` metres wide, at z = 0.
btBvhTriangleMeshShape& MakeMeshGround(TestWorld& world, int cells, double width) {
  auto& mesh = world.Make<btTriangleMesh>();
  const double step = width / cells;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double x = -width / 2 + i * step, y = -width / 2 + j * step;
      mesh.addTriangle(Vec(x, y, 0), Vec(x + step, y, 0), Vec(x + step, y + step, 0));
      mesh.addTriangle(Vec(x, y, 0), Vec(x + step, y + step, 0), Vec(x, y + step, 0));
    }
  }
  return world.Make<btBvhTriangleMeshShape>(&mesh, true);
}

// Triangles are two-sided, and every convex type meets them, in either order.
TEST_P(ContactQueries, TriangleMesh_EveryTypeIsSeenFromBothSides) {
  btBvhTriangleMeshShape& ground = MakeMeshGround(world_, 4, 8);
  btCollisionObject& mesh = Object(ground, At(0, 0, 0));
  for (const ZooShape& shape : MakeShapeZoo(1)) {
    SCOPED_TRACE(shape.name);
    btVector3 low, high;
    shape.shape->getAabb(btTransform::getIdentity(), low, high);
    const double center = (double(low.z()) + double(high.z())) / 2;
    for (const double side : {0.1, -0.1}) {
      btCollisionObject& body = Object(*shape.shape, At(0.3, 0.1, side - center));
      EXPECT_FALSE(PairTest(body, mesh).empty());
      EXPECT_FALSE(PairTest(mesh, body).empty());
    }
  }
}

/// Drops the usual shapes 5 cm onto a ground at z = 0 whose margin is `margin`, well apart, and expects each to lie
/// upright at its height.
void ExpectRestOnGround(TestWorld& world, double margin, double off_center) {
  const auto prism = MakePrism(6, 0.4, 0.3);
  btSphereShape sphere(btScalar(0.4));
  btBoxShape box(Vec(0.5, 0.4, 0.3));
  btCylinderShapeZ cylinder(Vec(0.4, 0.4, 0.3));
  btCapsuleShapeX capsule(btScalar(0.3), btScalar(0.6));
  struct Case {
    const char* name;
    btConvexShape* shape;
    double height;
    btRigidBody* body = nullptr;
  };
  Case cases[] = {{"sphere", &sphere, 0.4},
                  {"box", &box, 0.3},
                  {"hull", prism.get(), 0.3 + double(prism->getMargin())},
                  {"cylinder", &cylinder, 0.3},
                  {"capsule", &capsule, 0.3}};
  double x = -4;
  for (Case& drop : cases) {
    drop.body = &world.Add(*drop.shape, 1, Vec(x + off_center, x + 0.7 * off_center, drop.height + margin + 0.05));
    drop.body->setRollingFriction(btScalar(0.01));
    x += 2;
  }
  world.Simulate(4);
  x = -4;
  for (const Case& drop : cases) {
    SCOPED_TRACE(drop.name);
    const btTransform& pose = drop.body->getWorldTransform();
    ASSERT_TRUE(IsFinite(pose));
    EXPECT_NEAR(double(pose.getOrigin().z()), drop.height + margin, 0.003);
    EXPECT_NEAR(double(pose.getOrigin().x()), x + off_center, 0.02);
    EXPECT_NEAR(double(pose.getOrigin().y()), x + 0.7 * off_center, 0.02);
    EXPECT_LE(double(drop.body->getLinearVelocity().length()), 0.01);
    EXPECT_LE(double(drop.body->getAngularVelocity().length()), 0.05);
    x += 2;
  }
  for (const Case& drop : cases) world.world().removeRigidBody(drop.body);
}

/// Bullet's own narrowphase is among the routes: what it manages, we must.
class GroundOfTriangles : public testing::TestWithParam<Route> {
 protected:
  TestWorld world_{GetParam()};
};

TEST_P(GroundOfTriangles, TriangleMesh_ShapesComeToRest) {
  world_.Add(MakeMeshGround(world_, 12, 12), 0, Vec(0, 0, 0));
  ExpectRestOnGround(world_, 0, 0.23);
  EXPECT_EQ(world_.statistics().Fallbacks(), 0U);
}

// A floor is often two triangles as wide as the level. The bodies stand beside their common edge, the diagonal.
TEST_P(GroundOfTriangles, HugeTriangles_ShapesComeToRestBesideTheEdge) {
  world_.Add(MakeMeshGround(world_, 1, 200), 0, Vec(0, 0, 0));
  ExpectRestOnGround(world_, 0, 0.23);
  EXPECT_EQ(world_.statistics().Fallbacks(), 0U);
}

TEST_P(GroundOfTriangles, TriangleMeshWithMargin_ShapesComeToRest) {
  // Less than the breaking threshold: Bullet's early-out looks at the triangle without its margin (bullet3 issue 4263).
  btBvhTriangleMeshShape& ground = MakeMeshGround(world_, 12, 12);
  ground.setMargin(btScalar(0.002));
  world_.Add(ground, 0, Vec(0, 0, 0));
  ExpectRestOnGround(world_, 0.002, 0.23);
}

TEST_P(GroundOfTriangles, Heightfield_ShapesComeToRest) {
  constexpr int kSamples = 13;
  // In either precision Bullet reads what it calls PHY_FLOAT as its own scalar.
  std::vector<btScalar> heights(static_cast<std::size_t>(kSamples) * kSamples, 0);
  auto& field = world_.Make<btHeightfieldTerrainShape>(kSamples, kSamples, heights.data(), btScalar(1), btScalar(-1),
                                                       btScalar(1), 2, PHY_FLOAT, false);
  btRigidBody& ground = world_.Add(field, 0, Vec(0, 0, 0));
  ExpectRestOnGround(world_, 0, 0.23);
  world_.world().removeRigidBody(&ground);
}

INSTANTIATE_TEST_SUITE_P(Routes, ContactQueries, testing::Values(Route::kConfiguration, Route::kRegister),
                         [](const testing::TestParamInfo<Route>& route) { return Name(route.param); });

INSTANTIATE_TEST_SUITE_P(Routes, GroundOfTriangles,
                         testing::Values(Route::kConfiguration, Route::kRegister, Route::kBuiltin),
                         [](const testing::TestParamInfo<Route>& route) { return Name(route.param); });

}  // namespace
}  // namespace dgd_test
