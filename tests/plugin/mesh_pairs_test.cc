// What is kept of triangles from step to step: the answers are those of new ones.
#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "plugin/fallback_fixture.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "plugin/triangle_grid.h"

namespace dgd_test {
namespace {

/// Counts the algorithms that it gives memory to.
class CountingDispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  void* allocateCollisionAlgorithm(int size) override {
    ++living_;
    ++made_;
    return btCollisionDispatcher::allocateCollisionAlgorithm(size);
  }
  void freeCollisionAlgorithm(void* algorithm) override {
    --living_;
    btCollisionDispatcher::freeCollisionAlgorithm(algorithm);
  }
  int living() const { return living_; }
  int made() const { return made_; }

 private:
  int living_ = 0, made_ = 0;
};

/// A body and a mesh in a world's place of them: the algorithm lives as long as this.
class MeshPair {
 public:
  MeshPair(btCollisionDispatcher& dispatcher, btCollisionObject& body, btCollisionObject& mesh, bool is_mesh_first)
      : dispatcher_(dispatcher), objects_{&body, &mesh} {
    if (is_mesh_first) std::swap(objects_[0], objects_[1]);
    const btCollisionObjectWrapper first = Wrap(0), second = Wrap(1);
    algorithm_ = dispatcher_.findAlgorithm(&first, &second, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    // Of points within it, Bullet keeps one; and on parallel edges any point is as good as another.
    Manifold().setContactBreakingThreshold(btScalar(1e-4));
  }
  ~MeshPair() {
    algorithm_->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm_);
  }
  MeshPair(const MeshPair&) = delete;
  MeshPair& operator=(const MeshPair&) = delete;

  /// The contacts of this step alone.
  const btPersistentManifold& Step() {
    Manifold().clearManifold();
    const btCollisionObjectWrapper first = Wrap(0), second = Wrap(1);
    btManifoldResult result(&first, &second);
    algorithm_->processCollision(&first, &second, btDispatcherInfo(), &result);
    // What a mesh shows in its place, it takes back.
    EXPECT_EQ(result.getBody0Wrap(), &first);
    EXPECT_EQ(result.getBody1Wrap(), &second);
    return Manifold();
  }

 private:
  btPersistentManifold& Manifold() {
    btManifoldArray manifolds;
    algorithm_->getAllContactManifolds(manifolds);
    return *manifolds[0];
  }

  btCollisionObjectWrapper Wrap(int i) const {
    btCollisionObject& object = *objects_[std::size_t(i)];
    return {nullptr, object.getCollisionShape(), &object, object.getWorldTransform(), -1, -1};
  }

  btCollisionDispatcher& dispatcher_;
  std::array<btCollisionObject*, 2> objects_;
  btCollisionAlgorithm* algorithm_;
};

double LeastDistance(const btPersistentManifold& manifold) {
  double least = 1;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    least = std::min(least, double(manifold.getContactPoint(i).getDistance()));
  }
  return least;
}

class MeshPairs : public testing::Test {
 protected:
  static constexpr int kCells = 40;
  static constexpr double kPitch = 0.3, kBump = 0.1;
  static constexpr double kTouching = 0.45, kDeep = 0.28;  // For bodies 0.9 m across.

  MeshPairs() {
    AddGrid(triangles_, kCells, kPitch, Height);
    mesh_shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
    mesh_.setCollisionShape(mesh_shape_.get());
  }

  static double Height(double x, double y) { return kBump * std::sin(2 * x) * std::cos(2.5 * y); }

  /// On its way over the mesh, turning.
  /// @param height  Over the mesh, metres.
  static btTransform Place(int step, double height = kTouching) {
    const double x = -2 + 0.02 * step, y = 0.4 * std::sin(0.1 * step);
    const btQuaternion turn(Vec(0.6, 0, 0.8), btScalar(0.05 * step));
    return btTransform(turn, Vec(x, y, height + Height(x, y) + 0.05 * std::sin(0.3 * step)));
  }

  /// Whether what is kept answers as what is new, on the way over the mesh.
  /// @param change  Called before each step, with its number.
  template <class Change>
  void ExpectAnswersOfNewOnes(btConvexShape& shape, const Change& change) {
    constexpr int kSteps = 60;
    btCollisionObject body;
    body.setCollisionShape(&shape);
    for (const bool is_mesh_first : {false, true}) {
      MeshPair kept(dispatcher_, body, mesh_, is_mesh_first);
      int touching = 0;
      for (int step = 0; step < kSteps; ++step) {
        SCOPED_TRACE(step);
        body.setWorldTransform(Place(step, kDeep));
        change(step, body);
        const btPersistentManifold& manifold = kept.Step();
        MeshPair fresh(dispatcher_, body, mesh_, is_mesh_first);
        const btPersistentManifold& expected = fresh.Step();
        ASSERT_EQ(manifold.getBody0(), expected.getBody0());
        ASSERT_EQ(manifold.getNumContacts() > 0, expected.getNumContacts() > 0);
        // Deep inside curved shapes, a search may end where a normal nearby is a little better.
        const double least = LeastDistance(expected);
        ASSERT_NEAR(LeastDistance(manifold), least, kLength + 1e-3 * std::abs(least));
        touching += manifold.getNumContacts() > 0;
      }
      EXPECT_GT(touching, kSteps / 10);
    }
  }
  void ExpectAnswersOfNewOnes(btConvexShape& shape) {
    ExpectAnswersOfNewOnes(shape, [](int, btCollisionObject&) {});
  }

  dgd_bullet::CollisionConfiguration configuration_{Counting()};
  CountingDispatcher dispatcher_{&configuration_};
  btTriangleMesh triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> mesh_shape_;
  btCollisionObject mesh_;
};

TEST_F(MeshPairs, EveryType_AnswersOfNewOnes) {
  for (const ZooShape& shape : MakeShapeZoo(0.9)) {
    SCOPED_TRACE(shape.name);
    ExpectAnswersOfNewOnes(*shape.shape);
  }
}

// Both triangles of a square of Bullet's heightfield have one name.
TEST_F(MeshPairs, Heightfield_AnswersOfNewOnes) {
  constexpr int kPoints = 31;
  // In either precision Bullet reads what it calls PHY_FLOAT as its own scalar.
  std::vector<btScalar> heights(kPoints * kPoints);
  for (int j = 0; j < kPoints; ++j) {
    for (int i = 0; i < kPoints; ++i) {
      heights[std::size_t(j * kPoints + i)] =
          btScalar(Height(kPitch * (i - (kPoints - 1) / 2.0), kPitch * (j - (kPoints - 1) / 2.0)));
    }
  }
  // Its other constructor takes PHY_FLOAT for the library's own precision.
  btHeightfieldTerrainShape terrain(kPoints, kPoints, heights.data(), btScalar(-1), btScalar(1), 2, false);
  terrain.setLocalScaling(Vec(kPitch, kPitch, 1));
  mesh_.setCollisionShape(&terrain);
  btBoxShape box(Vec(0.4, 0.35, 0.45));
  ExpectAnswersOfNewOnes(box);
}

TEST_F(MeshPairs, MeshMovesUnderItsTriangles_AnswersOfNewOnes) {
  btCylinderShape cylinder(Vec(0.4, 0.45, 0.4));
  unsigned char* vertices = nullptr;
  int count = 0, stride = 0, faces = 0, face_stride = 0;
  unsigned char* faces_at = nullptr;
  PHY_ScalarType scalar, index;
  triangles_.getLockedVertexIndexBase(&vertices, count, scalar, stride, &faces_at, face_stride, faces, index, 0);
  ExpectAnswersOfNewOnes(cylinder, [&](int step, btCollisionObject&) {
    const double wave = 0.05 * (step % 2 == 0 ? 1 : -1);
    for (int i = 0; i < count; ++i) {
      auto& vertex = *reinterpret_cast<btScalar(*)[3]>(vertices + std::size_t(i) * std::size_t(stride));
      vertex[2] = btScalar(Height(double(vertex[0]), double(vertex[1])) + wave * std::sin(3 * double(vertex[0])));
    }
    mesh_shape_->refitTree(Vec(-10, -10, -1), Vec(10, 10, 1));
  });
  triangles_.unLockVertexBase(0);
}

TEST_F(MeshPairs, BodyChangesItsShape_AnswersOfNewOnes) {
  btBoxShape box(Vec(0.4, 0.35, 0.45));
  const std::shared_ptr<btConvexHullShape> prism = MakePrism(5, 0.4, 0.4);
  btCapsuleShape capsule(btScalar(0.4), btScalar(0.3));
  btConvexShape* const shapes[] = {&box, prism.get(), &capsule};
  ExpectAnswersOfNewOnes(box, [&](int step, btCollisionObject& body) { body.setCollisionShape(shapes[step / 2 % 3]); });
}

// What it is for: without it, each triangle that touches is solved from scratch in each step.
TEST_F(MeshPairs, KeptTriangles_AreWarm) {
  const std::shared_ptr<btConvexHullShape> prism = MakePrism(7, 0.4, 0.4);
  btCollisionObject body;
  body.setCollisionShape(prism.get());
  MeshPair pair(dispatcher_, body, mesh_, false);
  for (int step = 0; step < 200; ++step) {
    body.setWorldTransform(Place(0));
    body.getWorldTransform().getOrigin() += Vec(0.005 * step, 0, 0);
    pair.Step();
  }
  const dgd_bullet::Statistics statistics = configuration_.statistics();
  ASSERT_EQ(statistics.pairs.size(), 1U);
  const dgd_bullet::PairStatistics& triangles = statistics.pairs[0];
  EXPECT_GT(triangles.solved + triangles.separated, 500U);
  EXPECT_GT(triangles.solved, 100U);
  std::uint64_t evaluations = 0;
  for (std::size_t i = 0; i < triangles.iterations.size(); ++i) evaluations += i * triangles.iterations[i];
  EXPECT_LT(evaluations, 3 * triangles.calls) << "a triangle's first query takes 6 to 10";
}

// What an app's allocator sees of them: the table is read once.
TEST_F(MeshPairs, BodyOnAMesh_AsksForATrianglesAlgorithmOnce) {
  btBoxShape box(Vec(0.4, 0.35, 0.45));
  btCollisionObject body;
  body.setCollisionShape(&box);
  {
    MeshPair pair(dispatcher_, body, mesh_, false);
    for (int step = 0; step < 200; ++step) {
      body.setWorldTransform(Place(step));
      pair.Step();
      EXPECT_EQ(dispatcher_.living(), 1);
    }
    EXPECT_EQ(dispatcher_.made(), 2);
  }
  EXPECT_EQ(dispatcher_.living(), 0);
}

// Across its rows, a body leaves and meets triangles all along Bullet's order of visits.
TEST_F(MeshPairs, SlideAcrossAHeightfieldsRows_CostsAsAlongThem) {
  constexpr int kPoints = 101, kSteps = 40;
  constexpr double kCell = 0.1, kWay = 0.05;
  std::vector<btScalar> heights(kPoints * kPoints, btScalar(0));
  btHeightfieldTerrainShape terrain(kPoints, kPoints, heights.data(), btScalar(-1), btScalar(1), 2, false);
  terrain.setLocalScaling(Vec(kCell, kCell, 1));
  mesh_.setCollisionShape(&terrain);
  btBoxShape box(Vec(2, 2, 0.25));
  btCollisionObject body;
  body.setCollisionShape(&box);
  std::array<double, 2> evaluations{}, calls{};
  for (const int axis : {0, 1}) {
    Dispatching dispatching(Route::kConfiguration, Counting());
    MeshPair pair(dispatching.dispatcher(), body, mesh_, false);
    for (int step = 0; step < kSteps; ++step) {
      btVector3 place = Vec(0.013, 0.013, 0.25);
      place[axis] += btScalar(kWay * (step - kSteps / 2));
      body.setWorldTransform(btTransform(btQuaternion::getIdentity(), place));
      pair.Step();
    }
    const dgd_bullet::PairStatistics triangles = dispatching.statistics().pairs.at(0);
    calls[std::size_t(axis)] = double(triangles.calls);
    for (std::size_t i = 0; i < triangles.iterations.size(); ++i) {
      evaluations[std::size_t(axis)] += double(i * triangles.iterations[i]);
    }
  }
  EXPECT_GT(calls[0], 3000 * kSteps);
  EXPECT_NEAR(calls[1], calls[0], 0.02 * calls[0]);
  EXPECT_NEAR(evaluations[1], evaluations[0], 0.05 * evaluations[0]);
}

int made = 0;

struct OwnCreateFunc : btConvexConvexAlgorithm::CreateFunc {
  using CreateFunc::CreateFunc;
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* body_0,
                                                 const btCollisionObjectWrapper* body_1) override {
    ++made;
    return CreateFunc::CreateCollisionAlgorithm(info, body_0, body_1);
  }
};

// An app's algorithm may rely on that.
TEST_F(MeshPairs, AppsOwnAlgorithmForTriangles_IsMadeAnewInEachStep) {
  btGjkEpaPenetrationDepthSolver penetration;
  OwnCreateFunc own(&penetration);
  dispatcher_.registerCollisionCreateFunc(BOX_SHAPE_PROXYTYPE, TRIANGLE_SHAPE_PROXYTYPE, &own);
  btBoxShape box(Vec(0.4, 0.35, 0.45));
  btCollisionObject body;
  body.setCollisionShape(&box);
  body.setWorldTransform(Place(0));
  MeshPair pair(dispatcher_, body, mesh_, false);
  made = 0;
  pair.Step();
  const int made_first = made;
  EXPECT_GT(made_first, 2);
  EXPECT_GT(pair.Step().getNumContacts(), 0);
  EXPECT_EQ(made, 2 * made_first);
  EXPECT_EQ(dispatcher_.living(), 1);
}

int told_of_triangles = 0;

bool SeesATriangle(btManifoldPoint& point, const btCollisionObjectWrapper* wrapper_0, int part_0, int index_0,
                   const btCollisionObjectWrapper* wrapper_1, int part_1, int index_1) {
  const bool is_first = wrapper_0->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE;
  const btCollisionObjectWrapper& triangle = is_first ? *wrapper_0 : *wrapper_1;
  EXPECT_EQ(triangle.getCollisionShape()->getShapeType(), TRIANGLE_SHAPE_PROXYTYPE);
  EXPECT_EQ(triangle.m_partId, is_first ? part_0 : part_1);
  EXPECT_EQ(triangle.m_index, is_first ? index_0 : index_1);
  EXPECT_EQ(triangle.m_index, is_first ? point.m_index0 : point.m_index1);
  EXPECT_GE(triangle.m_index, 0);
  ++told_of_triangles;
  return true;
}

// As Bullet's own adjustment of contacts at inner edges needs it.
TEST_F(MeshPairs, Callbacks_KnowTheTriangle) {
  btBoxShape box(Vec(0.4, 0.35, 0.45));
  btCollisionObject body;
  body.setCollisionShape(&box);
  body.setWorldTransform(Place(0));
  mesh_.setCollisionFlags(mesh_.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  gContactAddedCallback = SeesATriangle;
  for (const bool is_mesh_first : {false, true}) {
    MeshPair pair(dispatcher_, body, mesh_, is_mesh_first);
    for (int step = 0; step < 3; ++step) {
      told_of_triangles = 0;
      pair.Step();
      EXPECT_GT(told_of_triangles, 0) << step;
    }
  }
  gContactAddedCallback = nullptr;
}

}  // namespace
}  // namespace dgd_test
