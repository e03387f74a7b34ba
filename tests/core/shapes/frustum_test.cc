#include "dgd/shapes/frustum.h"

#include <algorithm>
#include <limits>

#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "support/shape_contract.h"

namespace dgd_test {
namespace {

/// See cylinder_test.cc.
constexpr double kOctagonSagitta = 0.0762;

template <class S>
void CheckFrustum(double base_radius, double top_radius, double height) {
  const S base = static_cast<S>(base_radius), top = static_cast<S>(top_radius), tall = static_cast<S>(height);
  CheckShape(dgd::Frustum<S>(base, top, tall),
             {.type = CoreType::kFrustum, .size = {double(base), double(top), double(tall)}},
             kOctagonSagitta * std::max(base_radius, top_radius));
}

TEST(Frustum, Contract_HoldsForAllProportions) {
  for (const double base_radius : {0.0, 1e-6, 0.3, 50.0}) {
    for (const double top_radius : {0.0, 0.2, 50.0}) {
      for (const double height : {0.0, 1e-6, 0.5, 100.0}) {
        SCOPED_TRACE(::testing::Message() << base_radius << " " << top_radius << " " << height);
        CheckFrustum<double>(base_radius, top_radius, height);
        CheckFrustum<float>(base_radius, top_radius, height);
      }
    }
  }
}

TEST(Frustum, CenterAndInradius_AreThoseOfCylinderAndCone) {
  EXPECT_EQ(dgd::Frustum<double>(0.5, 0.5, 2).Center(), Eigen::Vector3d(0, 0, 0));
  EXPECT_NEAR(dgd::Frustum<double>(0.5, 0.5, 2).Inradius(), 0.5, 1e-14);
  EXPECT_EQ(dgd::Frustum<double>(3, 0, 4).Center(), dgd::Cone<double>(3, 4).Center());
  EXPECT_EQ(dgd::Frustum<double>(0, 3, 4).Center(), Eigen::Vector3d(0, 0, 1));
  EXPECT_NEAR(dgd::Frustum<double>(5, 0, 48).Inradius(), dgd::Cone<double>(5, 48).Inradius(), 1e-13);
  // Stacked discs: radii 2 to 1 over height 1; the moment is 11 / 12, the volume 7 / 3.
  EXPECT_NEAR(dgd::Frustum<double>(2, 1, 1).Center().z(), 11.0 / 28 - 0.5, 1e-15);
}

TEST(Frustum, Constructor_RejectsBadSizesNamingThem) {
  ExpectRejected([] { return dgd::Frustum<double>(-1.5, 1, 1); },
                 "frustum base radius must be finite and >= 0, in metres; got -1.5");
  ExpectRejected([] { return dgd::Frustum<double>(1, -0.5, 1); }, "frustum top radius");
  ExpectRejected([] { return dgd::Frustum<double>(1, 1, std::numeric_limits<double>::quiet_NaN()); }, "frustum height");
  ExpectRejected([] { return dgd::Frustum<float>(1, std::numeric_limits<float>::infinity(), 1); }, "inf");
}

}  // namespace
}  // namespace dgd_test
