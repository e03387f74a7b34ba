#include "support/random_sets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dgd_test {
namespace {

using Eigen::Vector3d;

double RandomLength(Random& random) { return random.LogUniform(kSmallest, kLargest); }

Vector3d RandomLengths(Random& random) {
  const double x = RandomLength(random);
  const double y = RandomLength(random);
  const double z = RandomLength(random);
  return {x, y, z};
}

/// How far set 2 must be from set 1 along `direction` for the two to touch: the lowest of some supporting planes of
/// their difference, so never too low, and mostly by less than a factor of two too high.
double TouchingDistance(const ReferencePair& pair, const Vector3d& direction) {
  constexpr int kPlanes = 200;
  Random random(7);
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPlanes; ++i) {
    Vector3d normal = (i == 0) ? direction : random.UnitVector();
    if (normal.dot(direction) < 0) normal = -normal;
    if (normal.dot(direction) < 1e-3) continue;
    const double above_1 = pair.set_1.Height(pair.pose_1.rotation.transpose() * normal) -
                           normal.dot(pair.pose_1.rotation * pair.set_1.Middle());
    const double below_2 = pair.set_2.Height(-(pair.pose_2.rotation.transpose() * normal)) +
                           normal.dot(pair.pose_2.rotation * pair.set_2.Middle());
    lowest = std::min(lowest, (above_1 + below_2) / normal.dot(direction));
  }
  return lowest;
}

}  // namespace

ReferenceSet RandomSet(Random& random, CoreType type, bool rounded) {
  ReferenceSet set;
  set.type = type;
  set.size = RandomLengths(random);
  set.radius = rounded ? RandomLength(random) : 0;
  const bool is_hull = type == CoreType::kPolytope || type == CoreType::kMesh;
  const int count = type == CoreType::kTriangle ? 3 : is_hull ? 4 + random.Below(27) : 0;
  for (int i = 0; i < count; ++i) {
    const double reach = random.Uniform(0.7, 1.0);
    set.points.push_back(set.size.cwiseProduct(reach * random.UnitVector()));
  }
  return set;
}

ReferenceSet RandomHull(Random& random, int count, double diameter, double radius) {
  ReferenceSet set;
  set.type = CoreType::kPolytope;
  set.radius = radius;
  for (int i = 0; i < count; ++i) {
    const double reach = diameter / 2 * random.Uniform(0.8, 1.0);
    set.points.push_back(reach * random.UnitVector());
  }
  return set;
}

void PlaceRandomly(Random& random, ReferencePair& pair, const Nearness& nearness) {
  pair.pose_1.rotation = random.Rotation();
  pair.pose_2.rotation = random.Rotation();
  pair.pose_1.translation = kLargest * random.InCube();
  const Vector3d direction = random.UnitVector();
  const double distance = TouchingDistance(pair, direction) * random.LogUniform(nearness.closest, nearness.farthest);
  pair.pose_2.translation =
      pair.pose_1 * pair.set_1.Middle() + distance * direction - pair.pose_2.rotation * pair.set_2.Middle();
}

ReferencePair RandomPair(Random& random, CoreType type_1, bool rounded_1, CoreType type_2, bool rounded_2) {
  ReferencePair pair;
  pair.set_1 = RandomSet(random, type_1, rounded_1);
  pair.set_2 = RandomSet(random, type_2, rounded_2);
  const bool has_interior = pair.set_1.IsSolid() || pair.set_2.IsSolid() || rounded_1 || rounded_2;
  if (!has_interior) pair.set_1.radius = RandomLength(random);
  PlaceRandomly(random, pair);
  return pair;
}

ReferencePair Moved(Random& random, const ReferencePair& pair, double amount) {
  ReferencePair moved = pair;
  const Vector3d axis = random.UnitVector();
  const Vector3d middle = pair.pose_2 * pair.set_2.Middle();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(amount, axis).toRotationMatrix();
  moved.pose_2.rotation = turn * pair.pose_2.rotation;
  const Vector3d shift = amount * pair.Extent() * random.UnitVector();
  moved.pose_2.translation = turn * (pair.pose_2.translation - middle) + middle + shift;
  return moved;
}

}  // namespace dgd_test
