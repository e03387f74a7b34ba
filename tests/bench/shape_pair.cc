#include "bench/shape_pair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "bench/referee.h"
#include "scene/random_polytope.h"
#include "support/pairs/any_pair.h"
#include "support/place_at_distance.h"

namespace dgd_bench {
namespace {

using dgd_demos::Random;
using dgd_test::PairNumbers;
using dgd_test::PoseNumbers;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;

constexpr int kLeastVertices = 8;
constexpr int kMostVertices = 20;
constexpr double kPlacementError = 1e-9;  // Of the distance from the drawn one, m: a thousandth of what "touching" is.
constexpr double kMotion = 0.01;          // From the last pose, as a share of the size, and in radians.
constexpr double kRoom = 1.0;  // First set's position, each coordinate, m: poses are not centred on the origin.

Vector3d LengthsOf(Random& random, double least, double greatest) {
  return random.InBox(Vector3d::Constant(least), Vector3d::Constant(greatest));
}

SetNumbers DrawSet(Random& random, SetType type, double margin) {
  SetNumbers set{.type = type, .radius = margin};
  switch (type) {
    case SetType::kSegment:
      set.lengths[0] = random.Uniform(0.1, 0.4);
      set.radius = random.Uniform(0.1, 0.25);
      break;
    case SetType::kBox:
      set.lengths = LengthsOf(random, 0.1, 0.5);
      break;
    case SetType::kCylinder:
      set.lengths = LengthsOf(random, 0.15, 0.4);
      break;
    case SetType::kCone:
      set.lengths = {random.Uniform(0.2, 0.5), random.Uniform(0.3, 0.9), 0};
      break;
    case SetType::kEllipsoid:
      set.lengths = LengthsOf(random, 0.15, 0.5);
      break;
    case SetType::kPolytope:
      set.points =
          dgd_demos::RandomPolytope(random, random.Integer(kLeastVertices, kMostVertices), kShapeSize).vertices;
      break;
    default:
      throw std::invalid_argument(std::string("no size for a ") + InfoOf(type).name);
  }
  return set;
}

// Moves set 2 along `direction` from set 1's position until the signed distance is `wanted`; false if the sets are not
// that deep there, or the bounds on the distance do not close in.
bool Place(PairNumbers& sets, const Vector3d& direction, double wanted) {
  // Of the cores: the bounds close in sooner, and on polytopes exactly. The radii are taken off.
  PairNumbers cores = sets;
  cores.set_1.radius = cores.set_2.radius = 0;
  const double radii = sets.set_1.radius + sets.set_2.radius;
  dgd_test::AnyPair<double, 3> posed(cores);
  double uncertainty = 0;
  const auto distance_at = [&](double way) {
    sets.pose_2.translation = sets.pose_1.translation + way * direction;
    posed.MoveTo(sets.pose_1, sets.pose_2);
    const dgd_test::DistanceBounds bounds = BoundSignedDistance(posed);
    uncertainty = bounds.upper - bounds.lower;
    return dgd_test::DistanceOnLine{bounds.lower - radii, -bounds.normal.dot(direction)};
  };
  const double outside = 2 * (kShapeSize + radii) + std::max(0.0, wanted);
  return dgd_test::PlaceAtDistance(distance_at, outside, wanted, kPlacementError) && uncertainty <= kPlacementError;
}

PoseNumbers MovedALittle(Random& random, const PoseNumbers& pose) {
  const Vector3d way = kMotion * kShapeSize * random.UnitVector();
  const Eigen::AngleAxisd turn(kMotion, random.UnitVector());
  return {turn.toRotationMatrix() * pose.rotation, pose.translation + way};
}

}  // namespace

ShapePair DrawShapePair(Random& random, const ShapeKind& kind, const DistanceClass& distance_class, double margin) {
  const double radius = kind.takes_margin ? margin : 0;
  while (true) {
    ShapePair pair;
    PairNumbers& sets = pair.sets;
    sets.set_1 = DrawSet(random, kind.type_1, radius);
    sets.set_2 = DrawSet(random, kind.type_2, radius);
    sets.pose_1 = {random.Rotation(), random.InBox(Vector3d::Constant(-kRoom), Vector3d::Constant(kRoom))};
    sets.pose_2.rotation = random.Rotation();
    const double wanted = random.Uniform(distance_class.low, distance_class.high);
    if (!Place(sets, random.UnitVector(), wanted)) continue;
    pair.last_pose_2 = MovedALittle(random, sets.pose_2);
    return pair;
  }
}

}  // namespace dgd_bench
