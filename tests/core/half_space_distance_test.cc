#include "dgd/half_space_distance.h"

#include <gtest/gtest.h>

#include <limits>

#include "dgd/contact/half_space_patch.h"
#include "dgd/contact_patch.h"
#include "dgd/shapes.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const dgd::HalfSpace<double> kGround;

dgd::Pose<double> At(const Vector3d& where) { return {dgd::Matrix3<double>::Identity(), where}; }

TEST(HalfSpaceDistance, Sphere_IsItsHeightInRadii) {
  const auto sphere = dgd::Sphere(0.5);
  for (const double height : {0.1, 0.5, 0.7, 30.0}) {
    const auto result = dgd::GrowthDistance(sphere, At({3, -2, 1 + height}), kGround, At({7, 7, 1}));
    EXPECT_EQ(result.status, dgd::Status::kOptimal);
    EXPECT_NEAR(result.GrowthDistance(), height / 0.5, 1e-14 * height);
    EXPECT_EQ(result.lower_bound, result.upper_bound);
    EXPECT_NEAR(result.separation, height - 0.5, 1e-14);
    EXPECT_NEAR((result.normal - Vector3d(0, 0, -1)).norm(), 0, 1e-15);
    EXPECT_NEAR((result.witness_1 - Vector3d(3, -2, 0.5 + height)).norm(), 0, 1e-14);
    EXPECT_NEAR((result.witness_2 - Vector3d(3, -2, 1)).norm(), 0, 1e-14);
  }
}

// Any set and pose: grown by the result about its centre, its lowest point is on the border; and a huge box whose top
// face is the border says the same.
TEST(HalfSpaceDistance, AnySet_TouchesAtTheGrowthDistance) {
  Random random(TestSeed());
  for (int i = 0; i < 500; ++i) {
    const dgd::RoundedSet cone{dgd::Cone<double>(random.LogUniform(0.05, 5), random.LogUniform(0.05, 5)), 0.1};
    const dgd::Pose<double> pose{random.Rotation(), 3 * random.InCube()};
    const dgd::Pose<double> ground{random.Rotation(), 3 * random.InCube()};
    const auto result = dgd::GrowthDistance(cone, pose, kGround, ground);
    ASSERT_EQ(result.status, dgd::Status::kOptimal);
    const Vector3d up = ground.rotation.col(2), center = pose * cone.core.Center();
    const double height = up.dot(center - ground.translation);
    const double lowest = up.dot(result.witness_1 - ground.translation);
    EXPECT_NEAR(lowest, result.separation, 1e-13);
    EXPECT_NEAR(up.dot(result.witness_2 - ground.translation), 0, 1e-13);
    if (height > 0) {
      EXPECT_NEAR(height + result.GrowthDistance() * (lowest - height), 0, 1e-13);
    } else {
      EXPECT_EQ(result.GrowthDistance(), 0);
    }
    const auto collision = dgd::DetectCollision(cone, pose, kGround, ground);
    EXPECT_EQ(collision.status, result.separation > 0 ? dgd::Status::kSeparated : dgd::Status::kColliding);
    const dgd::RoundedSet slab{dgd::Box<double>(Vector3d::Constant(1e3)), 0.0};
    const dgd::Pose<double> below{ground.rotation, ground * Vector3d(0, 0, -1e3)};
    EXPECT_EQ(dgd::DetectCollision(cone, pose, slab, below).status, collision.status);
  }
}

TEST(HalfSpaceDistance, OtherOrder_SwapsTheAnswer) {
  const dgd::RoundedSet box{dgd::Box<double>({1, 2, 3}), 0.25};
  const auto a = dgd::GrowthDistance(box, At({0, 0, 4}), kGround, At({0, 0, 0}));
  const auto b = dgd::GrowthDistance(kGround, At({0, 0, 0}), box, At({0, 0, 4}));
  EXPECT_EQ(a.GrowthDistance(), 4 / 3.25);
  EXPECT_EQ(b.GrowthDistance(), a.GrowthDistance());
  EXPECT_EQ(b.normal, -a.normal);
  EXPECT_EQ(b.witness_1, a.witness_2);
  EXPECT_EQ(b.witness_2, a.witness_1);
  EXPECT_EQ(dgd::DetectCollision(kGround, {}, box, At({0, 0, 4})).normal, Vector3d(0, 0, 1));
}

TEST(HalfSpaceDistance, InThePlane_IsTheSame) {
  const auto result = dgd::GrowthDistance(dgd::Stadium(0.5, 1.0), {Eigen::Matrix2d::Identity(), Vector2d(1, 3)},
                                          dgd::HalfPlane<double>(), dgd::Pose<double, 2>());
  EXPECT_EQ(result.GrowthDistance(), 2);
  EXPECT_EQ(result.witness_1, Vector2d(1, 1.5));
}

TEST(HalfSpaceDistance, BadAndDegenerateInput_HasADefinedOutcome) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const dgd::RoundedSet point{dgd::Point<double>(), 0.0};
  EXPECT_EQ(dgd::GrowthDistance(point, At({0, 0, 1}), kGround, {}).status, dgd::Status::kNoInterior);
  EXPECT_EQ(dgd::GrowthDistance(point, At({0, 0, -1}), kGround, {}).GrowthDistance(), 0);
  EXPECT_EQ(dgd::GrowthDistance(point, At({0, nan, 1}), kGround, {}).status, dgd::Status::kInvalidInput);
  EXPECT_EQ(dgd::DetectCollision(point, At({0, 0, nan}), kGround, {}).status, dgd::Status::kInvalidInput);
  const auto limited = dgd::GrowthDistance(point, At({0, 0, -1}), kGround, {}, {.separation_limit = 0.5});
  EXPECT_EQ(limited.status, dgd::Status::kOptimal);
  const auto apart = dgd::GrowthDistance(dgd::Sphere(0.5), At({0, 0, 3}), kGround, {}, {.separation_limit = 0.5});
  EXPECT_EQ(apart.status, dgd::Status::kSeparated);
}

// A box that lies on a slope touches it by its face, and a tilted one by what is near.
TEST(HalfSpacePatch, Box_ShowsAllCornersOfItsFace) {
  const dgd::RoundedSet box{dgd::Box<double>({0.5, 0.4, 0.3}), 0.1};
  const dgd::Pose<double> slope{Eigen::AngleAxisd(0.5, Vector3d(1, 2, 0).normalized()).toRotationMatrix(), {3, 4, 5}};
  const auto never = [](const Vector3d&, double) { return false; };
  const auto patch_of = [&](double tilt) {
    const Eigen::Matrix3d turn = slope.rotation * Eigen::AngleAxisd(tilt, Vector3d::UnitY()).toRotationMatrix();
    const dgd::Pose<double> pose{turn, slope * Vector3d(7, 8, 0.399)};
    const auto result = dgd::GrowthDistance(box, pose, kGround, slope);
    const auto facing = dgd::FindFacingFaces(box, pose, kGround, result);
    return dgd::FindContactPatch(result, facing, {.contact_distance = 0.02, .spacing = 0.01}, never);
  };
  const auto flat = patch_of(0);
  ASSERT_EQ(flat.size, 4);
  for (const auto& point : flat.points) {
    EXPECT_NEAR(point.separation, -0.001, 1e-12);
    const Vector3d on_ground = slope.rotation.transpose() * (point.on_2 - slope.translation) - Vector3d(7, 8, 0);
    EXPECT_LT((on_ground.cwiseAbs() - Vector3d(0.5, 0.4, 0)).norm(), 1e-12);
    EXPECT_NEAR((point.on_1 - point.on_2).norm(), 0.001, 1e-12);
  }
  EXPECT_EQ(patch_of(0.1).size, 2);
}

}  // namespace
}  // namespace dgd_test
