// Which pairs dgd_bullet::CollisionDispatcher shares among threads.
#include "algorithms/concurrent_pairs.h"

#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include "dgd_bullet/collision_configuration.h"
#include "plugin/bullet_oracle.h"
#include "plugin/rigid_body.h"
#include "plugin/triangle_grid.h"

namespace dgd_test {
namespace {

class Dispatcher : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  bool Shares(const btCollisionShape& a, const btCollisionShape& b) const {
    const bool shares = dgd_bullet::IsConcurrent(m_doubleDispatchContactPoints, a, b);
    EXPECT_EQ(dgd_bullet::IsConcurrent(m_doubleDispatchContactPoints, b, a), shares);
    return shares;
  }
};

TEST(ConcurrentPairs, AreThoseOfConvexShapesPlanesAndCompoundsOfConvexShapes) {
  dgd_bullet::CollisionConfiguration configuration;
  const Dispatcher dispatcher(&configuration);
  btBoxShape box(Vec(1, 1, 1));
  btSphereShape ball(1);
  btBox2dShape flat(Vec(1, 1, 1));
  const btStaticPlaneShape plane(Vec(0, 0, 1), 0);
  btTriangleMesh triangles;
  AddGrid(triangles, 2, 1, [](double, double) { return 0; });
  const btBvhTriangleMeshShape mesh(&triangles, true);
  btCompoundShape solids, nested, has_flat, empty;
  solids.addChildShape(At(0, 0, 0), &box);
  solids.addChildShape(At(3, 0, 0), &ball);
  nested.addChildShape(At(0, 0, 0), &solids);
  has_flat.addChildShape(At(0, 0, 0), &nested);
  has_flat.addChildShape(At(3, 0, 0), &flat);
  for (const btCollisionShape* a :
       {static_cast<const btCollisionShape*>(&box), static_cast<const btCollisionShape*>(&solids),
        static_cast<const btCollisionShape*>(&nested), static_cast<const btCollisionShape*>(&empty)}) {
    EXPECT_TRUE(dispatcher.Shares(*a, ball)) << a->getName();
    EXPECT_TRUE(dispatcher.Shares(*a, plane)) << a->getName();
    EXPECT_TRUE(dispatcher.Shares(*a, nested)) << a->getName();
  }
  EXPECT_FALSE(dispatcher.Shares(has_flat, box));
  EXPECT_FALSE(dispatcher.Shares(has_flat, solids));
  EXPECT_FALSE(dispatcher.Shares(solids, mesh));
  EXPECT_FALSE(dispatcher.Shares(box, mesh));
}

TEST(ConcurrentPairs, OfBulletsOwnNarrowphase_AreNone) {
  btDefaultCollisionConfiguration configuration;
  const Dispatcher dispatcher(&configuration);
  btBoxShape box(Vec(1, 1, 1));
  btCompoundShape compound;
  compound.addChildShape(At(0, 0, 0), &box);
  EXPECT_FALSE(dispatcher.Shares(box, box));
  EXPECT_FALSE(dispatcher.Shares(compound, box));
  EXPECT_FALSE(dispatcher.Shares(compound, compound));
}

}  // namespace
}  // namespace dgd_test
