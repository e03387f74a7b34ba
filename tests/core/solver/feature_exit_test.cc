// Triangles so flat, seen along the ray, that plain barycentric weights have few or no digits.
#include "dgd/solver/feature_exit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace dgd {
namespace {

using solver_internal::FacetExit;
using solver_internal::FeatureExit;
using solver_internal::SliverExit;
using Point = Vector3<double>;
using Corners = std::array<Point, 3>;

constexpr double kCornerError = 16 * std::numeric_limits<double>::epsilon();

/// The weights are convex, and what they make of the corners is the point of the ray at the height that is told.
void ExpectPointOfRay(const Corners& corners, const FeatureExit<double, 3>& exit) {
  Point sum = Point::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GE(exit.weights[i], 0);
    weights += exit.weights[i];
    sum += exit.weights[i] * corners[i];
  }
  EXPECT_NEAR(weights, 1, 1e-15);
  EXPECT_NEAR(sum.x(), 0, 1e-13);
  EXPECT_NEAR(sum.y(), 0, 1e-13);
  EXPECT_NEAR(sum.z(), exit.height, 1e-15);
}

// From soak runs; the weights by exact rational arithmetic.
TEST(FacetExit, CornersNearlyOnALineThroughTheRay_ExitIsOnTheRay) {
  const Corners corners = {Point(0.057566277658441474, 0.0038848596787811659, 0.18134003413394378),
                           Point(-0.052806069128890215, -0.0035636170529074127, 0.24086318755782304),
                           Point(-0.0083480853107639336, -0.00056337045470731401, 0.21808999709485724)};
  FeatureExit<double, 3> exit;
  ASSERT_TRUE(FacetExit<double>(corners[0], corners[1], corners[2], 0, exit));
  ExpectPointOfRay(corners, exit);
  // Between the lowest and the highest of the edges through which it may leave, for all that the digits say.
  EXPECT_GT(exit.height, 0.2123);
  EXPECT_LT(exit.height, 0.2135);
}

// The opposite one's weight is near 1/3, the others' have no digits: the sum was 1.04.
TEST(WeighSliver, OppositeCornersOnALineThroughTheRay_WeightsSumToOne) {
  const Corners corners = {Point(-0.036504928341484978, -0.25180261400794662, 1.1665941669467614),
                           Point(-0.067888716359463155, -0.46828077790061956, 1.1116410036454749),
                           Point(0.036504928341484534, 0.2518026140079464, 1.3046198955692356)};
  const solver_internal::SliverNormal<double> normal(corners[0], corners[1], corners[2]);
  std::array<double, 3> weights{};
  ASSERT_TRUE(solver_internal::WeighSliver(corners[0], corners[1], corners[2], std::abs(normal.cross.z()), kCornerError,
                                           weights));
  EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-15);
}

TEST(SliverExit, CornerOnTheRayButForRounding_HoldsItWithinTheCornersError) {
  const Corners corners = {Point(0.326871010522646, -0.31733301737610953, 0.28270688435520347),
                           Point(-0.0045190260282879091, -0.43670302806385308, 0.10532201800267119),
                           Point(-2.7755575615628914e-17, -4.163336342344337e-17, 0.24141123723655222)};
  FeatureExit<double, 3> exit;
  EXPECT_FALSE(FacetExit<double>(corners[0], corners[1], corners[2], 0, exit));
  ASSERT_TRUE(SliverExit<double>(corners[0], corners[1], corners[2], 0, kCornerError, exit));
  ExpectPointOfRay(corners, exit);
  EXPECT_NEAR(exit.height, corners[2].z(), 1e-15);
}

// From soak runs in float. The side from the first to the second corner passes the ray within rounding; the third has
// no weight to give to the longest side, along which the weights were off.
TEST(SliverExit, WeightsOffAlongASideButTheLongest_ExitIsOnTheRay) {
  const Vector3<float> a(-3.0350306f, -3.39186025f, 4.92860603f), b(0.329020172f, 0.367705941f, 6.69057751f),
      c(2.98128963f, 3.4397614f, -4.92820835f);
  FeatureExit<float, 3> exit;
  ASSERT_TRUE(SliverExit<float>(a, b, c, 0, 16 * kEpsilon<float> * 6.7f, exit));
  const Vector3<float> sum = exit.weights[0] * a + exit.weights[1] * b + exit.weights[2] * c;
  EXPECT_NEAR(sum.x(), 0, 1e-5);
  EXPECT_NEAR(sum.y(), 0, 1e-5);
  EXPECT_NEAR(exit.height, 6.518, 1e-3);
}

// Ten times as high as wide: the corners' error is of their heights, and it may be all that is off the ray.
TEST(SliverExit, HighAboveItsReach_MayBeOffTheRayByTheCornersError) {
  const Vector3<float> a(0.00193357468f, -0.00016862154f, 10.7545862f), b(-0.28164503f, 0.0241505541f, 10.4690294f),
      c(0.00808791816f, -0.0299188122f, 10.4759474f);
  FeatureExit<float, 3> exit;
  EXPECT_FALSE(FacetExit<float>(a, b, c, 0, exit));
  ASSERT_TRUE(SliverExit<float>(a, b, c, 0, 16 * kEpsilon<float> * a.z(), exit));
  EXPECT_NEAR(exit.height, 10.75264, 1e-4);
}

}  // namespace
}  // namespace dgd
