// Contract: Bullet's shape is the same set as CoreOf() + a ball of RoundingRadius(), the one that the oracle judges by
// and the pictures show; a box has its full size, and edges of that radius. Two convex sets are equal if their support
// functions are.
#include "simulation/bullet_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "scene/random.h"
#include "scene/random_polytope.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

double SupportOf(const Polyhedron& core, double radius, const Vector3d& unit) {
  double support = -std::numeric_limits<double>::infinity();
  for (const Vector3d& vertex : core.vertices) support = std::max(support, unit.dot(vertex));
  return support + radius;
}

// What Bullet's GJK sees: the support point without the margin, and a ball of the margin. Of boxes, the sharp corner,
// drawn in to where the ball is that touches the three sides.
double SupportOf(const btConvexShape& shape, double radius, const Vector3d& unit) {
  if (shape.getShapeType() == BOX_SHAPE_PROXYTYPE) {
    const Vector3d corner = FromBullet(shape.localGetSupportingVertex(ToBullet(unit)));
    return unit.dot(corner) - radius * (unit.lpNorm<1>() - 1);
  }
  const Vector3d point = FromBullet(shape.localGetSupportVertexWithoutMarginNonVirtual(ToBullet(unit)));
  return unit.dot(point) + shape.getMarginNonVirtual();
}

class BulletShapeTest : public testing::TestWithParam<double> {};

TEST_P(BulletShapeTest, EveryShape_HasTheSupportOfItsDescription) {
  const double margin = GetParam();
  Random random(41, 0);
  const struct {
    Shape shape;
    double polygon_error;  // Of CoreOf().
  } cases[] = {{Sphere{0.7}, 0},
               {Capsule{0.3, 1.2}, 0},
               {Box{Vector3d(0.5, 0.8, 0.2)}, 0},
               {Cylinder{0.6, 1}, 0.0013 * 0.6},
               {Cone{0.6, 1}, 0.0013 * 0.6},
               {Hull{RandomPolytope(random, 14, 1)}, 0}};
  constexpr double kRounding = 1e-6;  // Of Bullet in float, at sizes of one metre.
  for (const auto& [shape, polygon_error] : cases) {
    const auto bullet = MakeBulletShape(shape, margin);
    const Polyhedron core = CoreOf(shape, margin);
    const double radius = RoundingRadius(shape, margin);
    for (int i = 0; i < 500; ++i) {
      const Vector3d unit = random.UnitVector();
      const double expected = SupportOf(core, radius, unit);
      EXPECT_GE(SupportOf(*bullet, radius, unit), expected - kRounding) << bullet->getName();
      EXPECT_LE(SupportOf(*bullet, radius, unit), expected + polygon_error + kRounding) << bullet->getName();
    }
  }
}

// Against Bullet's own narrowphase, which rounds a box's edges by its margin but where its partner is a box.
TEST_P(BulletShapeTest, Box_HasTheMarginThatBulletGivesIt) {
  const auto box = MakeBulletShape(Box{Vector3d(0.5, 0.8, 0.2)}, GetParam());
  EXPECT_NEAR(double(box->getMarginNonVirtual()), std::min(GetParam(), 0.02), 1e-8);
}

// The radius is documented: a 512th of the least half extent, or the margin if that is less.
TEST(RoundingRadiusTest, Boxes_AreAsGoodAsSharp) {
  const Box box{Vector3d(0.5, 0.8, 0.2)};
  EXPECT_EQ(RoundingRadius(box, 0.04), 0.2 / 512);
  EXPECT_EQ(RoundingRadius(box, 1e-4), 1e-4);
  EXPECT_EQ(RoundingRadius(box, 0), 0);
}

INSTANTIATE_TEST_SUITE_P(Margins, BulletShapeTest, testing::Values(0.0, 0.01, 0.04, 0.3));

}  // namespace
}  // namespace dgd_demos
