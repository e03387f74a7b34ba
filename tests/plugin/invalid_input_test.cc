// What is no shape or no pose must not crash nor write NaN; it is counted, and forgotten once it is mended.
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <cmath>
#include <functional>
#include <limits>

#include "plugin/fallback_fixture.h"
#include "plugin/shape_zoo.h"

namespace dgd_test {
namespace {

const btScalar kNaN = std::numeric_limits<btScalar>::quiet_NaN();
const btScalar kInfinity = std::numeric_limits<btScalar>::infinity();

/// A pose or shape that is none, made by `spoil` from a pair of touching hulls, and undone by `heal`.
void ExpectNothingBad(PairQuery& pair, const std::function<void()>& spoil, const std::function<void()>& heal) {
  for (int round = 0; round < 2; ++round) {
    spoil();
    for (int step = 0; step < 2; ++step) {
      const std::vector<Contact> contacts = pair.Step();
      for (const Contact& contact : contacts) {
        EXPECT_TRUE(contact.normal_b_to_a.allFinite() && contact.on_b.allFinite() && std::isfinite(contact.depth));
      }
      for (int i = 0; i < pair.manifold()->getNumContacts(); ++i) {
        EXPECT_TRUE(std::isfinite(pair.manifold()->getContactPoint(i).getDistance()));
      }
    }
    heal();
    const std::vector<Contact> contacts = pair.Step();
    ASSERT_FALSE(contacts.empty());
    EXPECT_NEAR(Deepest(contacts).depth, -0.01, kLength);
  }
}

class InvalidPose : public Fallback {};

// NaN is counted; a body at infinity may as well be called far away.
TEST_F(InvalidPose, NaNOrInfinity_WritesNothingBadAndNaNIsCounted) {
  const auto prism = MakePrism(5, 0.4, 0.3);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  btSphereShape sphere(btScalar(0.3));
  btCylinderShape cylinder(Vec(0.3, 0.3, 0.3));
  btConvexShape* const shapes[] = {prism.get(), &box, &sphere, &cylinder};
  std::uint64_t steps_with_nan = 0;
  for (btConvexShape* shape : shapes) {
    PairQuery pair(dispatching_.dispatcher(), *shape, box);
    const double height = shape == &box ? 0.5 : 0.3 + (shape == prism.get() ? double(prism->getMargin()) : 0);
    const btTransform good = At(0.02, 0.01, 0.5 + height - 0.01);
    pair.SetPoses(good, btTransform::getIdentity());
    pair.Step();
    for (const btScalar bad : {kNaN, kInfinity, -kInfinity}) {
      for (const bool in_rotation : {false, true}) {
        for (const bool of_a : {false, true}) {
          SCOPED_TRACE(std::string(shape->getName()) + " " + std::to_string(bad) +
                       (in_rotation ? " rotation" : " origin") + (of_a ? " of A" : " of B"));
          btTransform broken = of_a ? good : btTransform::getIdentity();
          if (in_rotation) {
            broken.getBasis()[1].setX(bad);
          } else {
            broken.getOrigin().setZ(bad);
          }
          ExpectNothingBad(
              pair, [&] { of_a ? pair.SetPoses(broken, btTransform::getIdentity()) : pair.SetPoses(good, broken); },
              [&] { pair.SetPoses(good, btTransform::getIdentity()); });
          if (std::isnan(bad)) steps_with_nan += 4;
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GE(dispatching_.statistics().fallbacks_invalid, steps_with_nan);
  EXPECT_EQ(dispatching_.statistics().Fallbacks(), dispatching_.statistics().fallbacks_invalid);
}

class InvalidShape : public Fallback {
 protected:
  void ExpectHandled(btConvexShape& bad) {
    btBoxShape box(Vec(0.5, 0.5, 0.5));
    for (const bool swapped : {false, true}) {
      PairQuery pair(dispatching_.dispatcher(), swapped ? box : bad, swapped ? static_cast<btConvexShape&>(bad) : box);
      pair.SetPoses(At(0.02, 0.01, 0.3), btTransform::getIdentity());
      for (int step = 0; step < 2; ++step) ExpectFinite(pair, pair.Step());
      ExpectFinite(pair, pair.ClosestPoints(0.1));
    }
    ExpectCounts(0, 6);
  }
};

TEST_F(InvalidShape, HullWithoutPoints) {
  btConvexHullShape hull;
  ExpectHandled(hull);
}

TEST_F(InvalidShape, HullWithANaNPoint) {
  const auto hull = MakePrism(5, 0.4, 0.3);
  hull->addPoint(btVector3(0, kNaN, 0), false);
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, LargeHullWithANaNPoint) {
  const auto hull = MakePrism(100, 0.4, 0.3);
  hull->getUnscaledPoints()[77].setY(kNaN);
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, BoxOfNaNSize) {
  btBoxShape box(btVector3(kNaN, 1, 1));
  ExpectHandled(box);
}

TEST_F(InvalidShape, NaNMargin) {
  const auto hull = MakePrism(5, 0.4, 0.3);
  hull->setMargin(kNaN);
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, NegativeMargin) {
  const auto hull = MakePrism(5, 0.4, 0.3);
  hull->setMargin(btScalar(-0.02));
  ExpectHandled(*hull);
}

TEST_F(InvalidShape, SphereOfNaNRadius) {
  btSphereShape sphere(kNaN);
  ExpectHandled(sphere);
}

TEST_F(InvalidShape, TriangleWithANaNCorner) {
  btTriangleShape triangle(Vec(0, 0, 0), btVector3(1, kNaN, 0), Vec(0, 1, 0));
  ExpectHandled(triangle);
}

TEST_F(InvalidShape, PointCloudWithoutPoints) {
  btConvexPointCloudShape cloud;
  ExpectHandled(cloud);
}

/// A user's shape whose support function is broken.
class BrokenSupport : public Ellipsoid {
 public:
  BrokenSupport() : Ellipsoid(Vec(0.5, 0.5, 0.5)) {}
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3&) const override { return {kNaN, kNaN, kNaN}; }
};

TEST_F(InvalidShape, CustomShapeOfNaN) {
  BrokenSupport broken;
  ExpectHandled(broken);
}

}  // namespace
}  // namespace dgd_test
