// What is left of a failing case.
#include "soak/shrink.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace dgd_soak {
namespace {

using dgd_test::SetType;

std::int64_t IndexOf(SetType type_1, SetType type_2) {
  for (std::size_t i = 0; i < AllTypePairs().size(); ++i) {
    if (AllTypePairs()[i].type_1 == type_1 && AllTypePairs()[i].type_2 == type_2) return static_cast<std::int64_t>(i);
  }
  throw std::logic_error("no such pair of types");
}

TEST(Shrink, WhatTheFailureDoesNotNeed_IsLeftOut) {
  const SoakCase soak_case = MakeCase(1, IndexOf(SetType::kPolytope, SetType::kPolytope));
  ASSERT_GT(soak_case.pair.set_1.points.size(), 5U);
  int asked = 0;
  const auto fails = [&](const SoakCase& c) {
    ++asked;
    return c.pair.set_1.points.size() >= 5 && !c.motion.empty();
  };
  ASSERT_TRUE(fails(soak_case));
  const SoakCase shrunk = Shrink(soak_case, fails);
  EXPECT_TRUE(fails(shrunk));
  EXPECT_EQ(shrunk.pair.set_1.points.size(), 5U);
  EXPECT_LE(shrunk.pair.set_2.points.size(), 1U);
  EXPECT_EQ(shrunk.motion.size(), 1U);
  EXPECT_EQ(shrunk.pair.set_1.radius, 0);
  EXPECT_TRUE(shrunk.pair.pose_1.rotation.isIdentity(0));
  EXPECT_TRUE(shrunk.pair.pose_2.rotation.isIdentity(0));
  EXPECT_TRUE(shrunk.pair.pose_2.translation.isZero(0));
  EXPECT_EQ(shrunk.growth_distance, 0);
  EXPECT_LT(asked, 1000);
}

TEST(Shrink, NumbersThatTheFailureNeeds_AreRoundedNoFurther) {
  const SoakCase soak_case = MakeCase(1, IndexOf(SetType::kCylinder, SetType::kCone));
  const double length = soak_case.pair.set_1.lengths[0];
  const SoakCase shrunk =
      Shrink(soak_case, [&](const SoakCase& c) { return std::abs(c.pair.set_1.lengths[0] / length - 1) < 1e-2; });
  EXPECT_NE(shrunk.pair.set_1.lengths[0], length);
  EXPECT_NEAR(shrunk.pair.set_1.lengths[0], length, 1e-2 * length);
}

TEST(Shrink, PoseOfSet1_MovesIntoThoseOfSet2) {
  const SoakCase soak_case = MakeCase(3, IndexOf(SetType::kBox, SetType::kBox));
  const auto relative = [](const SoakCase& c) -> Eigen::Vector3d {
    const auto& [set_1, set_2, pose_1, pose_2] = c.pair;
    return pose_1.rotation.transpose() * (pose_2.translation - pose_1.translation);
  };
  const Eigen::Vector3d before = relative(soak_case);
  const SoakCase shrunk = Shrink(soak_case, [&](const SoakCase& c) { return relative(c).isApprox(before, 1e-6); });
  EXPECT_TRUE(shrunk.pair.pose_1.translation.isZero(0));
  EXPECT_TRUE(shrunk.pair.pose_1.rotation.isIdentity(0));
  EXPECT_TRUE(relative(shrunk).isApprox(before, 1e-6));
}

TEST(Shrink, CandidatesThatASetRefuses_DoNotFail) {
  const SoakCase soak_case = MakeCase(1, IndexOf(SetType::kBox, SetType::kPolytope));
  const SoakCase shrunk = Shrink(soak_case, [](const SoakCase& c) -> bool {
    if (c.pair.set_2.points.size() < 4) throw std::invalid_argument("too few");
    return true;
  });
  EXPECT_EQ(shrunk.pair.set_2.points.size(), 4U);
}

}  // namespace
}  // namespace dgd_soak
