// The shapes of the plane that share a template with those of space; and the sets that are a core and a radius.
#include <limits>

#include "dgd/shapes.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

using Eigen::Vector2d;

TEST(Point2d, Contract_Holds) {
  const ExpectedSet<2> expected = ExpectedHull<2>({{0, 0}});
  CheckExpected(dgd::Point<double, 2>(), expected);
  CheckExpected(dgd::Point<float, 2>(), expected);
}

TEST(Segment2d, Contract_HoldsForManyLengths) {
  for (const double half_length : {0.0, 1e-6, 0.5, 1e3}) {
    CheckExpected(dgd::Segment<double, 2>(half_length), ExpectedHull<2>({{0, half_length}, {0, -half_length}}));
  }
  CheckExpected(dgd::Segment<float, 2>(0.5F), ExpectedHull<2>({{0, 0.5}, {0, -0.5}}));
}

TEST(Rectangle, Contract_HoldsForSolidAndFlatOnes) {
  for (const Vector2d& half :
       {Vector2d(1, 1), Vector2d(0.1, 30), Vector2d(1, 0), Vector2d(0, 0), Vector2d(1e-6, 2e-6)}) {
    const ExpectedSet<2> expected = ExpectedHull<2>({half, -half, {half.x(), -half.y()}, {-half.x(), half.y()}});
    CheckExpected(dgd::Rectangle<double>(half), expected);
  }
  CheckExpected(dgd::Rectangle<float>({1, 2}), ExpectedHull<2>({{1, 2}, {-1, 2}, {1, -2}, {-1, -2}}));
  EXPECT_EQ(dgd::Rectangle<double>({3, 0.5}).Inradius(), 0.5);
  EXPECT_EQ(dgd::Rectangle<double>({3, 0.5}).VertexCount(), 4U);
}

TEST(Rectangle, Constructor_RejectsBadExtentsNamingThem) {
  ExpectRejected([] { return dgd::Rectangle<double>({1, -2.5}); }, "box half extent must be finite and >= 0");
}

TEST(RoundedShapes, AreACoreAndARadius) {
  EXPECT_EQ(dgd::Sphere(0.5).radius, 0.5);
  EXPECT_EQ(dgd::Capsule(0.5, 2.0).radius, 0.5);
  EXPECT_EQ(dgd::Capsule(0.5, 2.0).core.Vertex(0), Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(dgd::Circle(0.5F).radius, 0.5F);
  EXPECT_EQ(dgd::Circle(0.5F).core.Center(), Eigen::Vector2f(0, 0));
  EXPECT_EQ(dgd::Stadium(0.5, 2.0).radius, 0.5);
  EXPECT_EQ(dgd::Stadium(0.5, 2.0).core.Vertex(1), Vector2d(0, -2));
}

// A name without arguments takes its type from a set as from a core.
TEST(RoundedShapes, InitialiseASetWhoseTypeIsDeduced) {
  const dgd::RoundedSet sphere = dgd::Sphere(0.5);
  EXPECT_EQ(sphere.radius, 0.5);
  static_assert(!dgd::ConvexCore<decltype(sphere)>);
  static_assert(!dgd::ConvexCore<int>);
}

TEST(RoundedShapes, RejectBadSizesNamingThem) {
  ExpectRejected([] { return dgd::Sphere(0.0); }, "sphere radius must be finite and > 0, in metres; got 0.0");
  ExpectRejected([] { return dgd::Sphere(std::numeric_limits<double>::quiet_NaN()); }, "nan");
  ExpectRejected([] { return dgd::Capsule(-1.0, 1.0); }, "capsule radius");
  ExpectRejected([] { return dgd::Capsule(1.0, -1.0); }, "capsule half length must be finite and >= 0");
  ExpectRejected([] { return dgd::Circle(std::numeric_limits<double>::infinity()); }, "circle radius");
  ExpectRejected([] { return dgd::Stadium(0.0, 1.0); }, "stadium radius");
  ExpectRejected([] { return dgd::Stadium(1.0, -0.5); }, "stadium half length");
}

}  // namespace
}  // namespace dgd_test
