#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "support/hard/draw.h"

namespace dgd_test::hard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kQuarter = std::numbers::pi / 2;

Matrix3d AboutX(double angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitX()).toRotationMatrix(); }
Matrix3d AboutZ(double angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(); }

/// From 0 to 1: either end, nearly so, or anywhere.
double ShareOfTilt(Random& random) {
  const double share = random.Below(3) == 0 ? random.Uniform(0, 1) : random.Flip() ? 0 : random.LogUniform(1e-12, 1e-2);
  return random.Flip() ? share : 1 - share;
}

/// In its pose, below the plane z = 0, which it touches in the origin.
struct Toucher {
  SetNumbers set;
  PoseNumbers pose;
};

/// A cone, apex up, upright to leaning until its side lies in the plane.
Toucher TippedCone(Random& random) {
  Toucher cone;
  cone.set.type = SetType::kCone;
  cone.set.lengths = {random.LogUniform(0.05, 1), random.LogUniform(0.05, 1), 0};
  const double half_angle = std::atan2(cone.set.lengths[0], cone.set.lengths[1]);
  cone.pose.rotation = AboutX(ShareOfTilt(random) * (kQuarter - half_angle));
  cone.pose.translation = cone.pose.rotation * Vector3d(0, 0, -cone.set.lengths[1] / 2);
  return cone;
}

/// A cylinder or frustum, its rim up: from its cap in the plane to its side.
Toucher TippedCylinder(Random& random) {
  Toucher cylinder;
  SetNumbers& set = cylinder.set;
  const double radius = random.LogUniform(0.05, 1), half_height = random.LogUniform(0.05, 1);
  set.type = random.Flip() ? SetType::kCylinder : SetType::kFrustum;
  const double base_radius = radius * random.Uniform(0, 1);
  set.lengths = set.type == SetType::kCylinder ? Vector3d(radius, half_height, 0)
                                               : Vector3d(base_radius, radius, 2 * half_height);
  cylinder.pose.rotation = AboutX(ShareOfTilt(random) * kQuarter);
  cylinder.pose.translation = -(cylinder.pose.rotation * Vector3d(0, radius, half_height));
  return cylinder;
}

/// A box, below the plane on its face.
Toucher LyingBox(Random& random) {
  Toucher box;
  box.set.type = random.Flip() ? SetType::kBox : SetType::kPlainBox;
  box.set.lengths = {random.LogUniform(0.05, 1), random.LogUniform(0.05, 1), random.LogUniform(0.05, 1)};
  box.pose.translation.z() = -box.set.lengths.z();
  return box;
}

/// The first below the plane, the second mirrored above it and turned about the common point.
HardCase PutTogether(Random& random, const Toucher& below, const Toucher& above) {
  const Matrix3d turned =
      AboutZ(random.Flip() ? kQuarter * random.Below(4) : random.Uniform(-3, 3)) * AboutX(2 * kQuarter);
  PairNumbers pair{below.set, above.set, below.pose, {turned * above.pose.rotation, turned * above.pose.translation}};
  MoveBoth(random, pair);
  return {pair, Side::kTouching};
}

}  // namespace

HardCase DrawConeTips(Random& random, int index) {
  const Toucher cone = TippedCone(random);
  switch (index % 3) {
    case 0:
      return PutTogether(random, cone, LyingBox(random));
    case 1:
      return PutTogether(random, cone, TippedCone(random));
    default:
      return PutTogether(random, cone, TippedCylinder(random));
  }
}

HardCase DrawRims(Random& random, int index) {
  const Toucher cylinder = TippedCylinder(random);
  return PutTogether(random, cylinder, index % 3 == 0 ? LyingBox(random) : TippedCylinder(random));
}

}  // namespace dgd_test::hard
