#include "dgd/shapes/cylinder.h"

#include <cmath>
#include <limits>

#include "dgd/solver/tolerances.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

/// An octagon inscribed in the caps falls short by this part of the radius: 1 - cos(pi / 8).
constexpr double kOctagonSagitta = 0.0762;

TEST(Cylinder, Contract_HoldsForAllProportions) {
  for (const double radius : {0.0, 1e-6, 0.3, 50.0}) {
    for (const double half_height : {0.0, 1e-6, 0.5, 100.0}) {
      SCOPED_TRACE(::testing::Message() << radius << " " << half_height);
      CheckShape(dgd::Cylinder<double>(radius, half_height),
                 {.type = CoreType::kCylinder, .size = {radius, half_height, 0}}, kOctagonSagitta * radius);
      const auto radius_f = static_cast<float>(radius), half_height_f = static_cast<float>(half_height);
      CheckShape(dgd::Cylinder<float>(radius_f, half_height_f),
                 {.type = CoreType::kCylinder, .size = {double(radius_f), double(half_height_f), 0}},
                 kOctagonSagitta * radius);
    }
  }
}

TEST(Cylinder, SupportFace_HoldsTheSupportPoint) {
  Random random(TestSeed());
  const dgd::Cylinder<double> cylinder(0.7, 0.4);
  for (const Eigen::Vector3d& direction : Directions(random)) {
    dgd::SupportingFace<double> face;
    cylinder.SupportFace(direction, face);
    EXPECT_EQ(face.points[0], cylinder.Support(direction).point + Eigen::Vector3d(0, 0, 0)) << direction.transpose();
  }
}

// A direction across the caps whose lateral part underflows when it is squared must still give a point of the disc.
template <class S>
void CheckUnderflow() {
  const dgd::Cylinder<S> cylinder(1, 1);
  const S tiny = std::sqrt(std::numeric_limits<S>::denorm_min());
  for (int i = 1; i < 400; ++i) {
    const S lateral = tiny * static_cast<S>(i) / 16;
    const dgd::Vector3<S> straight = cylinder.Support({lateral, 0, 1}).point;
    const dgd::Vector3<S> diagonal = cylinder.Support({lateral, lateral, 1}).point;
    ASSERT_LE(cylinder.Distance(straight), 4 * dgd::kEpsilon<S>) << lateral;
    ASSERT_LE(cylinder.Distance(diagonal), 4 * dgd::kEpsilon<S>) << lateral;
  }
}
TEST(Cylinder, Support_StaysOnDiscWhereSquaresUnderflow) {
  CheckUnderflow<double>();
  CheckUnderflow<float>();
}

TEST(Cylinder, Constructor_RejectsBadSizesNamingThem) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectRejected([] { return dgd::Cylinder<double>(-1.5, 1); },
                 "cylinder radius must be finite and >= 0, in metres; got -1.5");
  ExpectRejected([] { return dgd::Cylinder<double>(1, -0.5); }, "cylinder half height");
  ExpectRejected([&] { return dgd::Cylinder<double>(nan, 1); }, "nan");
  ExpectRejected([] { return dgd::Cylinder<double>(1, std::numeric_limits<double>::infinity()); }, "inf");
}

}  // namespace
}  // namespace dgd_test
