#include <Eigen/Geometry>

#include "support/hard/draw.h"
#include "support/pairs/any_pair.h"

namespace dgd_test::hard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PairNumbers PairOfTypes(Random& random, int index) {
  PairNumbers pair{UnitSet(random, TypeOfSpace(index)), UnitSet(random, TypeOfSpace(random.Below(1000))), {}, {}};
  GiveInterior(pair);
  return pair;
}

/// At the origin, where tiny distances have digits.
HardCase WithCentersApartBy(Random& random, PairNumbers pair, double distance) {
  pair.pose_1.rotation = random.Rotation();
  pair.pose_2.rotation = random.Flip() ? pair.pose_1.rotation : random.Rotation();
  const AnyPair<double, 3> in_place(pair);
  pair.pose_1.translation = -in_place.Center(Which::kFirst);
  pair.pose_2.translation = distance * random.UnitVector() - in_place.Center(Which::kSecond);
  return {pair, Side::kOverlapping};
}

/// The largest subnormal numbers of float or of double, and less.
double Subnormal(Random& random) {
  return (random.Flip() ? 1 : -1) *
         (random.Flip() ? random.LogUniform(1e-45, 1e-38) : random.LogUniform(5e-324, 2e-308));
}

}  // namespace

HardCase DrawFarFromTheOrigin(Random& random, int index) {
  HardCase hard_case = PlacedAnyhow(random, PairOfTypes(random, index));
  const Vector3d far = random.LogUniform(1e3, 1e6) * random.UnitVector();
  hard_case.pair.pose_1.translation += far;
  hard_case.pair.pose_2.translation += far;
  hard_case.side = Side::kUnknown;  // Up to the rounding there.
  return hard_case;
}

HardCase DrawNearlyCoincident(Random& random, int index) {
  return WithCentersApartBy(random, PairOfTypes(random, index), random.LogUniform(1e-20, 1e-3));
}

HardCase DrawCoincident(Random& random, int index) { return WithCentersApartBy(random, PairOfTypes(random, index), 0); }

HardCase DrawIdentical(Random& random, int index) {
  PairNumbers pair;
  pair.set_1 = UnitSet(random, TypeOfSpace(index));
  if (!pair.set_1.HasInterior()) pair.set_1.radius = 0.1;
  pair.set_2 = pair.set_1;
  pair.pose_1 = pair.pose_2 = {random.Rotation(), random.InCube()};
  return {pair, Side::kOverlapping};
}

HardCase DrawRoughRotations(Random& random, int index) {
  constexpr double kRoughness = 1e-6;
  HardCase hard_case = PlacedAnyhow(random, PairOfTypes(random, index));
  for (PoseNumbers* pose : {&hard_case.pair.pose_1, &hard_case.pair.pose_2}) {
    Matrix3d noise;
    for (int column = 0; column < 3; ++column) noise.col(column) = random.InCube();
    pose->rotation += kRoughness / 3 * noise;
  }
  hard_case.side = Side::kUnknown;  // Up to the roughness.
  return hard_case;
}

HardCase DrawSubnormalOffsets(Random& random, int index) {
  const auto type = [](int number) {
    return InfoOf(TypeOfSpace(number)).is_solid ? TypeOfSpace(number) : SetType::kBox;
  };
  PairNumbers pair{UnitSet(random, type(index)), UnitSet(random, type(random.Below(1000))), {}, {}};
  // The other sizes are lengths that a subnormal number is nothing beside, and none at all.
  pair.pose_2.translation[random.Below(3)] = random.Below(4) == 0 ? Subnormal(random) : random.Uniform(0, 3);
  for (int i = 0; i < 3; ++i) {
    if (pair.pose_2.translation[i] == 0) pair.pose_2.translation[i] = Subnormal(random);
    pair.pose_1.translation[i] = Subnormal(random);
    pair.pose_1.rotation(i, (i + 1) % 3) = Subnormal(random);
  }
  return {pair};
}

HardCase DrawSubnormalSizes(Random& random, int index) {
  // Subnormal in float, in double; their squares are.
  constexpr double kSizes[] = {1e-40, 1e-310, 1e-21, 1e-157, 1e-30, 1e-200};
  // Placed while they still are sets.
  HardCase hard_case = PlacedAnyhow(random, PairOfTypes(random, index / 6));
  const double size = kSizes[index % 6];
  hard_case.pair.set_1 = Scaled(hard_case.pair.set_1, size);
  hard_case.pair.set_2 = Scaled(hard_case.pair.set_2, size);
  hard_case.pair.pose_1.translation *= size;
  hard_case.pair.pose_2.translation *= size;
  return hard_case;
}

}  // namespace dgd_test::hard
