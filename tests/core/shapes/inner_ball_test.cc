// Hulls that are scaled about a centre near their partner: the ball about it is inside, wherever it is.
#include "dgd/shapes/inner_ball.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "dgd/any_set.h"
#include "dgd/certificate.h"
#include "dgd/shapes/polytope.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using Hull = dgd::Polytope<double>;

Points BoxPoints(const Vector3d& half) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z());
  }
  return points;
}

Points Disc(double radius, double half_height, int sides) {
  Points points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double z : {-half_height, half_height}) {
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  return points;
}

/// A ramp of length 100 that ends in an edge.
Points Wedge() { return {{0, -5, 0}, {0, 5, 0}, {0, -5, 2}, {0, 5, 2}, {100, -5, 0}, {100, 5, 0}}; }

/// Flat and long ones, with up to 1e4 times the length for the thickness, in any place and orientation.
std::vector<Points> ElongatedSets(Random& random) {
  std::vector<Points> sets = {BoxPoints({50, 50, 0.5}), BoxPoints({0.01, 0.01, 1}), Disc(5, 0.1, 32), Disc(1, 30, 12),
                              Wedge()};
  for (int i = 0; i < 100; ++i) {
    Points points;
    const Vector3d size(1, random.LogUniform(1e-4, 1), random.LogUniform(1e-4, 0.2));
    for (int count = 4 + random.Below(40); count > 0; --count) points.push_back(size.cwiseProduct(random.InCube()));
    sets.push_back(points);
  }
  for (Points& points : sets) {
    const Eigen::Matrix3d rotation = random.Rotation();
    const Vector3d offset = random.InCube();
    for (Vector3d& point : points) point = rotation * point + offset;
  }
  return sets;
}

/// How far a ball about a point may reach until it leaves the hull; by facets that the hull's own planes are not made
/// of.
double RoomAbout(const Vector3d& center, const dgd::ConvexHull& hull) {
  double room = std::numeric_limits<double>::infinity();
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    for (int i = hull.facet_start[facet]; i < hull.facet_start[facet + 1]; ++i) {
      const Vector3d& corner = hull.vertices[hull.facet_vertices[std::size_t(i)]];
      room = std::min(room, hull.normals[facet].dot(corner - center));
    }
  }
  return room;
}

template <class S>
void CheckBalls(const Points& points, Random& random) {
  const dgd::Polytope<S> hull{points};
  if (!(hull.Inradius() > 0)) return;
  for (int i = 0; i < 100; ++i) {
    const Vector3d about = hull.Hull().vertices[std::size_t(random.Below(int(hull.VertexCount())))];
    const Vector3d point = about + random.LogUniform(1e-4, 100) * random.UnitVector();
    const dgd::InnerBall<S> ball = hull.BallNear(point.cast<S>());
    ASSERT_GE(ball.radius, hull.Inradius() / 11);
    // What S makes of a vertex is the double's within half a digit of each coordinate.
    ASSERT_LE(double(ball.radius), RoomAbout(ball.center.template cast<double>(), hull.Hull()));
  }
}

TEST(InnerBall, OfElongatedHulls_IsInsideWhereverTheirPartnerIs) {
  Random random(TestSeed());
  for (const Points& points : ElongatedSets(random)) {
    CheckBalls<double>(points, random);
    CheckBalls<float>(points, random);
  }
}

TEST(InnerBall, InFrontOfAFace_IsStraightBehindThePoint) {
  const Hull slab{BoxPoints({50, 50, 0.5})}, disc{Disc(5, 0.1, 32)}, wedge{Wedge()};
  for (const double x : {0.0, 30.0, 49.4}) {
    EXPECT_NEAR((slab.BallNear({x, -x, 0.55}).center - Vector3d(x, -x, 0)).norm(), 0, 0.01) << x;
    EXPECT_NEAR((disc.BallNear({x / 10.5, 0, -0.4}).center - Vector3d(x / 10.5, 0, 0)).norm(), 0, 0.002) << x;
  }
  EXPECT_NEAR((slab.BallNear({50.3, 0, 0.7}).center - Vector3d(49.5, 0, 0)).norm(), 0, 0.01) << "as of a box";
  EXPECT_NEAR(wedge.BallNear({90, 4, 0.5}).center.x(), 90, 0.5) << "0.2 thick there";
}

TEST(InnerBall, OfRoundFlatAndWrongInput_StaysTheHulls) {
  const auto stays = [](const Hull& hull, const Vector3d& point) {
    const auto ball = hull.BallNear(point);
    return ball.center == hull.Center() && ball.radius == hull.Inradius();
  };
  EXPECT_TRUE(stays(Hull{BoxPoints({1, 1, 1})}, {3, 1, 1}));
  EXPECT_TRUE(stays(Hull{BoxPoints({1, 1, 0.5})}, {3, 1, 1}));
  EXPECT_TRUE(stays(Hull{BoxPoints({1, 1, 0})}, {3, 1, 1})) << "no ball at all";
  EXPECT_TRUE(stays(Hull{BoxPoints({1, 0, 0})}, {3, 1, 1}));
  const Hull slab{BoxPoints({50, 50, 0.5})};
  EXPECT_FALSE(stays(slab, {3, 1, 1}));
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(stays(slab, {wrong, 0, 0}));
  }
}

// Whether a hull moves its centre must not depend on how many queries it has had.
TEST(InnerBall, HullsWithoutFacets_AreRound) {
  Random random(TestSeed());
  for (const Points& points : ElongatedSets(random)) {
    const auto hull = dgd::HullWithoutFacets(points);
    if (!hull) continue;
    const Vector3d point = 10 * random.UnitVector();
    const Hull first(*hull), later(dgd::WithFacets(*hull));
    EXPECT_EQ(first.BallNear(point).center, later.BallNear(point).center);
  }
  EXPECT_FALSE(dgd::HullWithoutFacets(BoxPoints({50, 50, 0.5})));
  EXPECT_TRUE(dgd::HullWithoutFacets(BoxPoints({1, 1, 0.5})));
}

TEST(InnerBall, GrowthDistanceAboutIt_IsCertified) {
  Random random(TestSeed());
  const std::vector<Points> sets = ElongatedSets(random);
  int overlaps = 0, count = 0;
  for (const Points& points : sets) {
    const Hull large{points}, small{BoxPoints({0.02, 0.02, 0.02})};
    if (!(large.Inradius() > 0)) continue;
    for (int i = 0; i < 20; ++i) {
      dgd::AnySet a = dgd::RoundedSet{dgd::CoreReference<Hull>(large)};
      const dgd::AnySet b = dgd::RoundedSet{dgd::CoreReference<Hull>(small)};
      const Vector3d on_a = large.Support(random.UnitVector()).point;
      const double share = random.Uniform(0, 1.05);
      const dgd::Pose<double> pose_a, pose_b{random.Rotation(), large.Center() + share * (on_a - large.Center())};
      a.MoveCenterNear(pose_b.translation);
      const auto result = dgd::GrowthDistance(a, pose_a, b, pose_b);
      if (result.status == dgd::Status::kCoincidentCenters) continue;
      ASSERT_EQ(result.status, dgd::Status::kOptimal);
      const dgd::Certificate certificate = dgd::Certify(*a.AsPolytope(), pose_a, *b.AsPolytope(), pose_b, result);
      EXPECT_TRUE(certificate.Holds(1e-9, 1e-6)) << certificate.relative_gap << " " << certificate.primal_infeasibility;
      ++count;
      overlaps += result.upper_bound < 1;
    }
  }
  EXPECT_GT(overlaps, count / 4);
  EXPECT_LT(overlaps, count);
}

}  // namespace
}  // namespace dgd_test
