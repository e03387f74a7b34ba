// The referee itself, against closed forms.
#include "support/distance_bounds.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/random.h"

namespace dgd_test {
namespace {

using Vector = Eigen::Vector3d;

constexpr double kLength = 1e-10;

void ExpectDistance(const DistanceBounds& bounds, double distance, const Vector& normal) {
  EXPECT_NEAR(bounds.lower, distance, kLength);
  EXPECT_NEAR(bounds.upper, distance, kLength);
  // A flat optimum leaves the root of its height to the normal.
  EXPECT_NEAR((bounds.normal - normal).norm(), 0, 1e-5);
}

TEST(DistanceBounds, Ball_InsideAndOutside) {
  Random random(TestSeed());
  for (int i = 0; i < 200; ++i) {
    const double radius = random.LogUniform(0.01, 1);
    const Vector center = random.Uniform(0.1, 3) * radius * random.UnitVector();
    const DistanceBounds bounds =
        BoundDistanceToOrigin([&](const Vector& d) -> Vector { return center + radius * d.normalized(); });
    ExpectDistance(bounds, center.norm() - radius, -center.normalized());
  }
}

TEST(DistanceBounds, Box_InsideAndOutside) {
  Random random(TestSeed());
  int inside = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector half(random.Uniform(0.1, 1), random.Uniform(0.1, 1), random.Uniform(0.1, 1));
    const Eigen::Matrix3d rotation = random.Rotation();
    const Vector at =
        1.5 * random.InCube().cwiseProduct(half);  // Of the origin, from the box's centre, along its axes.
    const DistanceBounds bounds = BoundDistanceToOrigin([&](const Vector& d) -> Vector {
      const Vector local = rotation.transpose() * d;
      const Vector corner = local.cwiseSign().cwiseProduct(half);
      return rotation * (corner - at);
    });
    const Vector over = at.cwiseAbs() - half;
    int axis = 0;
    const double nearest = over.maxCoeff(&axis);
    Vector normal = over.cwiseMax(0).cwiseProduct(at.cwiseSign());
    if (nearest < 0) normal = at.cwiseSign()[axis] * Vector::Unit(axis);
    inside += nearest < 0 ? 1 : 0;
    ExpectDistance(bounds, nearest < 0 ? nearest : normal.norm(), rotation * normal.normalized());
  }
  EXPECT_GT(inside, 40);
  EXPECT_LT(inside, 160);
}

TEST(DistanceBounds, FlatDisc_HasNoInside) {
  const auto disc = [](double height) {
    return BoundDistanceToOrigin([height](const Vector& d) -> Vector {
      const double across = d.head<2>().norm();
      const Eigen::Vector2d rim = across > 0 ? Eigen::Vector2d(d.head<2>() / across) : Eigen::Vector2d::UnitX();
      return {rim.x(), rim.y(), height};
    });
  };
  ExpectDistance(disc(0.2), 0.2, -Vector::UnitZ());
  EXPECT_LE(disc(0).upper, kLength);
}

}  // namespace
}  // namespace dgd_test
