// Compounds against what their children do as bodies of their own, and against Bullet's contract of their contacts.
#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <new>
#include <set>
#include <utility>
#include <vector>

#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "plugin/triangle_grid.h"

namespace dgd_test {
namespace {

using Indices = std::set<std::pair<int, int>>;

class Compounds : public testing::TestWithParam<Route> {
 protected:
  btCompoundShape& MakeCompound(bool has_tree = true) { return world_.Make<btCompoundShape>(has_tree); }
  btBoxShape& MakeBox(double x, double y, double z) { return world_.Make<btBoxShape>(Vec(x, y, z)); }

  /// A compound of `count` cubes of 0.2 m in a row along x, 0.3 m apart.
  btCompoundShape& MakeRow(int count, bool has_tree = true) {
    btCompoundShape& row = MakeCompound(has_tree);
    for (int i = 0; i < count; ++i) row.addChildShape(At(0.3 * i, 0, 0), &MakeBox(0.1, 0.1, 0.1));
    return row;
  }

  /// The children that all contacts name.
  Indices ChildrenInContact() {
    Indices children;
    for (const btManifoldPoint& point : world_.Points()) children.emplace(point.m_index0, point.m_index1);
    return children;
  }

  TestWorld world_{GetParam()};
};

/// Where a body is after it was thrown down at a plate or at thin ground below the origin, from the height of 1 m.
struct Throw {
  double speed;    // m/s
  int children;    // 0 for a shape that is no compound.
  bool is_long;    // Whether the children are far apart.
  bool is_nested;  // Whether the compound is a child of another one.
};

double HeightAfter(Route route, const Throw& it, btCollisionShape& ground, double phase) {
  TestWorld world(route);
  world.Add(ground, 0, Vec(0, 0, 0));
  auto& cube = world.Make<btBoxShape>(Vec(0.1, 0.1, 0.1));
  auto &compound = world.Make<btCompoundShape>(), &outer = world.Make<btCompoundShape>();
  for (int i = 0; i < it.children; ++i) compound.addChildShape(At((it.is_long ? 0.9 : 0.15) * i, 0, 0), &cube);
  outer.addChildShape(At(0, 0, 0), &compound);
  btCollisionShape* shape = &cube;
  if (it.children > 0) shape = it.is_nested ? &outer : &compound;
  btRigidBody& body = world.Add(*shape, 1, Vec(0.03, 0.04, 1 + phase * it.speed * TestWorld::kTimeStep));
  body.setLinearVelocity(Vec(0, 0, -it.speed));
  if (it.is_long) body.setAngularVelocity(Vec(0, 30, 0));
  world.Simulate(1.5 / it.speed + 0.1);
  return double(body.getWorldTransform().getOrigin().z());
}

// No compound passes what its child alone does not.
TEST(FastCompound, AgainstThinGround_NeverPasses) {
  btBoxShape plate(Vec(4, 4, 0.005)), half(Vec(2, 4, 0.005));
  btCompoundShape halves;
  halves.addChildShape(At(-2, 0, 0), &half);
  halves.addChildShape(At(2, 0, 0), &half);
  btTriangleMesh triangles;
  AddGrid(triangles, 8, 1, [](double, double) { return 0; });
  btBvhTriangleMeshShape mesh(&triangles, true);
  mesh.setMargin(0);
  int passed = 0, passed_builtin = 0;
  for (btCollisionShape* ground : {static_cast<btCollisionShape*>(&plate), static_cast<btCollisionShape*>(&halves),
                                   static_cast<btCollisionShape*>(&mesh)}) {
    for (const Throw& it : {Throw{60, 1, false, false}, Throw{60, 2, false, false}, Throw{250, 1, false, false},
                            Throw{250, 3, false, true}, Throw{100, 2, true, false}, Throw{250, 0, false, false}}) {
      for (const double phase : {0.1, 0.5, 0.7}) {
        passed += HeightAfter(Route::kConfiguration, it, *ground, phase) < 0 ? 1 : 0;
        passed_builtin += HeightAfter(Route::kBuiltin, it, *ground, phase) < 0 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(passed, 0);
  EXPECT_GT(passed_builtin, 20);
}

int started = 0, ended = 0;

// Bullet's own algorithm drops a child's contacts when bounding boxes part by a rounding.
TEST(CompoundAtRest, ItsContactsStartOnceAndDoNotEnd) {
  started = ended = 0;
  gContactStartedCallback = [](btPersistentManifold* const&) { ++started; };
  gContactEndedCallback = [](btPersistentManifold* const&) { ++ended; };
  {
    TestWorld world(Route::kConfiguration);
    world.AddGround();
    auto& table = world.Make<btCompoundShape>();
    auto& leg = world.Make<btBoxShape>(Vec(0.05, 0.05, 0.3));
    for (const double x : {-0.4, 0.4}) {
      for (const double y : {-0.4, 0.4}) table.addChildShape(At(x, y, 0), &leg);
    }
    world.Add(table, 10, Vec(0, 0, 0.31));
    world.Simulate(3);
    EXPECT_EQ(started, 4);
    EXPECT_EQ(ended, 0);
    EXPECT_EQ(world.Points().size(), 16U);
    gContactStartedCallback = nullptr;
    gContactEndedCallback = nullptr;
  }
}

TEST_P(Compounds, Contacts_NameTheChildrenInTouch) {
  for (const bool has_tree : {true, false}) {
    TestWorld world(GetParam());
    auto& brick = world.Make<btBoxShape>(Vec(0.1, 0.1, 0.1));
    auto &row = world.Make<btCompoundShape>(has_tree), &column = world.Make<btCompoundShape>(has_tree);
    for (int i = 0; i < 3; ++i) {
      row.addChildShape(At(0.3 * i, 0, 0), &brick);
      column.addChildShape(At(0, 0, 0.3 * i), &brick);
    }
    world.Add(row, 0, Vec(0, 0, 0));
    world.Add(column, 1, Vec(0.6, 0, 0.199));
    world.Detect();
    ASSERT_EQ(world.Points().size(), 4U);
    for (const btManifoldPoint& point : world.Points()) {
      EXPECT_EQ(std::min(point.m_index0, point.m_index1), 0);
      EXPECT_EQ(std::max(point.m_index0, point.m_index1), 2);
      EXPECT_NEAR(double(point.getDistance()), -0.001, kLength);
    }
  }
}

TEST_P(Compounds, OnABox_ContactsNameTheChild) {
  world_.AddGround();
  world_.Add(MakeRow(3), 1, Vec(0, 0, 0.099));
  world_.Detect();
  // The child comes first, whichever body Bullet names first.
  EXPECT_EQ(ChildrenInContact(), (Indices{{0, -1}, {1, -1}, {2, -1}}));
}

TEST_P(Compounds, ChildrenAddedMovedAndRemovedInContact_AreFollowed) {
  for (const bool has_tree : {true, false}) {
    TestWorld world(GetParam());
    world.AddGround();
    auto& brick = world.Make<btBoxShape>(Vec(0.1, 0.1, 0.1));
    auto& row = world.Make<btCompoundShape>(has_tree);
    row.addChildShape(At(0, 0, 0), &brick);
    btRigidBody& body = world.Add(row, 1, Vec(0, 0, 0.099));
    const auto points = [&] {
      world.world().updateSingleAabb(&body);
      world.Detect();
      return world.Points().size();
    };
    EXPECT_EQ(points(), 4U);
    row.addChildShape(At(0.5, 0, 0), &brick);
    row.addChildShape(At(1, 0, 0), &brick);
    EXPECT_EQ(points(), 12U);
    row.updateChildTransform(1, At(0.5, 0, 1));
    EXPECT_EQ(points(), 8U);
    row.removeChildShapeByIndex(0);
    EXPECT_EQ(points(), 4U);
    while (row.getNumChildShapes() > 0) row.removeChildShapeByIndex(0);
    EXPECT_EQ(points(), 0U);
    row.addChildShape(At(0, 0, 0), &world.Make<btSphereShape>(btScalar(0.1)));
    EXPECT_EQ(points(), 1U);
  }
}

// The same index, but another shape: nothing of the old pair may be taken for the new one's.
TEST_P(Compounds, ExchangedForAnotherCompound_IsFollowed) {
  world_.AddGround();
  btCompoundShape &boxes = MakeCompound(), &meshes = MakeCompound();
  boxes.addChildShape(At(0, 0, 0), &MakeBox(0.1, 0.1, 0.1));
  auto& inner = MakeCompound();
  inner.addChildShape(At(0, 0, 0), &world_.Make<btSphereShape>(btScalar(0.1)));
  meshes.addChildShape(At(0, 0, 0), &inner);
  btRigidBody& body = world_.Add(boxes, 1, Vec(0, 0, 0.099));
  world_.Detect();
  EXPECT_EQ(world_.Points().size(), 4U);
  if (GetParam() == Route::kBuiltin) return;  // Its algorithm counts changes, and both compounds have had one.
  body.setCollisionShape(&meshes);
  world_.Detect();
  EXPECT_EQ(world_.Points().size(), 1U);
  body.setCollisionShape(boxes.getChildShape(0));
  world_.Detect();
  EXPECT_EQ(world_.Points().size(), 4U);
  body.setCollisionShape(&boxes);
  world_.Detect();
  EXPECT_EQ(world_.Points().size(), 4U);
}

// As Bullet allocates nothing else, an app's allocator need not align to more than eight bytes.
TEST_P(Compounds, InMemoryAlignedToEightBytes_Touch) {
  world_.AddGround();
  auto& memory = world_.Make<std::array<std::max_align_t, sizeof(btRigidBody) / sizeof(std::max_align_t) + 2>>();
  btCompoundShape& row = MakeRow(2);
  void* place = reinterpret_cast<char*>(memory.data()) + 8;
  const btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &row, Vec(1, 1, 1));
  btRigidBody& body = *new (place) btRigidBody(info);
  body.setWorldTransform(At(0, 0, 0.099));
  world_.world().addRigidBody(&body);
  world_.Detect();
  EXPECT_EQ(world_.Points().size(), 8U);
  world_.world().removeRigidBody(&body);
  body.~btRigidBody();
}

const btCollisionShape* excluded = nullptr;
bool IsNotExcluded(const btCollisionShape* a, const btCollisionShape* b) { return a != excluded && b != excluded; }

TEST_P(Compounds, AppsCallbacks_ExcludePairsOfChildren) {
  btCompoundShape& row = MakeRow(3);
  excluded = row.getChildShape(1);
  gCompoundChildShapePairCallback = gCompoundCompoundChildShapePairCallback = IsNotExcluded;
  for (btCollisionShape* ground :
       {static_cast<btCollisionShape*>(&MakeRow(3)), static_cast<btCollisionShape*>(&MakeBox(1, 0.1, 0.1))}) {
    TestWorld world(GetParam());
    world.Add(*ground, 0, Vec(0, 0, 0));
    world.Add(row, 1, Vec(0, 0, 0.199));
    world.Detect();
    EXPECT_EQ(world.Points().size(), 8U) << ground->getName();
  }
  gCompoundChildShapePairCallback = gCompoundCompoundChildShapePairCallback = nullptr;
}

TEST_P(Compounds, Nested_InnermostChildrenTouch) {
  world_.AddGround();
  btCompoundShape& outer = MakeCompound();
  outer.addChildShape(At(0, 0, 0), &MakeRow(2));
  outer.addChildShape(At(0, 0.5, 0), &MakeRow(2, false));
  world_.Add(outer, 1, Vec(0, 0, 0.099));
  world_.Detect();
  EXPECT_EQ(world_.Points().size(), 16U);
}

TEST_P(Compounds, OnPlaneMeshAndCompound_AllChildrenTouch) {
  auto& plane = world_.Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0));
  auto& triangles = world_.Make<btTriangleMesh>();
  AddGrid(triangles, 8, 1, [](double, double) { return 0; });
  auto& mesh = world_.Make<btBvhTriangleMeshShape>(&triangles, true);
  mesh.setMargin(0);
  auto& slabs = MakeCompound();
  slabs.addChildShape(At(0, 0, -0.5), &MakeBox(5, 5, 0.5));
  for (btCollisionShape* ground : {static_cast<btCollisionShape*>(&plane), static_cast<btCollisionShape*>(&mesh),
                                   static_cast<btCollisionShape*>(&slabs)}) {
    TestWorld world(GetParam());
    world.Add(*ground, 0, Vec(0, 0, 0));
    world.Add(MakeRow(3), 1, Vec(0.03, 0.04, 0.099));
    for (int step = 0; step < 4; ++step) world.Detect();  // The built-in adds a point to a plane's pair in each.
    std::set<int> children;
    const bool is_first = !ground->isCompound();  // Of two compounds, the body that was added first is.
    for (const btManifoldPoint& point : world.Points()) children.insert(is_first ? point.m_index0 : point.m_index1);
    EXPECT_EQ(children, (std::set<int>{0, 1, 2})) << ground->getName();
  }
}

INSTANTIATE_TEST_SUITE_P(Plugin, Compounds, testing::Values(Route::kConfiguration, Route::kRegister, Route::kBuiltin),
                         [](const auto& test) { return Name(test.param); });

}  // namespace
}  // namespace dgd_test
