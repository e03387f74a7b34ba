#include <Eigen/Geometry>

#include "support/hard/draw.h"

namespace dgd_test::hard {
namespace {

using Eigen::Vector3d;

/// Thin in one direction of its frame, or in two.
SetNumbers SkewedSet(Random& random, SetType type, double skew) {
  SetNumbers set = RandomSetOf(random, type, {0.5, 1}, false);
  const int axis = random.Below(3);
  const bool is_needle = random.Flip();
  Vector3d squash = Vector3d::Constant(is_needle ? 1 / skew : 1);
  squash[axis] = is_needle ? 1 : 1 / skew;
  set.lengths = set.lengths.cwiseProduct(squash);
  for (Vector3d& point : set.points) point = point.cwiseProduct(squash);
  if (random.Below(4) == 0) set.radius = random.LogUniform(0.1, 1) / skew;
  return set;
}

PairNumbers UnitPair(Random& random, int index) {
  PairNumbers pair{UnitSet(random, TypeOfSpace(index)), UnitSet(random, TypeOfSpace(random.Below(1000))), {}, {}};
  GiveInterior(pair);
  return pair;
}

HardCase DrawAtScale(Random& random, int index, double least, double greatest) {
  PairNumbers pair = UnitPair(random, index);
  const double scale = random.LogUniform(least, greatest);
  pair.set_1 = Scaled(pair.set_1, scale);
  pair.set_2 = Scaled(pair.set_2, scale);
  return PlacedAnyhow(random, pair);
}

}  // namespace

HardCase DrawNeedlesAndSheets(Random& random, int index) {
  constexpr double kMostSkew = 1e4;
  const auto skew = [&random] { return random.LogUniform(10, kMostSkew); };
  PairNumbers pair{
      SkewedSet(random, TypeOfSpace(index), skew()), SkewedSet(random, RandomSolidType(random), skew()), {}, {}};
  return PlacedAnyhow(random, pair);
}

HardCase DrawSizeRatios(Random& random, int index) {
  PairNumbers pair = UnitPair(random, index);
  pair.set_2 = Scaled(pair.set_2, random.LogUniform(1e-6, 1e-2));
  if (random.Flip()) std::swap(pair.set_1, pair.set_2);
  return PlacedAnyhow(random, pair);
}

HardCase DrawMicrometres(Random& random, int index) { return DrawAtScale(random, index, 1e-7, 1e-5); }
HardCase DrawKilometres(Random& random, int index) { return DrawAtScale(random, index, 1e2, 1e4); }

HardCase DrawDeepInside(Random& random, int index) {
  PairNumbers pair{UnitSet(random, RandomSolidType(random)), UnitSet(random, TypeOfSpace(index)), {}, {}};
  pair.set_2 = Scaled(pair.set_2, random.LogUniform(1e-4, 0.05));
  if (random.Flip()) std::swap(pair.set_1, pair.set_2);
  Place(random, Placement::kNearlyCoincident, pair);
  return {pair, Side::kOverlapping};
}

HardCase DrawMargins(Random& random, int index) {
  PairNumbers pair = UnitPair(random, index);
  const auto any_radius = [&random] { return random.Below(3) == 0 ? 0 : random.LogUniform(1e-12, 1e4); };
  pair.set_1.radius = any_radius();
  pair.set_2.radius = any_radius();
  GiveInterior(pair);
  return PlacedAnyhow(random, pair);
}

HardCase DrawInThePlane(Random& random, int index) {
  constexpr int kFirst = static_cast<int>(SetType::kCircle), kTypes = static_cast<int>(kSetTypeCount) - kFirst;
  const auto type = [](int number) { return static_cast<SetType>(kFirst + number % kTypes); };
  PairNumbers pair{SkewedSet(random, type(index), random.LogUniform(1, 1e4)),
                   SkewedSet(random, type(index / kTypes), random.LogUniform(1, 1e4)),
                   {},
                   {}};
  GiveInterior(pair);
  if (random.Below(3) == 0) pair.set_2 = Scaled(pair.set_2, random.LogUniform(1e-6, 1));
  return PlacedAnyhow(random, pair);
}

}  // namespace dgd_test::hard
