// The signed distance of random hulls against an exact oracle that looks at all faces and edges of both: whatever the
// overlap, the least translation is the global one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hull_pair.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes/polytope.h"
#include "dgd/signed_distance.h"

namespace dgd_test {
namespace {

constexpr int kPairs = 300;

/// Hulls about 1 m across; margins and depths in metres.
template <class S>
void ExpectOraclesDistance(double least, double greatest, double margin, double tolerance) {
  dgd_demos::Random random(1, 0);
  double worst = 0, gained = 0;
  for (int i = 0; i < kPairs; ++i) {
    const HullPair pair = DrawHullPair(random, least, greatest, margin);
    const dgd::Polytope<S> core_1(pair.core_1.vertices), core_2(pair.core_2.vertices);
    const dgd::RoundedSet set_1{dgd::CoreReference(core_1), static_cast<S>(margin)};
    const dgd::RoundedSet set_2{dgd::CoreReference(core_2), static_cast<S>(margin)};
    const dgd::Pose<S> pose_1{pair.pose_1.rotation.cast<S>(), pair.pose_1.position.cast<S>()};
    const dgd::Pose<S> pose_2{pair.pose_2.rotation.cast<S>(), pair.pose_2.position.cast<S>()};
    dgd::WarmStart<S> warm_start;
    const dgd::Result<S> growth = dgd::GrowthDistance(set_1, pose_1, set_2, pose_2, {}, &warm_start);
    for (const dgd::WarmStart<S>* start : {&warm_start, static_cast<dgd::WarmStart<S>*>(nullptr)}) {
      const dgd::SignedDistanceResult<S> result = dgd::SignedDistance(set_1, pose_1, set_2, pose_2, growth, start);
      ASSERT_EQ(result.status, dgd::Status::kOptimal) << "pair " << i;
      ASSERT_NEAR(double(result.separation), pair.signed_distance, tolerance) << "pair " << i;
      worst = std::max(worst, NormalError(pair, result.normal.template cast<double>()));
      // Where the two witness points are, both surfaces are: moved by the separation, they coincide.
      ASSERT_LE(double((result.witness_2 - result.witness_1 - result.separation * result.normal).norm()),
                std::sqrt(tolerance));
    }
    gained = std::max(gained, NormalError(pair, growth.normal.template cast<double>()));
  }
  EXPECT_LE(worst, tolerance);
  std::printf("normal off by at most %.1e m; the growth distance's by %.1e m\n", worst, gained);
}

TEST(SignedDistanceOracle, HullsOverlappingByUpToAThird_LeastTranslationIsTheGlobalOne) {
  for (const double margin : {0.0, 0.04}) {
    ExpectOraclesDistance<double>(-1.0 / 3, -0.1, margin, 1e-9);
    ExpectOraclesDistance<double>(-0.1, -1e-4, margin, 1e-9);
    ExpectOraclesDistance<float>(-1.0 / 3, -1e-4, margin, 2e-6);
  }
}

TEST(SignedDistanceOracle, HullsThatTouch_AreAtDistanceZero) {
  for (const double margin : {0.0, 0.04}) {
    ExpectOraclesDistance<double>(-1e-6, 1e-6, margin, 1e-9);
    ExpectOraclesDistance<float>(-1e-6, 1e-6, margin, 2e-6);
  }
}

TEST(SignedDistanceOracle, HullsApart_AreAtTheirDistance) {
  for (const double margin : {0.0, 0.04}) {
    ExpectOraclesDistance<double>(1e-4, 0.3, margin, 1e-9);
    ExpectOraclesDistance<float>(1e-4, 0.3, margin, 2e-6);
  }
}

}  // namespace
}  // namespace dgd_test
