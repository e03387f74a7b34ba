// Where the ray meets a triangle, by its corners' weights: to the corners' own rounding, as thin as it may be.
#include "dgd/solver/portal.h"

#include <gtest/gtest.h>

#include <array>

#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

/// A triangle that the ray passes in the middle once it is moved out by the radius.
/// @param fatness  Twice its area over its longest side's square, about.
/// @param along    Where on its long side its third corner is, as a part of that.
template <class S>
dgd::solver_internal::Portal<S> TriangleAbout(Random& random, double fatness, double along, double radius) {
  const Eigen::Matrix3d turn = random.Rotation();
  const Vector3d ray = turn * Vector3d(0.2, 0.1, 1);
  std::array<Vector3d, 3> corners = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(along, fatness, 0)};
  const Vector3d middle =
      (corners[0] + corners[1] + corners[2]) / 3 + Vector3d(0, 0.1 * fatness * random.Uniform(-1, 1), 0);
  dgd::solver_internal::Portal<S> triangle(ray.cast<S>(), S(radius));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d point = turn * (corners[i] - middle + Vector3d(0.1, 0.05, 0.5 - radius));
    triangle.corners[i] = {point.cast<S>(), dgd::FeatureId(i), 0};
  }
  return triangle;
}

template <class S>
void CheckThinTriangles() {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(1000, 100); ++i) {
    for (const double fatness : {0.012, 0.03, 0.2}) {
      for (const double radius : {0.0, 0.04}) {
        auto triangle = TriangleAbout<S>(random, fatness, random.Uniform(0, 1), radius);
        triangle.FindPlane();
        ASSERT_TRUE(triangle.IsWellConditioned());
        ASSERT_LT(triangle.FindExitEdge(), 0);
        Vector3d point = radius * triangle.normal.template cast<double>().normalized();
        for (std::size_t c = 0; c < 3; ++c) {
          point += double(triangle.weights[c]) * triangle.corners[c].point.template cast<double>();
        }
        const double part = double(triangle.exit_height) / double(triangle.along);
        EXPECT_LT((point - part * triangle.ray.template cast<double>()).norm(), 3 * double(dgd::kEpsilon<S>))
            << "fatness " << fatness << ", radius " << radius;
      }
    }
  }
}

TEST(Portal, ExitOfThinTriangles_IsOnThemToRounding) {
  CheckThinTriangles<double>();
  CheckThinTriangles<float>();
}

TEST(Portal, NeedlesBeyond_AreNotSound) {
  Random random(TestSeed());
  for (int i = 0; i < 100; ++i) {
    auto triangle = TriangleAbout<double>(random, 0.005, random.Uniform(0, 1), 0);
    triangle.FindPlane();
    EXPECT_FALSE(triangle.IsWellConditioned());
  }
}

}  // namespace
}  // namespace dgd_test
