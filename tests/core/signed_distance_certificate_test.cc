// The certificate of a signed distance accepts right answers and notices each way of being wrong.
#include "dgd/signed_distance_certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 1e-10, kPoint = 1e-10;

/// A box of 2 m and a ball of 0.5 m beside it: `place` is where the ball is.
class SignedDistanceCertificateTest : public ::testing::Test {
 protected:
  explicit SignedDistanceCertificateTest(const Vector3d& place = {2, 0.3, 0.2}) : pose_{.translation = place} {
    result_ = dgd::SignedDistance(box_, {}, ball_, pose_, dgd::GrowthDistance(box_, {}, ball_, pose_));
  }

  dgd::SignedDistanceCertificate Certificate() const { return dgd::Certify(box_, {}, ball_, pose_, result_); }
  bool Holds() const { return Certificate().Holds(kLength, kPoint); }

  const dgd::RoundedSet<dgd::Box<double>> box_{dgd::Box<double>({1, 1, 1})};
  const dgd::RoundedSet<dgd::Point<double>> ball_ = dgd::Sphere(0.5);
  const dgd::Pose<double> pose_;
  dgd::SignedDistanceResult<double> result_;
};

class DeepSignedDistanceCertificateTest : public SignedDistanceCertificateTest {
 protected:
  DeepSignedDistanceCertificateTest() : SignedDistanceCertificateTest({0.9, 0.3, 0.2}) {}
};

TEST_F(SignedDistanceCertificateTest, RightAnswer_Holds) {
  EXPECT_NEAR(result_.separation, 0.5, 1e-14);
  EXPECT_TRUE(Holds());
  EXPECT_EQ(Certificate().neighbour_gain, 0);
}

TEST_F(DeepSignedDistanceCertificateTest, RightAnswer_Holds) {
  EXPECT_NEAR(result_.separation, -0.6, 1e-14);
  EXPECT_TRUE(Holds());
}

TEST_F(SignedDistanceCertificateTest, WitnessOutsideItsSet_IsNoticed) {
  result_.witness_1.x() += 0.01;
  EXPECT_NEAR(Certificate().primal_infeasibility, 0.01, 1e-12);
  EXPECT_FALSE(Holds());
}

TEST_F(SignedDistanceCertificateTest, WitnessesThatAreNotAboveEachOther_AreNoticed) {
  result_.witness_1.y() += 0.01;  // Still on the box.
  EXPECT_LE(Certificate().primal_infeasibility, kLength);
  EXPECT_NEAR(Certificate().connection_error, 0.01, 1e-12);
  EXPECT_FALSE(Holds());
}

TEST_F(SignedDistanceCertificateTest, WrongSeparation_IsNoticed) {
  result_.separation += 1e-6;
  EXPECT_NEAR(Certificate().separation_error, 1e-6, 1e-12);
  EXPECT_FALSE(Holds());
}

TEST_F(SignedDistanceCertificateTest, TurnedNormal_IsNoticedByABetterOneNearby) {
  result_.normal = Vector3d(1, 0.03, 0).normalized();
  result_.separation = result_.normal.x() * 1 + result_.normal.y() * (0.3 - 1) - 0.5;
  EXPECT_LE(Certificate().separation_error, kLength);
  EXPECT_GE(Certificate().neighbour_gain, 0.005);
  EXPECT_FALSE(Holds());
}

// Of the box's six faces, each is the best of its neighbourhood.
TEST_F(DeepSignedDistanceCertificateTest, AnotherFace_IsALocalLeastTranslation) {
  result_.normal = Vector3d::UnitY();
  result_.separation = -1.2;
  result_.witness_1 = {0.9, 1, 0.2};
  result_.witness_2 = {0.9, -0.2, 0.2};
  EXPECT_TRUE(Holds());
}

TEST_F(SignedDistanceCertificateTest, NormalNotOfUnitLength_IsNoticed) {
  result_.normal *= 1.01;
  EXPECT_NEAR(Certificate().dual_infeasibility, 0.01, 1e-12);
  EXPECT_FALSE(Holds());
}

TEST_F(SignedDistanceCertificateTest, NanAndInfinity_AreNoticed) {
  const dgd::SignedDistanceResult<double> right = result_;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (Vector3d dgd::SignedDistanceResult<double>::*field :
         {&dgd::SignedDistanceResult<double>::normal, &dgd::SignedDistanceResult<double>::witness_1,
          &dgd::SignedDistanceResult<double>::witness_2}) {
      result_ = right;
      (result_.*field).y() = bad;
      EXPECT_FALSE(Holds());
    }
    result_ = right;
    result_.separation = bad;
    EXPECT_FALSE(Holds());
  }
}

}  // namespace
}  // namespace dgd_test
