#include "dgd/solver/simplex_step.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "dgd/solver/feature_exit.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::solver_internal::Cross;
using dgd::solver_internal::SimplexStep;
using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

/// Counterclockwise about the ray, which passes between them once they are moved; false if these do not.
bool CarryTheRay(const Corners& corners, double radius, dgd::solver_internal::FeatureExit<double, 3>& exit) {
  return Cross<double>(corners[1] - corners[0], corners[2] - corners[0]) > 0 &&
         dgd::solver_internal::FacetExit<double>(corners[0], corners[1], corners[2], radius, exit);
}

template <bool kHasRadius>
void CompareWithTheFacetsAlone() {
  Random random(TestSeed());
  const double radius = kHasRadius ? 0.3 : 0;
  int certain = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Corners corners = {random.InCube(), random.InCube(), random.InCube()};
    dgd::solver_internal::FeatureExit<double, 3> old, exit;
    if (!CarryTheRay(corners, radius, old)) continue;
    const Vector3d added = 1.5 * random.InCube();
    if (old.normal.dot(added - corners[0]) < 0.01) continue;
    const SimplexStep<double, kHasRadius> step({&corners[0], &corners[1], &corners[2]}, added, radius, old.normal);
    ASSERT_EQ(step.outgoing + step.next + step.last, 3u);
    if (!step.is_certain) continue;
    ++certain;
    Corners after = corners;
    after[step.outgoing] = added;
    ASSERT_TRUE(CarryTheRay(after, radius, exit)) << trial;
    EXPECT_NEAR(step.height, exit.height, 1e-12);
    EXPECT_NEAR((step.normal - exit.normal).norm(), 0, 1e-12);
    EXPECT_NEAR((step.direction.normalized() - exit.normal).norm(), 0, 1e-12);
    EXPECT_NEAR(step.weights[0], exit.weights[step.outgoing], 1e-11);
    EXPECT_NEAR(step.weights[1], exit.weights[step.next], 1e-11);
    EXPECT_NEAR(step.weights[2], exit.weights[step.last], 1e-11);
    // What is left out lies below: the ray leaves the four points through no other facet.
    EXPECT_LE(exit.normal.dot(corners[step.outgoing] - added), 1e-15);
    EXPECT_GT(step.height, old.height);
  }
  EXPECT_GT(certain, kHasRadius ? 500 : 1000);
}

TEST(SimplexStep, Sharp_AgreesWithTheFacet) { CompareWithTheFacetsAlone<false>(); }

TEST(SimplexStep, Rounded_AgreesWithTheFacet) { CompareWithTheFacetsAlone<true>(); }

TEST(SimplexStep, RayOnABorder_SliverOrSteep_IsNotCertain) {
  const Corners corners = {Vector3d(1, 0, 0), Vector3d(-1, 1, 0), Vector3d(-1, -1, 0)};
  const auto is_certain = [&](const Vector3d& added) {
    return SimplexStep<double, false>({&corners[0], &corners[1], &corners[2]}, added, 0, Vector3d::UnitZ()).is_certain;
  };
  EXPECT_TRUE(is_certain({0.5, 0.1, 1}));
  EXPECT_FALSE(is_certain({0, 0, 1}));         // On the ray: on the border of all three facets.
  EXPECT_FALSE(is_certain({0.5, -0.5, 1}));    // Opposite to a corner.
  EXPECT_FALSE(is_certain({100, 3, 1}));       // With the two corners that are left, a sliver.
  EXPECT_FALSE(is_certain({0.5, 0.1, 1000}));  // Steep.
  EXPECT_FALSE(is_certain({0.5, 0.1, std::nan("")}));
}

}  // namespace
}  // namespace dgd_test
