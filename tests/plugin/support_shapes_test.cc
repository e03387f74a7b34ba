// Shapes that Bullet shows a narrowphase through their support function: spheres of one radius have a patch all the
// same, the others bring one together as with Bullet's own narrowphase, a point a step.
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "plugin/test_world.h"
#include "plugin/triangle_grid.h"
#include "plugin/truncated_pyramid.h"

namespace dgd_test {
namespace {

constexpr double kOverlap = 1e-3;

enum class Ground { kBox, kPlane, kMesh };

/// A body that overlaps the ground z = 0 by a millimetre, at rest.
class OnGround : public testing::TestWithParam<Ground> {
 protected:
  OnGround() : world_(Route::kConfiguration) {
    switch (GetParam()) {
      case Ground::kBox:
        world_.AddGround();
        break;
      case Ground::kPlane:
        world_.Add(world_.Make<btStaticPlaneShape>(Vec(0, 0, 1), btScalar(0)), 0, Vec(0, 0, 0));
        break;
      default: {
        auto& mesh = world_.Make<btTriangleMesh>();
        AddGrid(mesh, 2, 6, [](double, double) { return 0.0; });
        world_.Add(world_.Make<btBvhTriangleMeshShape>(&mesh, true), 0, Vec(0, 0, 0));
      }
    }
  }

  /// @param foot  How far the shape reaches down, metres.
  std::vector<btManifoldPoint> Lay(btConvexShape& shape, double foot) {
    body_ = &world_.Add(shape, 1, Vec(3, 1, foot - kOverlap));
    body_->setActivationState(DISABLE_DEACTIVATION);
    world_.Detect();
    return world_.Points();
  }
  /// Tilted towards each corner in turn, so that another one is the lowest each time.
  /// @return points in the manifolds after each step.
  std::vector<std::size_t> Rock(btConvexShape& shape, double foot) {
    constexpr double kTilt = 0.004;
    std::vector<std::size_t> counts = {Lay(shape, foot).size()};
    for (int step = 0; step < 8; ++step) {
      const double heading = step * std::numbers::pi / 2 + 0.4;
      btTransform pose(btQuaternion(Vec(std::cos(heading), std::sin(heading), 0), btScalar(kTilt)),
                       body_->getWorldTransform().getOrigin());
      body_->setWorldTransform(pose);
      world_.Detect();
      counts.push_back(world_.Points().size());
    }
    return counts;
  }

  TestWorld world_;
  btRigidBody* body_ = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Grounds, OnGround, testing::Values(Ground::kBox, Ground::kPlane, Ground::kMesh),
                         [](const auto& ground) {
                           return ground.param == Ground::kBox     ? "Box"
                                  : ground.param == Ground::kPlane ? "Plane"
                                                                   : "Mesh";
                         });

constexpr double kRadius = 0.1;  // m

btMultiSphereShape Spheres(const std::vector<btVector3>& centers, const std::vector<btScalar>& radii) {
  return {centers.data(), radii.data(), static_cast<int>(centers.size())};
}
btMultiSphereShape EqualSpheres(const std::vector<btVector3>& centers) {
  return Spheres(centers, std::vector<btScalar>(centers.size(), btScalar(kRadius)));
}

const std::vector<btVector3>& Corners() {
  static const std::vector<btVector3> corners = {Vec(-0.3, -0.2, 0), Vec(0.3, -0.2, 0), Vec(-0.3, 0.2, 0),
                                                 Vec(0.3, 0.2, 0)};
  return corners;
}

/// One point below each centre, all as deep as the body was laid.
void ExpectBelow(const std::vector<btManifoldPoint>& points, const std::vector<btVector3>& centers,
                 const btRigidBody& body) {
  EXPECT_EQ(points.size(), centers.size());
  for (const btVector3& center : centers) {
    const btVector3 place = body.getWorldTransform() * center;
    double nearest = 1;
    for (const btManifoldPoint& point : points) {
      const btVector3 to = point.getPositionWorldOnB() - place;
      nearest = std::min(nearest, std::hypot(double(to.x()), double(to.y())));
    }
    EXPECT_LE(nearest, kLength);
  }
  for (const btManifoldPoint& point : points) EXPECT_NEAR(double(point.getDistance()), -kOverlap, kLength);
}

TEST_P(OnGround, EqualSpheres_TouchBelowEachInTheFirstStep) {
  for (const std::size_t count : {1U, 2U, 3U, 4U}) {
    const std::vector<btVector3> centers(Corners().begin(), Corners().begin() + std::ptrdiff_t(count));
    auto& shape = world_.Make<btMultiSphereShape>(EqualSpheres(centers));
    const std::vector<btManifoldPoint> points = Lay(shape, kRadius);
    ExpectBelow(points, centers, *body_);
    world_.world().removeRigidBody(body_);
  }
}

TEST_P(OnGround, EqualSpheresScaledAlike_HaveTheirRadiusScaled) {
  auto& shape = world_.Make<btMultiSphereShape>(EqualSpheres(Corners()));
  shape.setLocalScaling(Vec(1.5, 1.5, 1.5));
  std::vector<btVector3> centers = Corners();
  for (btVector3& center : centers) center *= btScalar(1.5);
  const std::vector<btManifoldPoint> points = Lay(shape, 1.5 * kRadius);
  ExpectBelow(points, centers, *body_);
}

// A step with the radius of before would overlap by half of it.
TEST_P(OnGround, EqualSpheresScaledAtRest_AreSeenAtOnce) {
  auto& shape = world_.Make<btMultiSphereShape>(EqualSpheres(Corners()));
  Lay(shape, kRadius);
  world_.Detect();
  shape.setLocalScaling(Vec(1.02, 1.02, 1.02));
  world_.Detect();
  for (const btManifoldPoint& point : world_.Points()) {
    EXPECT_NEAR(double(point.getDistance()), -kOverlap - 0.02 * kRadius, kLength);
  }
}

TEST_P(OnGround, UnequalSpheres_BringTheirPatchTogether) {
  std::vector<btVector3> centers = Corners();
  std::vector<btScalar> radii(4, btScalar(kRadius));
  centers.push_back(Vec(0, 0, 0.1));
  radii.push_back(btScalar(1.5 * kRadius));
  auto& shape = world_.Make<btMultiSphereShape>(Spheres(centers, radii));
  const std::vector<std::size_t> counts = Rock(shape, kRadius);
  EXPECT_EQ(counts.front(), 1U);
  EXPECT_GE(counts.back(), 3U);
}

// Bullet scales a sphere's reach along each axis: half as high.
TEST_P(OnGround, EqualSpheresScaledOtherwiseAlongZ_ReachAsFarAsBulletHasIt) {
  auto& shape = world_.Make<btMultiSphereShape>(EqualSpheres(Corners()));
  shape.setLocalScaling(Vec(1, 1, 0.5));
  const std::vector<btManifoldPoint> points = Lay(shape, 0.5 * kRadius);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(double(points[0].getDistance()), -kOverlap, kLength);
}

TEST_P(OnGround, ShapeOfAnAppsOwn_BringsItsPatchTogether) {
  const std::vector<std::size_t> counts = Rock(world_.Make<TruncatedPyramid>(Vec(0.4, 0.3, 0.15), 0.05), 0.2);
  EXPECT_EQ(counts.front(), 1U);
  EXPECT_GE(counts.back(), 3U);
}

TEST_P(OnGround, UniformlyScaledShape_BringsItsPatchTogether) {
  auto& box = world_.Make<btBoxShape>(Vec(0.2, 0.15, 0.1));
  const std::vector<std::size_t> counts = Rock(world_.Make<btUniformScalingShape>(&box, btScalar(2)), 0.2);
  EXPECT_EQ(counts.front(), 1U);
  EXPECT_GE(counts.back(), 3U);
}

// With one point at a time it never did.
TEST_P(OnGround, ShapeOfAnAppsOwn_ComesToRest) {
  Lay(world_.Make<TruncatedPyramid>(Vec(0.4, 0.3, 0.15), 0.05), 0.25);
  world_.Simulate(3);
  EXPECT_LT(double(body_->getLinearVelocity().length()), 5e-3);
  EXPECT_LT(double(body_->getAngularVelocity().length()), 5e-3);
  EXPECT_NEAR(double(body_->getWorldTransform().getOrigin().z()), 0.2, 1e-3);
}

}  // namespace
}  // namespace dgd_test
