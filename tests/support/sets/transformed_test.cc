#include "support/sets/transformed.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/shapes.h"
#include "support/random_sets.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// See cylinder_test.cc.
constexpr double kOctagonSagitta = 0.0762;

/// The image of a set under x -> A x + b, by the support function's own rule.
template <int L>
ExpectedSet<L> ImageOf(const ExpectedSet<L>& expected, const dgd::SquareMatrix<double, L>& linear,
                       const dgd::Vector<double, L>& offset) {
  const double stretch = linear.norm(), least = 1 / linear.inverse().norm();
  ExpectedSet<L> image;
  image.extent = stretch * expected.extent;
  // Digits of the inner core's distances are lost to the ratio of the stretches.
  image.reach = (stretch / least) * (stretch * expected.reach + offset.norm());
  image.height = [expected, linear, offset](const dgd::Vector<double, L>& direction) {
    const dgd::Vector<double, L> d = linear.transpose() * direction;
    return (d.norm() > 0 ? d.norm() * expected.height(d.normalized()) : 0) + direction.dot(offset);
  };
  return image;
}

/// Sheared, stretched and mirrored, but with coordinates that a float holds.
Matrix3d Shear() {
  Matrix3d linear;
  linear << 1.5, 0.25, 0, -0.5, 1, 0.125, 0, 0.75, -2;
  return linear;
}
Vector3d Offset() { return {0.25, -1, 3}; }

template <class Core>
void CheckTransformed(const Core& core, const ExpectedSet<3>& expected, double discretisation = 0) {
  using S = typename Core::Scalar;
  const Transformed<Core> transformed(core, Shear().cast<S>(), Offset().cast<S>());
  CheckExpected(transformed, ImageOf<3>(expected, Shear(), Offset()), 3 * discretisation);
}

TEST(Transformed, Contract_HoldsForVertexCores) {
  CheckTransformed(dgd::Point<double>(), Expected({.type = CoreType::kPoint}));
  CheckTransformed(dgd::Segment<double>(0.7), Expected({.type = CoreType::kSegment, .size = {0.7, 0, 0}}));
  CheckTransformed(dgd::Box<double>({0.1, 0.5, 1}), Expected({.type = CoreType::kBox, .size = {0.1, 0.5, 1}}));
  CheckTransformed(dgd::Box<float>({0.25, 0.5, 1}), Expected({.type = CoreType::kBox, .size = {0.25, 0.5, 1}}));
  Random random(TestSeed());
  const ReferenceSet hull = RandomHull(random, 30, 1, 0);
  CheckTransformed(dgd::Polytope<double>(hull.points), Expected(hull));
  CheckTransformed(dgd::Mesh<double>(hull.points), Expected(hull));
}

TEST(Transformed, Contract_HoldsForSmoothCores) {
  CheckTransformed(dgd::Ellipsoid<double>({0.1, 0.5, 1}),
                   Expected({.type = CoreType::kEllipsoid, .size = {0.1, 0.5, 1}}));
  CheckTransformed(dgd::Cylinder<double>(0.5, 1), Expected({.type = CoreType::kCylinder, .size = {0.5, 1, 0}}),
                   kOctagonSagitta);
  CheckTransformed(dgd::Cone<double>(0.5, 1), Expected({.type = CoreType::kCone, .size = {0.5, 1, 0}}),
                   kOctagonSagitta);
  CheckTransformed(dgd::Cylinder<float>(0.5, 1), Expected({.type = CoreType::kCylinder, .size = {0.5, 1, 0}}),
                   kOctagonSagitta);
}

TEST(Transformed, Contract_HoldsInThePlane) {
  Eigen::Matrix2d linear;
  linear << 1, -0.5, 0.25, 2;
  const Eigen::Vector2d offset(3, -1);
  const auto ellipse = [](const Eigen::Vector2d& d) { return std::hypot(0.3 * d.x(), d.y()); };
  CheckExpected(Transformed(dgd::Ellipse<double>({0.3, 1}), linear, offset),
                ImageOf<2>({ellipse, 2, 2}, linear, offset));
  CheckExpected(Transformed(dgd::Rectangle<double>({1, 2}), linear, offset),
                ImageOf<2>(ExpectedHull<2>({{1, 2}, {-1, 2}, {1, -2}, {-1, -2}}), linear, offset));
}

// Its caps are ellipses, which the solver's way with flat faces would take for discs.
TEST(Transformed, FaceNormals_AreNotHandedOn) {
  static_assert(dgd::FacedCore<dgd::Cylinder<double>>);
  static_assert(!dgd::FacedCore<Transformed<dgd::Cylinder<double>>>);
}

// A ball stretched along its axes is an ellipsoid, whose distance is known by another way.
TEST(Transformed, Distance_IsTheEllipsoidsForAStretchedBall) {
  Random random(TestSeed());
  for (int i = 0; i < 300; ++i) {
    const Vector3d axes(random.LogUniform(0.01, 1), random.LogUniform(0.01, 1), random.LogUniform(0.01, 1));
    const Transformed<dgd::Ellipsoid<double>> ball(dgd::Ellipsoid<double>({1, 1, 1}), axes.asDiagonal(),
                                                   Vector3d::Zero());
    const dgd::Ellipsoid<double> ellipsoid(axes);
    const Vector3d normal = random.UnitVector();
    const Vector3d point = ellipsoid.Support(normal).point + random.LogUniform(1e-6, 10) * normal;
    EXPECT_NEAR(ball.Distance(point), ellipsoid.Distance(point), 1e-14 * (1 + point.norm())) << axes.transpose();
    EXPECT_EQ(ball.Distance(0.999 * ellipsoid.Support(normal).point), 0);
  }
}

TEST(Transformed, Inradius_IsNeverTooLarge) {
  const Matrix3d stretch = Vector3d(1, 0.5, 4).asDiagonal();
  const Transformed<dgd::Box<double>> box(dgd::Box<double>({2, 3, 4}), stretch, Vector3d::Zero());
  EXPECT_LE(box.Inradius(), 1);
  EXPECT_NEAR(box.Inradius(), 1, 1e-13);
}

TEST(Transformed, Constructor_RejectsSingularAndNonFiniteMaps) {
  const auto make = [](const Matrix3d& linear, const Vector3d& offset) {
    return Transformed<dgd::Point<double>>(dgd::Point<double>(), linear, offset);
  };
  Matrix3d linear = Matrix3d::Identity();
  linear(2, 2) = 0;
  ExpectRejected([&] { return make(linear, Vector3d::Zero()); }, "must be invertible");
  linear(2, 2) = 1e-13;
  ExpectRejected([&] { return make(linear, Vector3d::Zero()); }, "its largest singular value at most");
  linear(2, 2) = 1e-11;
  EXPECT_NO_THROW(make(linear, Vector3d::Zero()));
  linear(2, 2) = std::numeric_limits<double>::quiet_NaN();
  ExpectRejected([&] { return make(linear, Vector3d::Zero()); }, "the matrix of an affine map must be finite");
  ExpectRejected(
      [&] {
        return make(Matrix3d::Identity(), {0, std::numeric_limits<double>::infinity(), 0});
      },
      "the offset of an affine map must be finite");
}

}  // namespace
}  // namespace dgd_test
