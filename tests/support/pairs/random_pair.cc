#include "support/pairs/random_pair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace dgd_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kFewestPoints = 4;
constexpr int kMostPoints = 30;
constexpr int kMostMeshPoints = 150;
constexpr double kLeastExponent = 2.5, kLargestExponent = 40;

std::size_t PointCount(Random& random, SetType type) {
  switch (type) {
    case SetType::kTriangle:
      return 3;
    case SetType::kAffineBox:
    case SetType::kAffineCylinder:
      return 1;  // The offset.
    case SetType::kPolytope:
    case SetType::kDsf:
    case SetType::kPolygon:
      return static_cast<std::size_t>(kFewestPoints + random.Below(kMostPoints - kFewestPoints + 1));
    case SetType::kMesh:
      return static_cast<std::size_t>(random.LogUniform(kMostPoints, kMostMeshPoints));
    default:
      return 0;
  }
}

template <int L>
dgd::Vector<double, L> UnitVector(Random& random) {
  return RandomUnitVector(random, L).template head<L>();
}

/// A point of the set about its centre, mostly near its border: between support points of L directions.
template <int L>
dgd::Vector<double, L> PointFromCenter(Random& random, const AnyPair<double, L>& pair, Which which) {
  dgd::Vector<double, L> sum = dgd::Vector<double, L>::Zero();
  double weights = 0;
  for (int i = 0; i < L; ++i) {
    const double weight = random.Uniform(0, 1);
    const dgd::Vector<double, L> direction = UnitVector<L>(random);
    sum += weight * pair.SupportFromCenter(which, direction);
    weights += weight;
  }
  return sum / weights;
}

/// The way between the centres along which the placement puts them, and the growth distance there if it is known.
template <int L>
struct Way {
  dgd::Vector<double, L> between_centers;
  double growth_distance;  ///< 0 if unknown.
};

/// With set 1's support point along a normal on set 2's against it, the two touch: scaled ways scale the growth
/// distance.
template <int L>
Way<L> TouchingWay(Random& random, const AnyPair<double, L>& pair, double scale) {
  for (;;) {
    const dgd::Vector<double, L> normal = UnitVector<L>(random);
    const dgd::Vector<double, L> way =
        pair.SupportFromCenter(Which::kFirst, normal) - pair.SupportFromCenter(Which::kSecond, -normal);
    // Along an edge-on flat set, there is no plane between.
    if (normal.dot(way) > 1e-6 * way.norm()) return {scale * way, scale};
  }
}

template <int L>
Way<L> GenericWay(Random& random, const AnyPair<double, L>& pair, double closest, double farthest) {
  const dgd::Vector<double, L> point_1 = PointFromCenter(random, pair, Which::kFirst);
  const dgd::Vector<double, L> point_2 = PointFromCenter(random, pair, Which::kSecond);
  return {random.LogUniform(closest, farthest) * (point_1 - point_2), 0};
}

/// Half of them face to face and centred, the others shifted sideways.
template <int L>
Way<L> AxisWay(Random& random, const AnyPair<double, L>& pair, const dgd::Vector<double, L>& axis, bool may_shift) {
  const double reach =
      pair.SupportFromCenter(Which::kFirst, axis).dot(axis) - pair.SupportFromCenter(Which::kSecond, -axis).dot(axis);
  const double share = random.Flip() ? 1 : random.LogUniform(0.1, 5);
  dgd::Vector<double, L> way = share * std::max(reach, pair.Inradii()) * axis;
  if (may_shift && random.Flip()) {
    const dgd::Vector<double, L> shift = random.Uniform(0, 0.5) * pair.Extent() * UnitVector<L>(random);
    way += shift - axis.dot(shift) * axis;
  }
  return {way, 0};
}

template <int L>
Way<L> RandomWay(Random& random, Placement placement, const AnyPair<double, L>& pair, const Matrix3d& rotation_1) {
  const auto random_axis = [&random] {
    const int axis = random.Below(L);
    return dgd::Vector<double, L>((random.Flip() ? 1.0 : -1.0) * dgd::Vector<double, L>::Unit(axis));
  };
  switch (placement) {
    case Placement::kGeneric:
      return GenericWay(random, pair, 0.05, 10);
    case Placement::kTouching:
      return TouchingWay(random, pair, 1);
    case Placement::kNearlyTouching: {
      const double sign = random.Flip() ? 1 : -1;
      return TouchingWay(random, pair, 1 + sign * random.LogUniform(1e-15, 1e-3));
    }
    case Placement::kAligned:
      return AxisWay<L>(random, pair, random_axis(), true);
    case Placement::kAlongAxis:
      return AxisWay<L>(random, pair, rotation_1.topLeftCorner<L, L>() * random_axis(), false);
    case Placement::kNearlyCoincident:
      return GenericWay(random, pair, 1e-10, 1e-3);
    case Placement::kFarApart:
      break;
  }
  return GenericWay(random, pair, 10, 1e4);
}

template <int L>
double PlaceIn(Random& random, Placement placement, PairNumbers& numbers) {
  const bool is_aligned = placement == Placement::kAligned;
  numbers.pose_1.rotation = is_aligned ? Matrix3d::Identity() : RandomRotation(random, L);
  const bool same_rotation = is_aligned || (placement == Placement::kAlongAxis && random.Flip());
  numbers.pose_2.rotation = same_rotation ? numbers.pose_1.rotation : RandomRotation(random, L);
  numbers.pose_1.translation = numbers.pose_2.translation = Vector3d::Zero();

  const AnyPair<double, L> pair(numbers);
  const double reach = pair.Extent();
  numbers.pose_1.translation.head<L>() = reach * random.InCube().head<L>();
  const Way<L> way = RandomWay<L>(random, placement, pair, numbers.pose_1.rotation);
  numbers.pose_2.translation.head<L>() = numbers.pose_1.translation.head<L>() + pair.Center(Which::kFirst) +
                                         way.between_centers - pair.Center(Which::kSecond);
  return way.growth_distance;
}

}  // namespace

SetNumbers RandomSetOf(Random& random, SetType type, const LengthRange& lengths, bool is_rounded) {
  const auto random_length = [&] { return random.LogUniform(lengths.least, lengths.greatest); };
  const int dimension = InfoOf(type).dimension;
  SetNumbers set;
  set.type = type;
  for (double& length : set.lengths) length = random_length();
  set.radius = is_rounded ? random_length() : 0;
  if (type == SetType::kDsf || type == SetType::kSuperellipsoid || type == SetType::kSuperellipse) {
    set.exponent = random.LogUniform(kLeastExponent, kLargestExponent);
  }
  if (type == SetType::kAffineBox || type == SetType::kAffineCylinder) {
    const Eigen::Vector3d stretches(random.LogUniform(0.3, 3), random.LogUniform(0.3, 3), random.LogUniform(0.3, 3));
    const Eigen::Matrix3d first = random.Rotation();
    set.stretch = random.Rotation() * stretches.asDiagonal() * first;
  }
  const std::size_t count = PointCount(random, type);
  for (std::size_t i = 0; i < count; ++i) {
    const double part = random.Uniform(0.7, 1.0);
    set.points.push_back(set.lengths.cwiseProduct(part * RandomUnitVector(random, dimension)));
  }
  return set;
}

PairNumbers RandomPairOfAnyTypes(Random& random, const LengthRange& lengths) {
  PairNumbers pair;
  do {
    for (SetNumbers* set : {&pair.set_1, &pair.set_2}) {
      SetType type;
      do type = static_cast<SetType>(random.Below(static_cast<int>(kSetTypeCount)));
      while (InfoOf(type).dimension != 3);
      *set = RandomSetOf(random, type, lengths, random.Flip());
    }
  } while (!pair.set_1.HasInterior() && !pair.set_2.HasInterior());
  return pair;
}

Matrix3d RandomRotation(Random& random, int dimension) {
  if (dimension == 3) return random.Rotation();
  const double angle = random.Uniform(-std::numbers::pi, std::numbers::pi);
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

Vector3d RandomUnitVector(Random& random, int dimension) {
  if (dimension == 3) return random.UnitVector();
  const double angle = random.Uniform(-std::numbers::pi, std::numbers::pi);
  return {std::cos(angle), std::sin(angle), 0};
}

const char* NameOf(Placement placement) {
  static const char* const kNames[] = {"generic",    "touching",          "nearly touching", "aligned",
                                       "along axis", "nearly coincident", "far apart"};
  return kNames[static_cast<int>(placement)];
}

double Place(Random& random, Placement placement, PairNumbers& pair) {
  return InfoOf(pair.set_1.type).dimension == 2 ? PlaceIn<2>(random, placement, pair)
                                                : PlaceIn<3>(random, placement, pair);
}

PoseNumbers MovedALittle(Random& random, const PoseNumbers& pose, int dimension, double amount, double extent) {
  const Vector3d axis = dimension == 3 ? random.UnitVector() : Vector3d((random.Flip() ? 1 : -1) * Vector3d::UnitZ());
  PoseNumbers moved = pose;
  moved.rotation = Eigen::AngleAxisd(amount, axis).toRotationMatrix() * pose.rotation;
  moved.translation += amount * extent * RandomUnitVector(random, dimension);
  return moved;
}

}  // namespace dgd_test
