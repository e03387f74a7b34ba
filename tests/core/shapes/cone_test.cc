#include "dgd/shapes/cone.h"

#include <cmath>
#include <limits>

#include "support/shape_contract.h"

namespace dgd_test {
namespace {

/// See cylinder_test.cc.
constexpr double kOctagonSagitta = 0.0762;

TEST(Cone, Contract_HoldsForAllProportions) {
  for (const double radius : {0.0, 1e-6, 0.3, 50.0}) {
    for (const double height : {0.0, 1e-6, 0.5, 100.0}) {
      SCOPED_TRACE(::testing::Message() << radius << " " << height);
      CheckShape(dgd::Cone<double>(radius, height), {.type = CoreType::kCone, .size = {radius, height, 0}},
                 kOctagonSagitta * radius);
      const auto radius_f = static_cast<float>(radius), height_f = static_cast<float>(height);
      CheckShape(dgd::Cone<float>(radius_f, height_f),
                 {.type = CoreType::kCone, .size = {double(radius_f), double(height_f), 0}}, kOctagonSagitta * radius);
    }
  }
}

// The largest ball about the centroid, by the distance to the base and to the side.
TEST(Cone, Inradius_IsTheLargestBallAboutTheCentroid) {
  EXPECT_NEAR(dgd::Cone<double>(3, 4).Inradius(), 1, 4e-15);  // The base is nearer. Never above, for roundoff.
  EXPECT_LE(dgd::Cone<double>(3, 4).Inradius(), 1);
  EXPECT_NEAR(dgd::Cone<double>(0.3, 0.4).Inradius(), 0.1, 1e-15);
  EXPECT_NEAR(dgd::Cone<double>(5, 12 * 4).Inradius(), 36 * 5 / std::hypot(5.0, 48.0), 2e-14);  // The side is.
  EXPECT_EQ(dgd::Cone<double>(0, 1).Inradius(), 0);
  EXPECT_EQ(dgd::Cone<double>(1, 0).Inradius(), 0);
  EXPECT_EQ(dgd::Cone<double>(0, 0).Inradius(), 0);
}

TEST(Cone, Constructor_RejectsBadSizesNamingThem) {
  ExpectRejected([] { return dgd::Cone<double>(-1.5, 1); }, "cone radius must be finite and >= 0, in metres; got -1.5");
  ExpectRejected([] { return dgd::Cone<double>(1, -0.5); }, "cone height");
  ExpectRejected([] { return dgd::Cone<double>(std::numeric_limits<double>::quiet_NaN(), 1); }, "nan");
  ExpectRejected([] { return dgd::Cone<double>(1, std::numeric_limits<double>::infinity()); }, "inf");
}

}  // namespace
}  // namespace dgd_test
