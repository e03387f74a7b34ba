// Contract: Bullet's shape is the same set as CoreOf() + a ball of RoundingRadius(), the one that the oracle judges by
// and the pictures show. Two convex sets are equal if their support functions are.
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

// What Bullet's GJK sees: the support point without the margin, and a ball of the margin.
double SupportOf(const btConvexShape& shape, const Vector3d& unit) {
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
    for (int i = 0; i < 500; ++i) {
      const Vector3d unit = random.UnitVector();
      const double expected = SupportOf(core, RoundingRadius(shape, margin), unit);
      EXPECT_GE(SupportOf(*bullet, unit), expected - kRounding) << bullet->getName();
      EXPECT_LE(SupportOf(*bullet, unit), expected + polygon_error + kRounding) << bullet->getName();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, BulletShapeTest, testing::Values(0.0, 0.01, 0.04, 0.3));

}  // namespace
}  // namespace dgd_demos
