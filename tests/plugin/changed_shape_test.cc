// A shape that changes while its pairs live, in any way Bullet allows: the next answer is that of the shape as it is.
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>

#include <array>
#include <cmath>
#include <functional>
#include <new>

#include "plugin/fallback_fixture.h"
#include "plugin/shape_zoo.h"

namespace dgd_test {
namespace {

class ChangedShape : public Fallback {
 protected:
  /// Steps the pair before and after `change`; the second answer must be that of the changed shape.
  void ExpectFollows(btConvexShape& shape, const std::function<void()>& change) {
    btBoxShape floor(Vec(5, 5, 1));
    PairQuery pair(dispatching_.dispatcher(), shape, floor), cold(dispatching_.dispatcher(), shape, floor);
    for (int round = 0; round < 2; ++round) {
      btTransform pose = btTransform::getIdentity();
      pose.getOrigin().setZ(btScalar(PosedConvex{shape, pose}.SupportValue(-Vector::UnitZ()) - 0.001));
      pair.SetPoses(pose, At(0, 0, -1));
      cold.SetPoses(pose, At(0, 0, -1));
      const std::vector<Contact> contacts = pair.Step(), expected = cold.ClosestPoints(0);
      ASSERT_FALSE(contacts.empty());
      EXPECT_NEAR(Deepest(contacts).depth, -0.001, 3e-5) << (round == 0 ? "before" : "after") << " the change, warm";
      EXPECT_NEAR(Deepest(expected).depth, -0.001, 3e-5) << (round == 0 ? "before" : "after") << " the change, cold";
      change();
    }
    ExpectCounts(0, 0);
  }
};

TEST_F(ChangedShape, HullGainsAPoint) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] { hull->addPoint(Vec(0.1, 0.05, -0.6)); });
}

TEST_F(ChangedShape, HullIsScaled) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] { hull->setLocalScaling(Vec(1, 1, -1.7)); });
}

TEST_F(ChangedShape, HullsMarginChanges) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] { hull->setMargin(btScalar(0.1)); });
}

TEST_F(ChangedShape, HullsPointMovesInPlace) {
  const auto hull = MakePrism(6, 0.4, 0.3);
  ExpectFollows(*hull, [&] {
    hull->getUnscaledPoints()[4].setZ(btScalar(-0.5));
    hull->recalcLocalAabb();
  });
}

// Every single point of a large hull counts, not only a sample of them.
TEST_F(ChangedShape, LargeHullsPointMovesInPlace) {
  for (const int point : {0, 1, 7, 100, 199}) {
    SCOPED_TRACE(point);
    const auto hull = MakePrism(100, 0.4, 0.3);
    ExpectFollows(*hull, [&] {
      hull->getUnscaledPoints()[point].setZ(btScalar(-0.5));
      hull->recalcLocalAabb();
    });
    if (HasFailure()) break;
  }
}

TEST_F(ChangedShape, PointCloudGetsOtherPoints) {
  std::array<btVector3, 6> first = {Vec(0.3, 0, 0),  Vec(-0.3, 0, 0), Vec(0, 0.3, 0),
                                    Vec(0, -0.3, 0), Vec(0, 0, 0.3),  Vec(0, 0, -0.3)};
  std::array<btVector3, 6> second = first;
  second[5] = Vec(0.1, 0, -0.7);
  btConvexPointCloudShape cloud(first.data(), 6, Vec(1, 1, 1));
  ExpectFollows(cloud, [&] { cloud.setPoints(second.data(), 6, true, Vec(1, 0.8, 1)); });
}

TEST_F(ChangedShape, TriangleMeshIsDeformed) {
  std::array<btVector3, 4> vertices = {Vec(0.4, 0, 0), Vec(-0.3, 0.4, 0), Vec(-0.3, -0.4, 0), Vec(0, 0, -0.4)};
  std::array<int, 12> indices = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  btTriangleIndexVertexArray mesh(4, indices.data(), 3 * sizeof(int), 4, &vertices[0][0], sizeof(btVector3));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { vertices[3] = Vec(0.05, 0.02, -0.8); });
}

TEST_F(ChangedShape, LargeTriangleMeshIsDeformed) {
  std::vector<btVector3> vertices;
  std::vector<int> indices;
  for (int i = 0; i < 300; ++i) {
    vertices.push_back(Vec(0.4 * std::cos(i * 0.7), 0.4 * std::sin(i * 0.7), 0.001 * i - 0.15));
    indices.push_back(i);
  }
  btTriangleIndexVertexArray mesh(100, indices.data(), 3 * sizeof(int), 300, &vertices[0][0], sizeof(btVector3));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { vertices[155] = Vec(0, 0, -0.8); });
}

// A vertex buffer with the positions at its end: what lies behind the last position is not ours to read. (For the
// address sanitizer.)
TEST_F(ChangedShape, InterleavedTriangleMesh_IsReadWithinItsBounds) {
  constexpr int kStride = 8;  // Scalars: normal, texture, position.
  std::vector<btScalar> buffer(4 * kStride, 0);
  const std::array<btVector3, 4> corners = {Vec(0.4, 0, 0), Vec(-0.3, 0.4, 0), Vec(-0.3, -0.4, 0), Vec(0, 0, -0.4)};
  for (std::size_t i = 0; i < 4; ++i) {
    for (int axis = 0; axis < 3; ++axis) buffer[i * kStride + 5 + static_cast<std::size_t>(axis)] = corners[i][axis];
  }
  std::array<int, 12> indices = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  btTriangleIndexVertexArray mesh(4, indices.data(), 3 * sizeof(int), 4, &buffer[5], kStride * sizeof(btScalar));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { buffer[3 * kStride + 7] = btScalar(-0.8); });
}

TEST_F(ChangedShape, TriangleMeshIsScaled) {
  std::array<btVector3, 4> vertices = {Vec(0.4, 0, 0), Vec(-0.3, 0.4, 0), Vec(-0.3, -0.4, 0), Vec(0, 0, -0.4)};
  std::array<int, 12> indices = {0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  btTriangleIndexVertexArray mesh(4, indices.data(), 3 * sizeof(int), 4, &vertices[0][0], sizeof(btVector3));
  btConvexTriangleMeshShape shape(&mesh, true);
  ExpectFollows(shape, [&] { shape.setLocalScaling(Vec(1, 1, 2)); });
}

TEST_F(ChangedShape, BoxSphereCapsuleAndMultiSphereAreScaled) {
  btBoxShape box(Vec(0.4, 0.3, 0.2));
  btSphereShape sphere(btScalar(0.3));
  btCapsuleShapeZ capsule(btScalar(0.2), btScalar(0.5));
  const btVector3 positions[2] = {Vec(0, 0, 0.2), Vec(0, 0, -0.1)};
  const btScalar radii[2] = {btScalar(0.2), btScalar(0.3)};
  btMultiSphereShape spheres(positions, radii, 2);
  for (btConvexShape* shape : {static_cast<btConvexShape*>(&box), static_cast<btConvexShape*>(&sphere),
                               static_cast<btConvexShape*>(&capsule), static_cast<btConvexShape*>(&spheres)}) {
    SCOPED_TRACE(shape->getName());
    ExpectFollows(*shape, [&] { shape->setLocalScaling(Vec(1.5, 1.5, 1.5)); });
  }
}

// Bullet tells nobody when a shape dies, and a new one may take its address with as many points.
TEST_F(ChangedShape, AnotherHullAtTheSameAddress) {
  struct Slot {
    alignas(btConvexHullShape) std::array<unsigned char, sizeof(btConvexHullShape)> bytes{};
  };
  for (const int sides : {4, 100}) {
    SCOPED_TRACE(sides);
    const auto slot = std::make_unique<Slot>();
    const auto construct = [&](double half_height) {
      const auto source = MakePrism(sides, 0.4, half_height);
      return ::new (static_cast<void*>(slot->bytes.data()))
          btConvexHullShape(&source->getUnscaledPoints()[0][0], source->getNumPoints(), sizeof(btVector3));
    };
    btConvexHullShape* hull = construct(0.3);
    ExpectFollows(*hull, [&] {
      hull->~btConvexHullShape();
      hull = construct(0.7);
    });
    hull->~btConvexHullShape();
  }
}

// The body gets a shape of another type while its pair lives.
TEST_F(ChangedShape, BodyGetsAShapeOfAnotherType) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(1);
  btBoxShape floor(Vec(5, 5, 1));
  PairQuery pair(dispatching_.dispatcher(), *zoo[0].shape, floor);
  Random random(TestSeed());
  for (int step = 0; step < 200; ++step) {
    const ZooShape& next = zoo[static_cast<std::size_t>(random.Below(static_cast<int>(zoo.size())))];
    SCOPED_TRACE("step " + std::to_string(step) + ", " + next.name);
    pair.body_a().setCollisionShape(next.shape.get());
    btTransform pose = MakeTransform(random.Rotation(), Vector::Zero());
    pose.getOrigin().setZ(btScalar(PosedConvex{*next.shape, pose}.SupportValue(-Vector::UnitZ()) - 0.001));
    pair.SetPoses(pose, At(0, 0, -1));
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(Deepest(contacts).depth, -0.001, 3e-5);
  }
  ExpectCounts(0, 0);
}

}  // namespace
}  // namespace dgd_test
