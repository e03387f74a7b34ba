// The settings that are there for comparison: turned off, they change how many iterations a query takes, not its
// answer.
#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "support/pairs/any_pair.h"
#include "support/random.h"

namespace dgd_test {
namespace {

/// Iterations over all poses, with a setting on and off.
struct Iterations {
  int on = 0, off = 0;
};

/// Asks about a fixed set of poses, overlapping and apart, with the setting on and off, and compares the answers.
template <class Core1, class Core2>
Iterations Compare(bool dgd::Settings<double>::*setting, const dgd::RoundedSet<Core1>& set_1,
                   const dgd::RoundedSet<Core2>& set_2, const dgd::Settings<double>& others = {}) {
  constexpr int L = dgd::kDimension<Core1>;
  AnyPair<double, L> pair(Erase(set_1), {}, Erase(set_2), {});
  Random random(7);
  Iterations iterations;
  for (int i = 0; i < 200; ++i) {
    dgd::Pose<double, L> pose_1, pose_2;
    if constexpr (L == 3) {
      pose_1.rotation = random.Rotation();
      pose_2.rotation = random.Rotation();
    } else {
      pose_2.rotation = Eigen::Rotation2Dd(random.Uniform(-3, 3)).toRotationMatrix();
    }
    pose_2.translation = random.LogUniform(0.3, 6) * random.UnitVector().template head<L>();
    dgd::Settings<double> with = others;
    with.max_iterations = 1000;  // Cutting planes alone take more than the default.
    // The others are not of its way.
    with.facet_walk = setting == &dgd::Settings<double>::facet_walk || setting == &dgd::Settings<double>::likely_start;
    dgd::Settings<double> without = with;
    without.*setting = false;
    pair.MoveTo(pose_1, pose_2);
    const auto on = pair.GrowthDistance(with);
    const auto off = pair.GrowthDistance(without);
    EXPECT_EQ(on.status, dgd::Status::kOptimal) << "pose " << i;
    EXPECT_EQ(off.status, dgd::Status::kOptimal) << "pose " << i;
    EXPECT_NEAR(off.GrowthDistance() / on.GrowthDistance(), 1, 2 * with.relative_tolerance) << "pose " << i;
    iterations.on += on.iterations;
    iterations.off += off.iterations;
  }
  return iterations;
}

constexpr auto kSecondOrder = &dgd::Settings<double>::second_order;
constexpr auto kRounding = &dgd::Settings<double>::rounding;
constexpr auto kKnownPoints = &dgd::Settings<double>::known_points;
constexpr auto kFacetWalk = &dgd::Settings<double>::facet_walk;
constexpr auto kLikelyStart = &dgd::Settings<double>::likely_start;
constexpr auto kHalfWayCuts = &dgd::Settings<double>::half_way_cuts;

TEST(LikelyStart, SkewedSets_NeedFewerIterationsForTheSameAnswer) {
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({0.1, 0.7, 1.5})};
  const dgd::RoundedSet cone{dgd::Cone<double>(0.2, 3)};
  const dgd::RoundedSet cylinder{dgd::Cylinder<double>(1, 0.1), 0.02};
  const dgd::RoundedSet frustum{dgd::Frustum<double>(0.1, 0.2, 3)};
  const dgd::RoundedSet box{dgd::Box<double>({0.1, 0.7, 1.5})};
  const dgd::RoundedSet segment{dgd::Segment<double>(2), 0.1};
  for (const Iterations& iterations : {Compare(kLikelyStart, ellipsoid, ellipsoid),
                                       Compare(kLikelyStart, ellipsoid, box), Compare(kLikelyStart, cone, cylinder),
                                       Compare(kLikelyStart, frustum, segment), Compare(kLikelyStart, cylinder, box)}) {
    EXPECT_LT(iterations.on, iterations.off);
  }
}

// What a core does not know of itself costs directions at most.
TEST(LikelyStart, CoresWithoutSpread_GiveTheSameAnswer) {
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({0.1, 0.7, 1.5})};
  const dgd::RoundedSet triangle{dgd::Triangle<double>({1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
  static_assert(!dgd::SpreadCore<dgd::Triangle<double>> && dgd::SpreadCore<dgd::Ellipsoid<double>>);
  Compare(kLikelyStart, ellipsoid, triangle);
}

// More steps, each for less.
TEST(FacetWalkSetting, SharpPolytopes_GiveTheSameAnswer) {
  Random random(7);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20; ++i) points.push_back(random.UnitVector());
  const dgd::RoundedSet box{dgd::Box<double>({0.3, 0.7, 1.1})};
  const dgd::RoundedSet hull{dgd::Polytope<double>(points)};
  const Iterations iterations = Compare(kFacetWalk, hull, hull);
  EXPECT_GT(iterations.on, iterations.off);
  Compare(kFacetWalk, box, hull);
}

TEST(SecondOrder, CurvedSets_NeedFewerIterationsForTheSameAnswer) {
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({0.3, 0.7, 1.1})};
  const dgd::RoundedSet cone{dgd::Cone<double>(0.6, 1.5)};
  const dgd::RoundedSet cylinder{dgd::Cylinder<double>(0.5, 0.8), 0.1};
  const dgd::RoundedSet box{dgd::Box<double>({0.3, 0.7, 1.1})};
  for (const Iterations& iterations :
       {Compare(kSecondOrder, ellipsoid, ellipsoid), Compare(kSecondOrder, ellipsoid, cone),
        Compare(kSecondOrder, cone, cylinder), Compare(kSecondOrder, cylinder, box)}) {
    EXPECT_LT(iterations.on, 0.8 * iterations.off);
  }
}

TEST(SecondOrder, CurvedSetsOfThePlane_NeedFewerIterationsForTheSameAnswer) {
  const dgd::RoundedSet ellipse{dgd::Ellipse<double>({0.3, 1.1})};
  const Iterations iterations = Compare(kSecondOrder, ellipse, ellipse);
  EXPECT_LT(iterations.on, iterations.off);
}

TEST(SecondOrder, Polytopes_TakeNoSuchSteps) {
  const dgd::RoundedSet box{dgd::Box<double>({0.3, 0.7, 1.1}), 0.1};
  const Iterations iterations = Compare(kSecondOrder, box, box);
  EXPECT_EQ(iterations.on, iterations.off);
}

TEST(Rounding, RoundedPolytopes_NeedFewerIterationsForTheSameAnswer) {
  const dgd::RoundedSet box{dgd::Box<double>({0.3, 0.7, 1.1}), 0.2};
  const dgd::RoundedSet capsule = dgd::Capsule(0.4, 0.9);
  const dgd::RoundedSet stadium = dgd::Stadium(0.4, 0.9);
  const dgd::RoundedSet rectangle{dgd::Rectangle<double>({0.3, 1.1}), 0.2};
  for (const Iterations& iterations :
       {Compare(kRounding, box, box), Compare(kRounding, box, capsule), Compare(kRounding, stadium, rectangle)}) {
    EXPECT_LT(iterations.on, iterations.off);
  }
}

TEST(Rounding, RoundedCurvedSets_GiveTheSameAnswer) {
  const dgd::RoundedSet cone{dgd::Cone<double>(0.6, 1.5), 0.2};
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({0.3, 0.7, 1.1}), 0.1};
  Compare(kRounding, cone, ellipsoid);
}

TEST(Rounding, SetsWithoutARadius_AreTheSameQuery) {
  const dgd::RoundedSet box{dgd::Box<double>({0.3, 0.7, 1.1})};
  const Iterations iterations = Compare(kRounding, box, box);
  EXPECT_EQ(iterations.on, iterations.off);
}

TEST(KnownPoints, PolytopesAndCurvedSets_NeedFewerIterationsForTheSameAnswer) {
  Random random(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 300; ++i) points.push_back(random.UnitVector());
  const dgd::RoundedSet mesh{dgd::Mesh<double>(points)};
  const dgd::RoundedSet rounded{dgd::Polytope<double>(std::span(points).first(20)), 0.1};
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({0.3, 0.7, 1.1})};
  for (const Iterations& iterations : {Compare(kKnownPoints, mesh, mesh), Compare(kKnownPoints, rounded, rounded),
                                       Compare(kKnownPoints, mesh, rounded)}) {
    EXPECT_LT(iterations.on, 0.85 * iterations.off);
  }
  const Iterations curved = Compare(kKnownPoints, mesh, ellipsoid, {.second_order = false});
  EXPECT_LT(curved.on, curved.off);
}

TEST(HalfWayCuts, CuttingPlanesOnThinEdges_NeedFewerIterationsForTheSameAnswer) {
  // Nearly flat, with a rim of little radius: support points swing from one face to the other.
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-1, 1}) {
    for (const double y : {-0.6, 0.6}) {
      for (const double z : {-0.02, 0.02}) corners.emplace_back(x, y, z);
    }
  }
  const dgd::RoundedSet plate{dgd::Dsf<double>(corners, 40)};
  const dgd::RoundedSet lens{dgd::Ellipsoid<double>({0.3, 0.7, 0.02})};
  const Iterations iterations = Compare(kHalfWayCuts, plate, lens, {.second_order = false});
  EXPECT_LT(iterations.on, iterations.off);
}

TEST(HalfWayCuts, Polytopes_TakeNone) {
  const dgd::RoundedSet box{dgd::Box<double>({0.3, 0.7, 1.1}), 0.1};
  const Iterations iterations = Compare(kHalfWayCuts, box, box);
  EXPECT_EQ(iterations.on, iterations.off);
}

}  // namespace
}  // namespace dgd_test
