#include "support/hard/draw.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace dgd_test::hard {
namespace {

using Eigen::Vector3d;

constexpr int kTypesOfSpace = static_cast<int>(SetType::kSuperellipsoid) + 1;

Side SideOf(double growth_distance) {
  // Nearer to 1, the rounding of the poses decides.
  constexpr double kClear = 1e-6;
  if (growth_distance == 0) return Side::kUnknown;
  if (growth_distance == 1) return Side::kTouching;
  if (std::abs(growth_distance - 1) < kClear) return Side::kUnknown;
  return growth_distance > 1 ? Side::kApart : Side::kOverlapping;
}

}  // namespace

SetType TypeOfSpace(int index) { return static_cast<SetType>(index % kTypesOfSpace); }

SetType RandomSolidType(Random& random) {
  SetType type;
  do type = TypeOfSpace(random.Below(kTypesOfSpace));
  while (!InfoOf(type).is_solid);
  return type;
}

SetNumbers UnitSet(Random& random, SetType type) { return RandomSetOf(random, type, {0.3, 1}, random.Below(3) == 0); }

SetNumbers Scaled(const SetNumbers& set, double factor) {
  SetNumbers scaled = set;
  scaled.lengths *= factor;
  for (Vector3d& point : scaled.points) point *= factor;
  scaled.radius *= factor;
  return scaled;
}

void GiveInterior(PairNumbers& pair) {
  constexpr double kRadius = 0.05;
  if (!pair.set_1.HasInterior() && !pair.set_2.HasInterior()) pair.set_1.radius = kRadius;
}

HardCase PlacedAnyhow(Random& random, PairNumbers pair) {
  const auto placement = static_cast<Placement>(random.Below(kPlacementCount));
  const double growth_distance = Place(random, placement, pair);
  return {std::move(pair), SideOf(growth_distance)};
}

void MoveBoth(Random& random, PairNumbers& pair) {
  Eigen::Matrix3d rotation = random.Rotation();
  if (random.Flip()) {
    rotation.setZero();
    const int first = random.Below(3);
    for (int i = 0; i < 3; ++i) rotation((first + i) % 3, i) = 1;
  }
  const Vector3d translation = random.Flip() ? Vector3d(Vector3d::Zero()) : random.InCube();
  for (PoseNumbers* pose : {&pair.pose_1, &pair.pose_2}) {
    pose->rotation = rotation * pose->rotation;
    pose->translation = rotation * pose->translation + translation;
  }
}

double TinyGap(Random& random, double least, double greatest) {
  const double gap = random.LogUniform(least, greatest);
  const int kind = random.Below(3);
  return kind == 0 ? 0 : kind == 1 ? gap : -gap;
}

}  // namespace dgd_test::hard
