// The patch against geometry that can be written down. The plugin's tests cover all pairs of types.
#include "dgd/contact_patch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/growth_distance.h"
#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/point.h"
#include "dgd/shapes/segment.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Vector3d = Eigen::Vector3d;

constexpr double kContactDistance = 0.02;
constexpr double kTolerance = 1e-9;  // Metres.

bool Never(const Vector3d&, double) { return false; }

template <class Set1, class Set2, class IsApproaching = bool (*)(const Vector3d&, double)>
dgd::ContactPatch<double> PatchOf(const Set1& set_1, const dgd::Pose<double>& pose_1, const Set2& set_2,
                                  const dgd::Pose<double>& pose_2, IsApproaching is_approaching = Never) {
  const dgd::Result<double> result = AnyPair<double, 3>(Erase(set_1), pose_1, Erase(set_2), pose_2).GrowthDistance();
  EXPECT_EQ(result.status, dgd::Status::kOptimal);
  const auto facing = dgd::FindFacingFaces(set_1, pose_1, set_2, pose_2, result);
  return dgd::FindContactPatch(
      result, facing, {.contact_distance = kContactDistance, .spacing = 0.01, .equal_depth = 1e-5}, is_approaching);
}

dgd::Pose<double> At(const Vector3d& place, double turn_about_z = 0) {
  return {Eigen::AngleAxisd(turn_about_z, Vector3d::UnitZ()).toRotationMatrix(), place};
}

// The common part of the two faces is a rectangle, half as long as the boxes: its corners.
TEST(ContactPatch, BoxHalfOnBox_FourCornersOfTheCommonRectangle) {
  const dgd::RoundedSet box{dgd::Box<double>({1, 0.5, 0.25})};
  const dgd::ContactPatch<double> patch = PatchOf(box, At({0, 0, 0}), box, At({1, 0, 0.499}));
  ASSERT_EQ(patch.size, 4);
  for (const double x : {0.0, 1.0}) {
    for (const double y : {-0.5, 0.5}) {
      EXPECT_TRUE(std::any_of(patch.points.begin(), patch.points.end(),
                              [&](const auto& point) {
                                return (point.on_1 - Vector3d(x, y, 0.25)).norm() < kTolerance &&
                                       (point.on_2 - Vector3d(x, y, 0.249)).norm() < kTolerance &&
                                       std::abs(point.separation + 0.001) < kTolerance;
                              }))
          << x << " " << y;
    }
  }
}

// A cylinder and a cone on end, tilted by what rounding and a solver's residue leave of upright: the points of every
// tilt are the same four of their rims, so that Bullet's impulses stay where they were. Before, the polygon that stands
// for the disc turned with the tilt, and bodies at rest trembled at 2 mm/s.
template <class Core>
void ExpectSteadyPoints(const Core& core, const Vector3d& place) {
  const dgd::RoundedSet ground{dgd::Box<double>({10, 10, 0.5})};
  const dgd::RoundedSet standing{core};
  Random random(TestSeed());
  dgd::ContactPatch<double> first;
  for (int i = 0; i < 100; ++i) {
    dgd::Pose<double> pose = At(place);
    const Eigen::AngleAxisd tilt(i == 0 ? 0 : random.LogUniform(1e-15, 1e-7), random.UnitVector());
    pose.rotation = tilt.toRotationMatrix();
    const dgd::ContactPatch<double> patch = PatchOf(ground, At({0, 0, -0.5}), standing, pose);
    ASSERT_EQ(patch.size, 4);
    if (i == 0) first = patch;
    for (const auto& point : patch.points) {
      EXPECT_TRUE(std::any_of(first.points.begin(), first.points.end(), [&](const auto& other) {
        return (point.on_1 - other.on_1).norm() < 1e-6;
      })) << point.on_1.transpose();
    }
  }
}

TEST(ContactPatch, CylinderOnEnd_PointsStayWhereTheyAre) {
  ExpectSteadyPoints(dgd::Cylinder<double>(0.15, 0.3), {-0.6, 0, 0.3});
}

TEST(ContactPatch, ConeOnEnd_PointsStayWhereTheyAre) {
  ExpectSteadyPoints(dgd::Cone<double>(0.25, 0.6), {0.6, 0, 0.3});
}

// Lying crosswise, two capsules touch above the crossing; towards their ends, each point tells the true distance.
TEST(ContactPatch, CapsulesAlmostParallel_PointsTellTheDistanceBesideEachOther) {
  const double radius_1 = 0.03, radius_2 = 0.02, height = 0.049, angle = 0.5 * std::numbers::pi / 180;
  const dgd::RoundedSet capsule_1{dgd::Segment<double>(0.5), radius_1};
  const dgd::RoundedSet capsule_2{dgd::Segment<double>(0.5), radius_2};
  // Along x: the segment's z axis turned.
  const Eigen::Matrix3d lying = Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix();
  const dgd::Pose<double> pose_1{lying, {0, 0, 0}};
  const dgd::Pose<double> pose_2{Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix() * lying,
                                 {0, 0, height}};
  const dgd::ContactPatch<double> patch = PatchOf(capsule_1, pose_1, capsule_2, pose_2);
  ASSERT_GE(patch.size, 3) << "both ends and the crossing";
  EXPECT_NEAR(patch.points[0].separation, height - radius_1 - radius_2, kTolerance);
  for (int i = 0; i < patch.size; ++i) {
    const dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    const double beside = std::abs(point.on_1.x()) * std::tan(angle);
    EXPECT_NEAR(point.separation, std::hypot(height, beside) - radius_1 - radius_2, 1e-6) << point.on_1.x();
  }
}

// Elsewhere, the contact would spin the sphere. The box is overlapped near its edge, where the normal is not the
// face's.
TEST(ContactPatch, SphereInBoxEdge_PointOnTheLineThroughItsCentre) {
  const dgd::RoundedSet sphere{dgd::Point<double>(), 0.2};
  const dgd::RoundedSet box{dgd::Box<double>({1, 0.5, 0.25}), 0.04};
  const Vector3d center(0.1, 0.55, 0.4);
  for (const bool sphere_first : {true, false}) {
    const dgd::ContactPatch<double> patch = sphere_first ? PatchOf(sphere, At(center), box, At({0, 0, 0}))
                                                         : PatchOf(box, At({0, 0, 0}), sphere, At(center));
    ASSERT_EQ(patch.size, 1);
    const dgd::ContactPoint<double>& point = patch.points[0];
    const Vector3d normal = (point.on_2 - point.on_1) / point.separation;
    EXPECT_LT((point.on_1 - center).cross(normal).norm(), kTolerance);
    EXPECT_NEAR(((sphere_first ? point.on_1 : point.on_2) - center).norm(), 0.2, kTolerance);
  }
}

// A wall's open edge faces what lies on it, however the wall's own faces are turned away: its ends, or the box's.
TEST(ContactPatch, BoxOnTheEdgeOfATriangle_EndsOfTheCommonLine) {
  const dgd::RoundedSet box{dgd::Box<double>({1, 0.1, 0.02})};
  const dgd::RoundedSet wall{dgd::Triangle<double>({0, -1, 0}, {0, 0.5, -1}, {0, 1, 0}), 0.001};
  for (const bool wall_first : {true, false}) {
    const dgd::Pose<double> above = At({0, 0.2, 0.021});
    const dgd::ContactPatch<double> patch =
        wall_first ? PatchOf(wall, At({0, 0, 0}), box, above) : PatchOf(box, above, wall, At({0, 0, 0}));
    ASSERT_EQ(patch.size, 2);
    EXPECT_NEAR(patch.points[0].on_1.y() + patch.points[1].on_1.y(), 0.4, kTolerance);
    for (int i = 0; i < patch.size; ++i) {
      const dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
      EXPECT_NEAR(std::abs(point.on_1.y() - 0.2), 0.1, kTolerance);
      EXPECT_NEAR(point.on_1.x(), 0, kTolerance);
      EXPECT_NEAR(point.separation, 0, kTolerance);
    }
  }
}

// A box that stands on its edge over another: the far corners belong to the patch only if somebody says they come.
TEST(ContactPatch, TiltedBox_FarCornersOnlyIfTheyApproach) {
  const dgd::RoundedSet ground{dgd::Box<double>({2, 2, 1})};
  const dgd::RoundedSet box{dgd::Box<double>({0.5, 0.5, 0.5})};
  const double tilt = 0.2;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(tilt, Vector3d::UnitY()).toRotationMatrix();
  const double lowest = 0.5 * (std::cos(tilt) + std::sin(tilt));
  const dgd::Pose<double> pose{rotation, {0, 0, 1 + lowest}};
  EXPECT_EQ(PatchOf(ground, At({0, 0, 0}), box, pose).size, 2);
  const auto all = [](const Vector3d&, double separation) { return separation < 1; };
  const dgd::ContactPatch<double> patch = PatchOf(ground, At({0, 0, 0}), box, pose, all);
  ASSERT_EQ(patch.size, 4);
  for (const dgd::ContactPoint<double>& point : patch.points) EXPECT_GE(point.separation, -kTolerance);
}

// Found by fuzz_plugin_world: where the depth that is as good as the deepest is no number, the search for a corner of
// that depth ran past the last one.
TEST(ContactPatch, EqualDepthNaN_TheDeepestCornerIsKept) {
  const dgd::RoundedSet box{dgd::Box<double>({1, 0.5, 0.25})};
  const dgd::Pose<double> below = At({0, 0, 0}), above = At({1, 0, 0.499});
  const dgd::Result<double> result = dgd::GrowthDistance(box, below, box, above);
  const auto facing = dgd::FindFacingFaces(box, below, box, above, result);
  const double none = std::numeric_limits<double>::quiet_NaN();
  const dgd::ContactPatch<double> patch = dgd::FindContactPatch(
      result, facing, {.contact_distance = kContactDistance, .spacing = 0.01, .equal_depth = none}, Never);
  ASSERT_GE(patch.size, 1);
  EXPECT_NEAR(patch.points[0].separation, -0.001, kTolerance);
}

}  // namespace
}  // namespace dgd_test
