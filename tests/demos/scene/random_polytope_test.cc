// Contract: as many vertices as asked for, all on the hull; the diameter as asked for; centre of mass at the origin;
// same seed, same polytope.
#include "scene/random_polytope.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>

namespace dgd_demos {
namespace {

TEST(RandomPolytopeTest, AnyNumberOfVertices_AllOnTheHull) {
  Random random(1, 0);
  for (int vertices = kMinPolytopeVertices; vertices <= 40; ++vertices) {
    const Polyhedron polytope = RandomPolytope(random, vertices, 1.5);
    ASSERT_EQ(polytope.vertices.size(), static_cast<std::size_t>(vertices));
    EXPECT_EQ(ConvexHull(polytope.vertices).vertices.size(), polytope.vertices.size());
    EXPECT_LT(Centroid(polytope).norm(), 1e-14);
    EXPECT_GT(DistanceToBoundary(polytope, Eigen::Vector3d::Zero()), 0.1);

    double diameter = 0;
    for (const auto& a : polytope.vertices) {
      for (const auto& b : polytope.vertices) diameter = std::max(diameter, (a - b).norm());
    }
    EXPECT_NEAR(diameter, 1.5, 1e-14);
  }
}

TEST(RandomPolytopeTest, LargestNumberOfVertices_IsPossible) {
  Random random(2, 0);
  EXPECT_EQ(RandomPolytope(random, kMaxPolytopeVertices, 1).vertices.size(), std::size_t{kMaxPolytopeVertices});
}

TEST(RandomPolytopeTest, SameSeed_SamePolytope) {
  Random first(7, 3), second(7, 3), other_stream(7, 4);
  const Polyhedron polytope = RandomPolytope(first, 12, 1);
  EXPECT_EQ(polytope.vertices, RandomPolytope(second, 12, 1).vertices);
  EXPECT_NE(polytope.vertices, RandomPolytope(other_stream, 12, 1).vertices);
}

// The bits behind all scenes. If this fails, every seed means another scene than before: say so in the commit.
TEST(RandomTest, SeedOne_GivesTheNumbersItAlwaysGave) {
  Random random(1, 0);
  EXPECT_EQ(random.Uniform(0, 1), 0x1.8451f002ab5d8p-1);
  EXPECT_EQ(random.Integer(8, 20), 15);
}

TEST(RandomTest, Integer_ReachesBothEndsAndNothingElse) {
  Random random(5, 0);
  std::array<int, 3> counts{};
  for (int i = 0; i < 3000; ++i) ++counts.at(random.Integer(4, 6) - 4);
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
}

TEST(RandomTest, Rotation_IsARotation) {
  Random random(6, 0);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d rotation = random.Rotation();
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_GT(rotation.determinant(), 0);
  }
}

}  // namespace
}  // namespace dgd_demos
