// What of a parallelogram is above a rectangle: its corners are of both, and span what clipping side by side leaves.
#include "dgd/rectangle_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "dgd/facing_faces.h"
#include "support/floating_point_traps.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Of the points' convex hull, by two monotone chains.
double AreaOfHull(std::vector<Vector2d> points) {
  const auto cross = [](const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  std::sort(points.begin(), points.end(),
            [](const Vector2d& a, const Vector2d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  double area = 0;
  for (int side = 0; side < 2; ++side) {
    std::vector<Vector2d> chain;
    for (const Vector2d& point : points) {
      while (chain.size() > 1 && cross(chain.back() - chain[chain.size() - 2], point - chain.back()) <= 0) {
        chain.pop_back();
      }
      chain.push_back(point);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) area += cross(chain[i], chain[i + 1]) / 2;
    std::reverse(points.begin(), points.end());
  }
  return area;
}

template <class S>
double AreaByClipping(const dgd::Parallelogram<S>& shape, S half_x, S half_y) {
  dgd::SupportingFace<double> rectangle, parallelogram;
  for (const auto& [sign_1, sign_2] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    rectangle.Add({sign_1 * double(half_x), sign_2 * double(half_y), 0});
    parallelogram.Add(shape.middle.template cast<double>() + sign_1 * shape.half_a.template cast<double>() +
                      sign_2 * shape.half_b.template cast<double>());
  }
  const dgd::facing_faces_internal::ProjectedFace<double> above(parallelogram, 0), below(rectangle, 0);
  dgd::CornerList<double> overlap;
  dgd::facing_faces_internal::ClipByPolygon(above, false, below, overlap);
  std::vector<Vector2d> points;
  for (int i = 0; i < overlap.size; ++i) points.emplace_back(overlap[i].x, overlap[i].y);
  return points.size() > 2 ? AreaOfHull(points) : 0;
}

/// @return the overlap's area.
template <class S>
double Check(const dgd::Parallelogram<S>& shape, S half_x, S half_y) {
  const double tolerance = sizeof(S) == sizeof(float) ? 1e-5 : 1e-13;
  const auto overlap = [&] {
    const FloatingPointTraps traps;
    return dgd::OverlapWithRectangle(shape, half_x, half_y);
  }();
  const Vector3d a = shape.half_a.template cast<double>(), b = shape.half_b.template cast<double>();
  const double area = a.x() * b.y() - a.y() * b.x();
  std::vector<Vector2d> points;
  for (int i = 0; i < overlap.size; ++i) {
    const Vector3d corner = overlap.corners[static_cast<std::size_t>(i)].template cast<double>();
    points.emplace_back(corner.head<2>());
    EXPECT_LE(std::abs(corner.x()), double(half_x) + tolerance);
    EXPECT_LE(std::abs(corner.y()), double(half_y) + tolerance);
    if (std::abs(area) < 1e-3) continue;
    // In coordinates along a and b: within, and as high as the parallelogram is there.
    const Vector3d from_middle = corner - shape.middle.template cast<double>();
    const double u = (from_middle.x() * b.y() - from_middle.y() * b.x()) / area;
    const double v = (from_middle.y() * a.x() - from_middle.x() * a.y()) / area;
    const double slack = tolerance / std::abs(area);
    EXPECT_LE(std::max(std::abs(u), std::abs(v)), 1 + slack);
    EXPECT_NEAR(from_middle.z(), u * a.z() + v * b.z(), slack);
  }
  const double overlap_area = points.size() > 2 ? AreaOfHull(points) : 0;
  EXPECT_NEAR(overlap_area, AreaByClipping(shape, half_x, half_y), 10 * tolerance);
  return overlap_area;
}

template <class S>
void CheckRandom() {
  Random random(TestSeed());
  int empty = 0;
  const int count = TestCount(100000, 5000);
  for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("round " + std::to_string(i));
    dgd::Parallelogram<double> shape{0.6 * random.InCube(), random.LogUniform(0.05, 1) * random.UnitVector(),
                                     random.LogUniform(0.05, 1) * random.UnitVector()};
    double half_x = random.LogUniform(0.05, 1), half_y = random.LogUniform(0.05, 1);
    // Sides that are nearly or just along the rectangle's, and corners that are in its own.
    if (random.Below(2) == 0) shape.half_a.y() *= random.Below(2) * 1e-12;
    if (random.Below(2) == 0) shape.half_b.x() *= random.Below(2) * 1e-12;
    if (random.Below(4) == 0) half_x = std::abs(shape.middle.x() + shape.half_a.x() + shape.half_b.x());
    if (random.Below(4) == 0) half_y = std::abs(shape.middle.y() + shape.half_a.y() + shape.half_b.y());
    if (random.Below(8) == 0) shape.middle.setZero();
    empty +=
        Check<S>({shape.middle.cast<S>(), shape.half_a.cast<S>(), shape.half_b.cast<S>()}, S(half_x), S(half_y)) == 0;
  }
  EXPECT_GT(empty, count / 20);
  EXPECT_LT(empty, count / 2);
}

TEST(RectangleOverlap, Random_AsByClippingInDouble) { CheckRandom<double>(); }
TEST(RectangleOverlap, Random_AsByClippingInFloat) { CheckRandom<float>(); }

TEST(RectangleOverlap, Itself_IsAllOfIt) {
  EXPECT_DOUBLE_EQ((Check<double>({{0, 0, 1}, {0.3, 0, 0}, {0, 0.2, 0}}, 0.3, 0.2)), 0.24);
  EXPECT_DOUBLE_EQ((Check<double>({{0, 0, 1}, {0, -0.2, 0}, {0.3, 0, 0}}, 0.3, 0.2)), 0.24);
}

TEST(RectangleOverlap, OneInTheOther_IsTheSmallerOne) {
  const auto large = dgd::OverlapWithRectangle<double>({{0, 0, 1}, {3, 1, 0.5}, {-1, 4, 0}}, 0.3, 0.2);
  EXPECT_EQ(large.size, 4);
  const auto small = dgd::OverlapWithRectangle<double>({{0.01, 0, 1}, {0.03, 0.01, 0.5}, {-0.01, 0.04, 0}}, 0.3, 0.2);
  EXPECT_EQ(small.size, 4);
  EXPECT_EQ(small.corners[0], Vector3d(0.01 + 0.03 - 0.01, 0.01 + 0.04, 1.5));
}

// Plates and needles have sides without length.
TEST(RectangleOverlap, Segment_IsItsPartInside) {
  const auto overlap = dgd::OverlapWithRectangle<double>({{0, 0, 1}, {1, 0.1, 0.5}, {0, 0, 0}}, 0.5, 0.2);
  ASSERT_GE(overlap.size, 2);
  double least = 1, most = -1;
  for (int i = 0; i < overlap.size; ++i) {
    least = std::min(least, overlap.corners[static_cast<std::size_t>(i)].x());
    most = std::max(most, overlap.corners[static_cast<std::size_t>(i)].x());
  }
  EXPECT_NEAR(least, -0.5, 1e-15);
  EXPECT_NEAR(most, 0.5, 1e-15);
}

TEST(RectangleOverlap, Beside_IsNothing) {
  EXPECT_EQ((dgd::OverlapWithRectangle<double>({{2, 0, 1}, {0.5, 0.1, 0}, {0, 0.5, 0}}, 0.5, 0.2).size), 0);
}

}  // namespace
}  // namespace dgd_test
