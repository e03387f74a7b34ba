#include "core/hull_pair.h"

#include <algorithm>

#include "scene/random_polytope.h"
#include "simulation/signed_distance.h"
#include "support/place_at_distance.h"

namespace dgd_test {
namespace {

using dgd_demos::PosedPolyhedron;
using dgd_demos::Random;
using dgd_demos::SignedDistance;
using Eigen::Vector3d;

constexpr int kLeastVertices = 8;
constexpr int kMostVertices = 20;
constexpr double kDiameter = 1.0;          // Greatest distance of two vertices, m.
constexpr double kPlacementError = 1e-12;  // m; a thousandth of the error that the tests allow.
constexpr double kRoom = 1.0;  // First hull's position, each coordinate, m: poses are not centred on the origin.

// Moves hull 2 along `direction` from hull 1's position until the sets have the signed distance `wanted`; false if
// they are not that deep there.
bool Place(HullPair& pair, const Vector3d& direction, double wanted) {
  const PosedPolyhedron first(pair.core_1, pair.pose_1);
  const auto distance_at = [&](double way) {
    pair.pose_2.position = pair.pose_1.position + way * direction;
    const SignedDistance cores = ComputeSignedDistance(first, PosedPolyhedron(pair.core_2, pair.pose_2));
    pair.signed_distance = cores.value - 2 * pair.margin;
    return DistanceOnLine{pair.signed_distance, cores.normal.dot(direction)};
  };
  const double outside = 2 * (kDiameter + pair.margin) + std::max(0.0, wanted);
  return PlaceAtDistance(distance_at, outside, wanted, kPlacementError);
}

}  // namespace

HullPair DrawHullPair(Random& random, double least, double greatest, double margin) {
  while (true) {
    HullPair pair;
    pair.core_1 = dgd_demos::RandomPolytope(random, random.Integer(kLeastVertices, kMostVertices), kDiameter);
    pair.core_2 = dgd_demos::RandomPolytope(random, random.Integer(kLeastVertices, kMostVertices), kDiameter);
    pair.pose_1 = {random.Rotation(), random.InBox(Vector3d::Constant(-kRoom), Vector3d::Constant(kRoom))};
    pair.pose_2.rotation = random.Rotation();
    pair.margin = margin;
    const double wanted = random.Uniform(least, greatest);
    if (Place(pair, random.UnitVector(), wanted)) return pair;
  }
}

double NormalError(const HullPair& pair, const Vector3d& normal) {
  const double separation =
      dgd_demos::SeparationAlong(normal.normalized(), {pair.core_1, pair.pose_1}, {pair.core_2, pair.pose_2}) -
      2 * pair.margin;
  return pair.signed_distance - separation;
}

}  // namespace dgd_test
