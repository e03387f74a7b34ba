// What each option of a dispatcher does to the contacts.
#include "dgd_bullet/options.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr double kAsDeep = 2e-5;  // A corner that is as deep as the deepest point stands for it.

/// The deepest contact of a pair's first step.
Contact DeepestOf(const dgd_bullet::Options& options, btConvexShape& a, btConvexShape& b, const btTransform& pose_a,
                  const btTransform& pose_b) {
  Dispatching dispatching(Route::kConfiguration, options);
  PairQuery pair(dispatching.dispatcher(), a, b);
  pair.SetPoses(pose_a, pose_b);
  const std::vector<Contact> contacts = pair.Step();
  EXPECT_FALSE(contacts.empty());
  return contacts.empty() ? Contact() : Deepest(contacts);
}

// Bullet's EPA says 0.058 along a diagonal for two such boxes without margins.
TEST(ContactNormal, UnitBoxesOverlappingByATenth_AreATenthDeepAlongTheAxis) {
  for (const double margin : {0.0, 0.04}) {
    btBoxShape box(Vec(0.5, 0.5, 0.5));
    box.setMargin(btScalar(margin));
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {1.0, -1.0}) {
        Vector offset(0.2, 0.3, -0.1);
        offset[axis] = side * 0.9;
        const Contact contact =
            DeepestOf({}, box, box, MakeTransform(Eigen::Matrix3d::Identity(), offset), btTransform::getIdentity());
        EXPECT_NEAR(contact.depth, -0.1, kLength) << margin;
        EXPECT_NEAR((contact.normal_b_to_a - side * Vector::Unit(axis)).norm(), 0, kLength) << margin;
      }
    }
  }
}

TEST(PatchSize, BoxOnFloor_HasSoManyPointsWithTheDeepestAmongThem) {
  btBoxShape box(Vec(0.5, 0.3, 0.2)), floor(Vec(5, 5, 1));
  for (int size = 1; size <= 4; ++size) {
    dgd_bullet::Options options;
    options.patch_size = size;
    Dispatching dispatching(Route::kConfiguration, options);
    PairQuery pair(dispatching.dispatcher(), box, floor);
    pair.SetPoses(
        MakeTransform(Eigen::AngleAxisd(1e-3, Vector(1, 2, 0).normalized()).toRotationMatrix(), {0, 0, 0.199}),
        At(0, 0, -1));
    const std::vector<Contact> contacts = pair.Step();
    EXPECT_EQ(contacts.size(), static_cast<std::size_t>(size));
    EXPECT_EQ(pair.manifold()->getNumContacts(), size);
    EXPECT_NEAR(Deepest(contacts).depth, PlaneSeparation(pair.A(), pair.B(), Vector::UnitZ()), kLength);
  }
}

TEST(ContactDistance, BodiesWithinIt_HaveContactsAndOthersNone) {
  btBoxShape box(Vec(0.5, 0.3, 0.2)), floor(Vec(5, 5, 1));
  for (const double distance : {0.0, 0.002, 0.1}) {
    dgd_bullet::Options options;
    options.contact_distance = distance;
    Dispatching dispatching(Route::kConfiguration, options);
    for (const double gap : {-0.01, 0.001, 0.01, 0.09, 0.11}) {
      PairQuery pair(dispatching.dispatcher(), box, floor);
      pair.SetPoses(At(0, 0, 0.2 + gap), At(0, 0, -1));
      const std::vector<Contact> contacts = pair.Step();
      const double limit = distance > 0 ? distance : double(pair.manifold()->getContactBreakingThreshold());
      EXPECT_EQ(contacts.size(), gap <= limit ? 4U : 0U) << "gap " << gap << " contact distance " << distance;
      EXPECT_EQ(pair.manifold()->getNumContacts(), static_cast<int>(contacts.size())) << gap << " " << distance;
      for (const Contact& contact : contacts) EXPECT_NEAR(contact.depth, gap, kLength);
      // They persist.
      pair.Step();
      EXPECT_EQ(pair.manifold()->getNumContacts(), static_cast<int>(contacts.size())) << gap << " " << distance;
    }
  }
}

TEST(GeometryMode, Bullets_BoxStandsOnASharpEdge) {
  btBoxShape box(Vec(0.5, 0.5, 0.5)), floor(Vec(5, 5, 1));
  const btTransform on_edge = MakeTransform(Eigen::AngleAxisd(std::numbers::pi / 4, Vector::UnitX()).toRotationMatrix(),
                                            {0, 0, std::sqrt(2) * 0.5});
  for (const double margin : {0.04, 0.001, 0.0}) {
    box.setMargin(btScalar(margin));
    EXPECT_NEAR(DeepestOf({}, box, floor, on_edge, At(0, 0, -1)).depth, 0, kLength);
    EXPECT_NEAR(DeepestOf({}, box, floor, At(0, 0, 0.499), At(0, 0, -1)).depth, -0.001, kLength);
  }
}

// A scaled box is read through Bullet's support functions, which round it by its margin.
TEST(GeometryMode, Bullets_ScaledBoxKeepsItsMargin) {
  btBoxShape box(Vec(0.25, 0.25, 0.25)), floor(Vec(5, 5, 1));
  btUniformScalingShape scaled(&box, 2);
  const double margin = double(scaled.getMargin());
  ASSERT_NEAR(margin, 2 * 0.025, kLength);
  const btTransform on_edge = MakeTransform(Eigen::AngleAxisd(std::numbers::pi / 4, Vector::UnitX()).toRotationMatrix(),
                                            {0, 0, std::sqrt(2) * 0.5 - 0.02});
  EXPECT_NEAR(DeepestOf({}, scaled, floor, on_edge, At(0, 0, -1)).depth, (std::sqrt(2) - 1) * margin - 0.02,
              kLength + kAsDeep);
}

TEST(GeometryMode, Bullets_BoxInACompoundIsSharp) {
  TestWorld world(Route::kConfiguration);
  world.AddGround();
  btBoxShape& box = world.Make<btBoxShape>(Vec(0.5, 0.5, 0.5));
  btCompoundShape& compound = world.Make<btCompoundShape>();
  compound.addChildShape(
      MakeTransform(Eigen::AngleAxisd(std::numbers::pi / 4, Vector::UnitX()).toRotationMatrix(), {0, 0, 0}), &box);
  world.Add(compound, 1, Vec(0, 0, std::sqrt(2) * 0.5 - 0.01));
  world.Detect();
  const std::vector<btManifoldPoint> points = world.Points();
  EXPECT_EQ(points.size(), 2U);
  for (const btManifoldPoint& point : points) {
    EXPECT_NEAR(double(point.getDistance()), -0.01, kLength);
  }
}

TEST(GeometryMode, Sharp_IsTheShapeWithoutItsRounding) {
  dgd_bullet::Options sharp;
  sharp.geometry_mode = dgd_bullet::GeometryMode::kSharp;
  btBoxShape box(Vec(0.5, 0.5, 0.5)), floor(Vec(5, 5, 1));
  // On its edge, 1 mm deep: rounded by 2 mm, it would be 0.8 mm less.
  const btTransform on_edge = MakeTransform(Eigen::AngleAxisd(std::numbers::pi / 4, Vector::UnitX()).toRotationMatrix(),
                                            {0, 0, std::sqrt(2) * 0.5 - 0.001});
  EXPECT_NEAR(DeepestOf(sharp, box, floor, on_edge, At(0, 0, -1)).depth, -0.001, kLength);
  // Its face reaches to its corners, which the rounded one's does not.
  Dispatching dispatching(Route::kConfiguration, sharp);
  PairQuery pair(dispatching.dispatcher(), box, floor);
  pair.SetPoses(At(0, 0, 0.499), At(0, 0, -1));
  for (const Contact& contact : pair.Step()) {
    EXPECT_NEAR(std::abs(contact.on_b.x()), 0.5, kLength);
    EXPECT_NEAR(std::abs(contact.on_b.y()), 0.5, kLength);
  }
  // Hulls lose their margin, cylinders keep their size, spheres are spheres.
  const auto prism = MakePrism(6, 0.5, 0.2);
  btCylinderShapeZ cylinder(Vec(0.4, 0.4, 0.3));
  btSphereShape sphere(btScalar(0.25));
  EXPECT_NEAR(DeepestOf(sharp, *prism, floor, At(0, 0, 0.199), At(0, 0, -1)).depth, -0.001, kLength);
  EXPECT_NEAR(DeepestOf(sharp, cylinder, floor, At(0, 0, 0.299), At(0, 0, -1)).depth, -0.001, kLength);
  EXPECT_NEAR(DeepestOf(sharp, sphere, floor, At(0, 0, 0.249), At(0, 0, -1)).depth, -0.001, kLength);
}

}  // namespace
}  // namespace dgd_test
