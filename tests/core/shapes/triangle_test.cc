#include "dgd/shapes/triangle.h"

#include <algorithm>
#include <limits>

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void CheckTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const ReferenceSet reference{.type = CoreType::kTriangle, .points = {a, b, c}};
  CheckShape(dgd::Triangle<double>(a, b, c), reference);
  const Eigen::Vector3f a_f = a.cast<float>(), b_f = b.cast<float>(), c_f = c.cast<float>();
  CheckShape(dgd::Triangle<float>(a_f, b_f, c_f),
             {.type = CoreType::kTriangle, .points = {a_f.cast<double>(), b_f.cast<double>(), c_f.cast<double>()}});
}

TEST(Triangle, Contract_HoldsForAnyCorners) {
  CheckTriangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  CheckTriangle({3, -1, 0.5}, {2.5, 4, 1}, {-1, 0, 7});
  // A thin one.
  CheckTriangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-3, 0});
}

TEST(Triangle, Contract_HoldsForSegmentsAndPoints) {
  CheckTriangle({0, 0, 0}, {1, 0, 0}, {0.25, 0, 0});
  CheckTriangle({1, 2, 3}, {1, 2, 3}, {-1, 0, 2});
  CheckTriangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
}

TEST(Triangle, Constructor_RejectsNonFiniteCorners) {
  const Vector3d good(1, 2, 3);
  ExpectRejected([&] { return dgd::Triangle<double>(good, {0, kNaN, 0}, good); }, "nan");
  ExpectRejected([&] { return dgd::Triangle<double>(good, good, {0, 0, -kInfinity}); }, "-inf");
}

TEST(Triangle, ClosestPoint_MatchesDenseSampling) {
  Random random(TestSeed());
  for (int i = 0; i < 200; ++i) {
    const Vector3d a = random.InCube(), b = random.InCube(), c = random.InCube(), x = 2 * random.InCube();
    const Vector3d nearest = dgd::ClosestPointOnTriangle<double>(x, a, b, c);
    double sampled = kInfinity;
    constexpr int kSteps = 60;
    for (int u = 0; u <= kSteps; ++u) {
      for (int v = 0; u + v <= kSteps; ++v) {
        const Vector3d on_triangle = a + (b - a) * u / double(kSteps) + (c - a) * v / double(kSteps);
        sampled = std::min(sampled, (on_triangle - x).norm());
      }
    }
    const double spacing = ((b - a).norm() + (c - a).norm()) / kSteps;
    EXPECT_LE((nearest - x).norm(), sampled + 1e-15);
    EXPECT_GE((nearest - x).norm(), sampled - spacing);
  }
}

// The point is the triangle's own: a wrong one could be nearer than the truth.
TEST(Triangle, ClosestPoint_LiesOnSlivers) {
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    const Vector3d a = random.InCube(), b = random.InCube();
    const double width = random.LogUniform(1e-17, 1e-3);
    const Vector3d c = a + random.Uniform(-0.2, 1.2) * (b - a) + width * random.UnitVector();
    const Vector3d x = a + random.Uniform(-0.2, 1.2) * (b - a) + random.LogUniform(1e-9, 1) * random.UnitVector();
    const Vector3d nearest = dgd::ClosestPointOnTriangle<double>(x, a, b, c);
    // Within the width of the nearest edge, and as near as any edge.
    double to_edges = kInfinity, from_edges = kInfinity;
    const Vector3d* const corners[] = {&a, &b, &c, &a};
    for (int e = 0; e < 3; ++e) {
      const Vector3d edge = *corners[e + 1] - *corners[e];
      const auto distance_to_edge = [&](const Vector3d& point) {
        const double t = std::clamp(edge.dot(point - *corners[e]) / edge.squaredNorm(), 0.0, 1.0);
        return (*corners[e] + t * edge - point).norm();
      };
      to_edges = std::min(to_edges, distance_to_edge(x));
      from_edges = std::min(from_edges, distance_to_edge(nearest));
    }
    EXPECT_LE(from_edges, width + 1e-14) << "case " << i;
    EXPECT_LE((nearest - x).norm(), to_edges + 1e-14) << "case " << i;
  }
}

}  // namespace
}  // namespace dgd_test
