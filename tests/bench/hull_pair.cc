#include "bench/hull_pair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/random_polytope.h"
#include "simulation/signed_distance.h"

namespace dgd_bench {
namespace {

using dgd_demos::ComputeSignedDistance;
using dgd_demos::Pose;
using dgd_demos::PosedPolyhedron;
using dgd_demos::Random;
using dgd_demos::SignedDistance;
using Eigen::Vector3d;

// Of the distance from the drawn one, m: a thousandth of a thousandth of what "touching" allows.
constexpr double kPlacementError = 1e-12;
constexpr int kMaxPlacementSteps = 60;
constexpr double kRoom = 1.0;  // First hull's position, each coordinate, m: poses are not centred on the origin.

// Moves hull 2 along `direction` from hull 1's position until the cores have the signed distance `wanted`: nothing if
// the hulls are not that deep there. As a function of the translation, the signed distance to a convex set is convex,
// and its slope along the way is the normal's: Newton's method from outside comes down monotonically and cannot miss.
std::optional<double> Place(HullPair& pair, const Vector3d& direction, double wanted) {
  const PosedPolyhedron first(pair.core_1, pair.pose_1);
  const auto distance_at = [&](double way) {
    pair.pose_2.position = pair.pose_1.position + way * direction;
    return ComputeSignedDistance(first, PosedPolyhedron(pair.core_2, pair.pose_2));
  };
  if (distance_at(0).value >= wanted) return std::nullopt;
  double way = 2 * kHullDiameter + std::max(0.0, wanted);
  for (int step = 0; step < kMaxPlacementSteps; ++step) {
    const SignedDistance distance = distance_at(way);
    if (std::abs(distance.value - wanted) <= kPlacementError) return distance.value;
    way -= (distance.value - wanted) / distance.normal.dot(direction);
  }
  return std::nullopt;
}

Pose MovedALittle(Random& random, const Pose& pose) {
  const Vector3d way = kMotion * kHullDiameter * random.UnitVector();
  const Eigen::AngleAxisd turn(kMotion, random.UnitVector());
  return {turn.toRotationMatrix() * pose.rotation, pose.position + way};
}

}  // namespace

HullPair DrawHullPair(Random& random, const DistanceClass& distance_class, DistanceOf distance_of, double margin) {
  while (true) {
    HullPair pair;
    pair.core_1 = dgd_demos::RandomPolytope(random, random.Integer(kLeastVertices, kMostVertices), kHullDiameter);
    pair.core_2 = dgd_demos::RandomPolytope(random, random.Integer(kLeastVertices, kMostVertices), kHullDiameter);
    pair.pose_1 = {random.Rotation(), random.InBox(Vector3d::Constant(-kRoom), Vector3d::Constant(kRoom))};
    pair.pose_2.rotation = random.Rotation();
    pair.margin = margin;

    const double drawn = random.Uniform(distance_class.low, distance_class.high);
    const double of_cores = distance_of == DistanceOf::kSets ? drawn + 2 * margin : drawn;
    const std::optional<double> placed = Place(pair, random.UnitVector(), of_cores);
    if (!placed) continue;
    pair.signed_distance = *placed - 2 * margin;
    pair.last_pose_2 = MovedALittle(random, pair.pose_2);
    return pair;
  }
}

double NormalError(const HullPair& pair, const Vector3d& normal) {
  const double separation =
      dgd_demos::SeparationAlong(normal.normalized(), {pair.core_1, pair.pose_1}, {pair.core_2, pair.pose_2}) -
      2 * pair.margin;
  return pair.signed_distance - separation;
}

}  // namespace dgd_bench
