// Answers known in closed form.
//
// Most come from one observation: where the line through the centres leaves both sets through a point of a supporting
// plane orthogonal to it (the middle of a face, a cap or a base, the side of a cylinder, an apex), the sets' reaches
// along that line add up, and the growth distance is the distance of the centres over their sum. Every type of core has
// such features, so every pair of types is checked; turned about the line by right angles, where everything is aligned
// and symmetric, by 45 degrees, and by any angle.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/checks.h"
#include "support/random_sets.h"
#include "support/scalars.h"

namespace dgd_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Where a ray from the centre leaves a core through its supporting plane.
struct Feature {
  std::string name;
  ReferenceSet set;
  Vector3d direction;  ///< Unit, set's frame.
  double reach;        ///< Metres, of the core.
  bool unique_normal;  ///< No other supporting plane holds the point.
};

std::vector<Vector3d> Octahedron() { return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}; }

std::vector<Vector3d> Cube() { return WorldVertices({.type = CoreType::kBox, .size = {1, 1, 1}}, {}); }

std::vector<Feature> Features() {
  const ReferenceSet point{.type = CoreType::kPoint};
  const ReferenceSet segment{.type = CoreType::kSegment, .size = {0.75, 0, 0}};
  const ReferenceSet triangle{.type = CoreType::kTriangle, .points = {{2, -1, 0}, {-1, 2, 0}, {-1, -1, 0}}};
  const ReferenceSet box{.type = CoreType::kBox, .size = {0.5, 1, 2}};
  const ReferenceSet cylinder{.type = CoreType::kCylinder, .size = {0.5, 1.5, 0}};
  const ReferenceSet cone{.type = CoreType::kCone, .size = {3, 4, 0}};
  const ReferenceSet octahedron{.type = CoreType::kPolytope, .points = Octahedron()};
  const ReferenceSet cube{.type = CoreType::kPolytope, .points = Cube()};
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  return {
      {"point", point, z, 0, false},
      {"segment end", segment, z, 0.75, false},
      {"segment side", segment, x, 0, false},
      {"triangle face", triangle, z, 0, true},
      {"box face x", box, x, 0.5, true},
      {"box face -y", box, -y, 1, true},
      {"box face z", box, z, 2, true},
      {"cylinder cap", cylinder, -z, 1.5, true},
      {"cylinder side", cylinder, y, 0.5, true},
      {"cone apex", cone, z, 3, false},
      {"cone base", cone, -z, 1, true},
      {"cone side", cone, {0.8, 0, 0.6}, 1.8, true},
      {"octahedron vertex", octahedron, -x, 1, false},
      {"octahedron face", octahedron, Vector3d(1, 1, 1) / std::sqrt(3.0), 1 / std::sqrt(3.0), true},
      {"cube face", cube, y, 1, true},
      {"cube edge", cube, Vector3d(1, 1, 0) / std::sqrt(2.0), std::sqrt(2.0), false},
      {"cube vertex", cube, Vector3d(1, -1, 1) / std::sqrt(3.0), std::sqrt(3.0), false},
  };
}

/// A rotation that takes `direction` to z: without any rounding if it is an axis.
Matrix3d TakingToZ(const Vector3d& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) != 1) continue;
    Matrix3d rotation = Matrix3d::Zero();
    rotation(2, axis) = direction[axis];
    rotation(0, (axis + 1) % 3) = 1;
    rotation(1, (axis + 2) % 3) = direction[axis];
    return rotation;
  }
  const Vector3d axis = direction.cross(Vector3d::UnitZ()).normalized();
  return Eigen::AngleAxisd(std::acos(direction.z()), axis).toRotationMatrix();
}

/// Turn about z; by 0 to 3 without rounding.
Matrix3d QuarterTurns(double quarters) {
  Matrix3d rotation = Eigen::AngleAxisd(quarters * std::numbers::pi / 2, Vector3d::UnitZ()).toRotationMatrix();
  if (quarters == std::floor(quarters)) rotation = rotation.array().round().matrix();
  return rotation;
}

/// Two features face to face on the z axis, set 1's centre at the origin.
ReferencePair FaceToFace(const Feature& one, const Feature& two, double distance, double quarters) {
  const Matrix3d upside_down = Vector3d(1, -1, -1).asDiagonal();
  ReferencePair pair{one.set, two.set, {}, {}};
  pair.pose_1.rotation = TakingToZ(one.direction);
  pair.pose_2.rotation = QuarterTurns(quarters) * upside_down * TakingToZ(two.direction);
  const SolverPair<double> in_place(pair);
  pair.pose_1.translation = -in_place.Center1();
  pair.pose_2.translation = Vector3d(0, 0, distance) - in_place.Center2();
  return pair;
}

template <class S>
class GrowthDistanceAnalytic : public ::testing::Test {
 protected:
  /// Checks the answer, and that of the swapped pair. `normal` is zero if there is more than one.
  static void Check(const ReferencePair& reference, double growth_distance, const Vector3d& normal) {
    CheckInOrder(reference, growth_distance, normal);
    CheckInOrder({reference.set_2, reference.set_1, reference.pose_2, reference.pose_1}, growth_distance, -normal);
  }

 private:
  static void CheckInOrder(const ReferencePair& reference, double growth_distance, const Vector3d& normal) {
    const SolverPair<S> pair(reference);
    const dgd::Result<S> result = pair.GrowthDistance();
    EXPECT_TRUE(IsCertified<S>(reference, pair, result));
    const double gap = Bounds<S>::Gap(pair, reference.Extent());
    EXPECT_LE(double(result.lower_bound), growth_distance * (1 + gap));
    EXPECT_GE(double(result.upper_bound), growth_distance * (1 - gap));
    if (normal.norm() > 0) {
      // The gap is of second order in the normal's error on a curved side.
      EXPECT_NEAR((result.normal.template cast<double>() - normal).norm(), 0, 4 * std::sqrt(gap));
    }
  }
};

TYPED_TEST_SUITE(GrowthDistanceAnalytic, Scalars);

TYPED_TEST(GrowthDistanceAnalytic, FacingFeatures_AddTheirReaches) {
  Random random(TestSeed());
  for (const Feature& one : Features()) {
    for (const Feature& two : Features()) {
      for (const double radius_1 : {0.0, 0.25}) {
        for (const double radius_2 : {0.0, 1.5}) {
          Feature first = one, second = two;
          first.set.radius = radius_1;
          second.set.radius = radius_2;
          if (!first.set.IsSolid() && !second.set.IsSolid() && radius_1 + radius_2 == 0) continue;
          const double reach = one.reach + two.reach + radius_1 + radius_2;
          // Nothing to divide by: a triangle's side faces a point.
          if (reach == 0) continue;
          for (const double quarters : {0.0, 1.0, 2.0, 0.5, random.Uniform(0, 4)}) {
            for (const double growth_distance : {0.125, 1.0, 7.0}) {
              SCOPED_TRACE(one.name + " to " + two.name + ", radii " + std::to_string(radius_1) + " " +
                           std::to_string(radius_2) + ", quarter turns " + std::to_string(quarters));
              const bool unique = one.unique_normal || two.unique_normal || radius_1 + radius_2 > 0;
              this->Check(FaceToFace(first, second, growth_distance * reach, quarters), growth_distance,
                          unique ? Vector3d(0, 0, 1) : Vector3d(0, 0, 0));
              if (this->HasFailure()) return;
            }
          }
        }
      }
    }
  }
}

ReferencePair At(const ReferenceSet& set_1, const ReferenceSet& set_2, const Vector3d& where) {
  return {set_1, set_2, {}, {Matrix3d::Identity(), where}};
}

ReferenceSet Sphere(double radius) { return {.type = CoreType::kPoint, .radius = radius}; }
ReferenceSet BoxOf(const Vector3d& half) { return {.type = CoreType::kBox, .size = half}; }

TYPED_TEST(GrowthDistanceAnalytic, Spheres_AnyDirection) {
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    const double radius_1 = random.LogUniform(0.01, 10), radius_2 = random.LogUniform(0.01, 10);
    const Vector3d direction = random.UnitVector();
    const double growth_distance = random.LogUniform(0.01, 100);
    this->Check(At(Sphere(radius_1), Sphere(radius_2), growth_distance * (radius_1 + radius_2) * direction),
                growth_distance, direction);
  }
}

TYPED_TEST(GrowthDistanceAnalytic, AlignedBoxes_AnyPlace) {
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    const Vector3d half_1 = random.InCube().cwiseAbs() + Vector3d::Constant(0.05);
    const Vector3d half_2 = random.InCube().cwiseAbs() + Vector3d::Constant(0.05);
    const Vector3d where = random.LogUniform(0.1, 10) * random.UnitVector();
    this->Check(At(BoxOf(half_1), BoxOf(half_2), where), where.cwiseAbs().cwiseQuotient(half_1 + half_2).maxCoeff(),
                Vector3d::Zero());
  }
}

// A sphere against a box's face off its middle, the middle of an edge, and a corner.
TYPED_TEST(GrowthDistanceAnalytic, SphereAndBox_FaceEdgeCorner) {
  const ReferenceSet box = BoxOf({1, 1, 1});
  for (const double growth_distance : {0.25, 1.0, 3.0}) {
    const double scale = growth_distance;
    this->Check(At(box, Sphere(0.5), scale * Vector3d(0.25, -0.75, 1.5)), growth_distance, {0, 0, 1});
    // On the offset edge and corner: the box's feature plus the radius along its bisector.
    const Vector3d edge_normal = Vector3d(1, 1, 0) / std::sqrt(2.0);
    this->Check(At(box, Sphere(0.5), scale * (Vector3d(1, 1, 0.25) + 0.5 * edge_normal)), growth_distance, edge_normal);
    const Vector3d corner_normal = Vector3d(1, 2, 2) / 3;
    this->Check(At(box, Sphere(0.5), scale * (Vector3d(1, 1, 1) + 0.5 * corner_normal)), growth_distance,
                corner_normal);
  }
}

// Crossed capsules touch where their axes cross, also off their middles; parallel ones anywhere beside each other.
TYPED_TEST(GrowthDistanceAnalytic, Capsules_CrossedAndParallel) {
  const ReferenceSet capsule{.type = CoreType::kSegment, .size = {2, 0, 0}, .radius = 0.5};
  Matrix3d z_to_x;
  z_to_x << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  for (const double growth_distance : {0.25, 1.0, 3.0}) {
    for (const double off : {0.0, 0.5, 1.5}) {
      ReferencePair crossed = At(capsule, capsule, growth_distance * Vector3d(off, 1, -off));
      crossed.pose_2.rotation = z_to_x;
      this->Check(crossed, growth_distance, {0, 1, 0});
      this->Check(At(capsule, capsule, growth_distance * Vector3d(0, 1, off)), growth_distance, {0, 1, 0});
    }
    // End to end, off the line: the ends' balls touch.
    this->Check(At(capsule, capsule, growth_distance * (Vector3d(0, 0, 4) + Vector3d(0.6, 0, 0.8))), growth_distance,
                {0.6, 0, 0.8});
  }
}

// The rim of a cylinder, and that of a cone.
TYPED_TEST(GrowthDistanceAnalytic, SphereAndRim) {
  const ReferenceSet cylinder{.type = CoreType::kCylinder, .size = {1, 2, 0}};
  const ReferenceSet cone{.type = CoreType::kCone, .size = {1, 2, 0}};
  Random random(TestSeed());
  for (const double growth_distance : {0.25, 1.0, 3.0}) {
    for (int i = 0; i < 20; ++i) {
      const double angle = i == 0 ? 0 : random.Uniform(0, 2 * std::numbers::pi), tilt = random.Uniform(0.1, 1.4);
      const Vector3d around(std::cos(angle), std::sin(angle), 0);
      const Vector3d up_normal = std::cos(tilt) * around + std::sin(tilt) * Vector3d::UnitZ();
      this->Check(At(cylinder, Sphere(0.5), growth_distance * (around + Vector3d(0, 0, 2) + 0.5 * up_normal)),
                  growth_distance, up_normal);
      // The cone's rim is half a metre below its centre; normals there point down or a little up.
      const Vector3d down_normal = std::cos(tilt) * around - std::sin(tilt) * Vector3d::UnitZ();
      ReferencePair below = At(cone, Sphere(0.5), growth_distance * (around - Vector3d(0, 0, 0.5) + 0.5 * down_normal));
      below.pose_1.translation.z() = 0.5;  // The centre to the origin.
      this->Check(below, growth_distance, down_normal);
    }
  }
}

// The octahedron is the unit ball of the 1-norm: a point's growth distance is its 1-norm, two octahedra's half of it.
TYPED_TEST(GrowthDistanceAnalytic, Octahedron_MeasuresTheOneNorm) {
  Random random(TestSeed());
  const ReferenceSet octahedron{.type = CoreType::kPolytope, .points = Octahedron()};
  for (int i = 0; i < 1000; ++i) {
    const Vector3d where = random.LogUniform(0.1, 10) * random.UnitVector();
    const Vector3d normal = where.array().sign().matrix() / std::sqrt(3.0);
    // Near an edge the gap's tolerance lets the neighbouring facet's normal pass.
    const bool clear = where.cwiseAbs().minCoeff() > 0.01 * where.norm();
    this->Check(At(octahedron, {.type = CoreType::kPoint}, where), where.lpNorm<1>(),
                clear ? normal : Vector3d(Vector3d::Zero()));
    this->Check(At(octahedron, octahedron, where), where.lpNorm<1>() / 2, clear ? normal : Vector3d(Vector3d::Zero()));
  }
}

// The sum of a ball and a triangle or segment seen from aside: beyond a corner or an end.
TYPED_TEST(GrowthDistanceAnalytic, SphereAndFlatCores_BeyondTheirBorders) {
  const ReferenceSet triangle{.type = CoreType::kTriangle, .points = {{2, -1, 0}, {-1, 2, 0}, {-1, -1, 0}}};
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    const double growth_distance = random.LogUniform(0.1, 10), radius = random.LogUniform(0.1, 10);
    // Out of the corner (2, -1, 0), within the cone of directions that are its own.
    const double tilt = random.Uniform(-1.5, 1.5);
    const Vector3d normal = std::cos(tilt) * Vector3d(2, -1, 0).normalized() + std::sin(tilt) * Vector3d::UnitZ();
    this->Check(At(triangle, Sphere(radius), growth_distance * (Vector3d(2, -1, 0) + radius * normal)), growth_distance,
                normal);
    const ReferenceSet segment{.type = CoreType::kSegment, .size = {1.5, 0, 0}};
    const Vector3d along = std::cos(tilt) * Vector3d(0, 0.6, 0.8) + std::sin(tilt) * Vector3d::UnitX();
    const Vector3d out = along.z() > 0 ? along : Vector3d(-along);
    this->Check(At(segment, Sphere(radius), growth_distance * (Vector3d(0, 0, 1.5) + radius * out)), growth_distance,
                out);
  }
}

}  // namespace
}  // namespace dgd_test
