#include "dgd/shapes/polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/random_sets.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

template <class S>
void CheckPolytope(const std::vector<Vector3d>& points, double discretisation = 0) {
  CheckShape(dgd::Polytope<S>(points), {.type = CoreType::kPolytope, .points = points}, discretisation);
}

TEST(Polytope, Contract_HoldsForRandomHulls) {
  Random random(TestSeed());
  for (int i = 0; i < 20; ++i) {
    const ReferenceSet set = RandomSet(random, CoreType::kPolytope, false);
    SCOPED_TRACE(i);
    CheckPolytope<double>(set.points);
    CheckPolytope<float>(set.points);
  }
}

TEST(Polytope, Contract_HoldsForFlatHulls) {
  CheckPolytope<double>({{1, 2, 3}});
  CheckPolytope<double>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  CheckPolytope<double>({{0, 0, 0}, {1, 1, 1}, {0.25, 0.25, 0.25}});
  CheckPolytope<double>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}});
  CheckPolytope<float>({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
}

TEST(Polytope, Inradius_IsNearlyTheLargestBallAboutTheCentroid) {
  const std::vector<Vector3d> tetrahedron = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const dgd::Polytope<double> regular{tetrahedron};
  EXPECT_LE(regular.Inradius(), 1 / std::sqrt(3.0));
  EXPECT_NEAR(regular.Inradius(), 1 / std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(regular.Center().norm(), 0, 1e-15);
  const dgd::Polytope<float> regular_float{tetrahedron};
  EXPECT_LE(double(regular_float.Inradius()), 1 / std::sqrt(3.0));
  EXPECT_NEAR(double(regular_float.Inradius()), 1 / std::sqrt(3.0), 1e-6);
}

// A ring of 40 points on a cap is thinned to 16 that are spread evenly around it.
TEST(Polytope, SupportFace_ThinsLargeFacetsEvenly) {
  std::vector<Vector3d> points;
  constexpr int kSides = 40;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    for (const double z : {-1.0, 1.0}) points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  const double thinned_sagitta = 1 - std::cos(std::numbers::pi * 3 / kSides);
  CheckPolytope<double>(points, thinned_sagitta);
}

// All corners but one are in the plane x = y, and the hull's facets in it are several: a point of one of them, which is
// outside another's plane by a rounding, is on the border all the same. Found by fuzz_solver.
TEST(Polytope, Distance_OfAPointOnOneOfSeveralFacetsInAPlane_IsARounding) {
  constexpr double kFar = 7.090087890625;
  const std::vector<Vector3d> points = {{kFar, kFar, kFar},
                                        {-2.886474609375, -2.886474609375, -2.886474609375},
                                        {kFar, 7.097412109375, kFar},
                                        {-2.886474609375, -2.886474609375, 0},
                                        {kFar, kFar, 0.027587890625},
                                        {0, 0, 7.0625},
                                        {kFar, kFar, -7.847412109375},
                                        {-7.84326171875, -7.84326171875, -7.84326171875}};
  const dgd::Polytope<double> polytope{points};
  EXPECT_LE(polytope.Distance({6.9273413191610951, 6.9273413191610942, 3.1381923290950153}), 1e-14);
  Random random(TestSeed());
  for (int i = 0; i < 1000; ++i) {
    const double height = random.Uniform(-5, 7);
    const Vector3d on_border(random.Uniform(5, 7), 0, height);
    const double y = on_border.x() + random.Uniform(-1, 1) * 1e-15;
    EXPECT_LE(polytope.Distance({on_border.x(), y, height}), 1e-14) << on_border.transpose();
  }
  EXPECT_NEAR(polytope.Distance({6, 5, 0}), std::sqrt(0.5), 1e-14);
}

TEST(Polytope, SupportFace_OfNoDirectionIsSomeFacet) {
  const dgd::Polytope<double> cube(std::vector<Vector3d>{
      {-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1}, {1, -1, -1}, {1, -1, 1}, {1, 1, -1}, {1, 1, 1}});
  dgd::SupportingFace<double> face;
  cube.SupportFace(Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()), face);
  EXPECT_EQ(face.size, 4);
}

// The one corner that sticks out of a facet must survive the thinning, whatever its place in the facet's order.
TEST(Polytope, SupportFace_KeepsTheSupportPointOfALargeFacet) {
  for (int count = 20; count < 40; ++count) {
    std::vector<Vector3d> points = {{0, 0, -1}};
    // An arc of half a radian, and its far tip.
    for (int i = 0; i < count; ++i) {
      const double angle = 0.5 * i / count - 0.25;
      points.emplace_back(std::cos(angle), std::sin(angle), 1);
    }
    points.emplace_back(-5, 0, 1);
    const dgd::Polytope<double> polytope(points);
    const Vector3d direction = Vector3d(-1e-3, 0, 1).normalized();
    dgd::SupportingFace<double> face;
    polytope.SupportFace(direction, face);
    double highest = -10;
    for (int i = 0; i < face.size; ++i) {
      highest = std::max(highest, direction.dot(face.points[static_cast<std::size_t>(i)]));
    }
    EXPECT_NEAR(highest, direction.dot(polytope.Support(direction).point), 1e-12) << count;
  }
}

TEST(Polytope, Constructor_RejectsEmptyAndNonFinitePoints) {
  ExpectRejected([] { return dgd::Polytope<double>(std::vector<Vector3d>{}); }, "at least one point");
  const std::vector<Vector3d> bad = {{0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 0}};
  ExpectRejected([&] { return dgd::Polytope<double>(bad); }, "hull point 1 must be finite; got (1");
}

}  // namespace
}  // namespace dgd_test
