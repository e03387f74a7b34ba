#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/hard/draw.h"

namespace dgd_test::hard {
namespace {

using Eigen::Vector3d;

constexpr std::array kFlatTypes = {SetType::kTriangle, SetType::kSegment, SetType::kPoint};

SetType FlatType(int number) { return kFlatTypes[static_cast<std::size_t>(number) % kFlatTypes.size()]; }

SetNumbers FlatSet(Random& random, SetType type) { return RandomSetOf(random, type, {0.3, 1}, false); }

using Points = std::vector<Vector3d>;

/// The corners of a cube, and more points on its faces and edges.
Points WithPointsOnFaces(Random& random) {
  Points points;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const bool is_corner = std::abs(x * y * z) == 8, is_on_face = std::abs(x) == 2 || std::abs(y) == 2;
        if (is_corner || (is_on_face && random.Flip())) points.push_back(0.25 * Vector3d(x, y, z));
      }
    }
  }
  return points;
}

/// Each point several times, the same or nearly.
Points WithDuplicates(Random& random) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    const Vector3d point = 0.5 * random.UnitVector();
    for (int copy = 0; copy < 3; ++copy) {
      points.push_back(point);
      if (random.Flip()) points.back() += random.LogUniform(1e-17, 1e-6) * random.UnitVector();
    }
  }
  return points;
}

/// All but in a plane, or on a line.
Points Squashed(Random& random) {
  const double thickness = random.LogUniform(1e-14, 1e-3);
  const Vector3d squash = random.Flip() ? Vector3d(1, 1, thickness) : Vector3d(1, thickness, thickness);
  Points points;
  for (int i = 0; i < 20; ++i) points.push_back(squash.cwiseProduct(0.5 * random.UnitVector()));
  return points;
}

/// A prism with so many sides that three of its vertices are nearly on a line.
Points FineRing(Random& random) {
  const int sides = static_cast<int>(random.LogUniform(20, 300));
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {-0.25, 0.25}) points.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle), z);
  }
  return points;
}

}  // namespace

HardCase DrawFlatAgainstSolid(Random& random, int index) {
  PairNumbers pair{FlatSet(random, FlatType(index)), UnitSet(random, RandomSolidType(random)), {}, {}};
  if (random.Flip()) std::swap(pair.set_1, pair.set_2);
  return PlacedAnyhow(random, pair);
}

HardCase DrawFlatAgainstFlat(Random& random, int index) {
  PairNumbers pair{FlatSet(random, FlatType(index)), FlatSet(random, FlatType(index / 3)), {}, {}};
  // Without any, there is no growth distance, and the solver has to say so.
  const bool has_interior = random.Below(8) != 0;
  if (has_interior) pair.set_1.radius = random.LogUniform(1e-6, 1e-1);
  if (random.Flip()) pair.set_2.radius = pair.set_1.radius;
  const bool in_one_plane = random.Below(3) == 0;
  if (has_interior && !in_one_plane) return PlacedAnyhow(random, pair);
  pair.pose_2.translation = random.LogUniform(0.1, 2) * Vector3d::UnitX();
  for (SetNumbers* set : {&pair.set_1, &pair.set_2}) {
    for (Vector3d& point : set->points) point.y() = in_one_plane ? 0 : point.y();
  }
  MoveBoth(random, pair);
  return {pair};
}

HardCase DrawThinTriangles(Random& random, int index) {
  SetNumbers triangle;
  triangle.type = SetType::kTriangle;
  const Vector3d end = 0.5 * random.UnitVector();
  Vector3d third = random.Flip() ? Vector3d(random.Uniform(-1.5, 1.5) * end) : end;
  // Duplicate or collinear exactly, or all but.
  if (random.Flip()) third += random.LogUniform(1e-18, 1e-3) * random.UnitVector();
  triangle.points = {end, -end, third};
  if (random.Below(8) == 0) triangle.points = {end, end, end};
  PairNumbers pair{triangle, UnitSet(random, TypeOfSpace(index)), {}, {}};
  GiveInterior(pair);
  return PlacedAnyhow(random, pair);
}

HardCase DrawDegenerateHulls(Random& random, int index) {
  const auto hull = [&random](int kind) {
    SetNumbers set;
    set.type = random.Flip() ? SetType::kPolytope : SetType::kMesh;
    using Draw = Points (*)(Random&);
    constexpr std::array<Draw, 4> kKinds = {WithPointsOnFaces, WithDuplicates, Squashed, FineRing};
    set.points = kKinds[static_cast<std::size_t>(kind) % kKinds.size()](random);
    set.radius = random.Below(3) == 0 ? 0.04 : 0;
    return set;
  };
  PairNumbers pair{hull(index), random.Flip() ? hull(index / 4) : UnitSet(random, RandomSolidType(random)), {}, {}};
  return PlacedAnyhow(random, pair);
}

}  // namespace dgd_test::hard
