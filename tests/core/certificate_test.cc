// The certificate accepts right answers and notices each way of being wrong.
#include "dgd/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dgd/shapes/box.h"
#include "dgd/shapes/ellipsoid.h"
#include "dgd/shapes/point.h"
#include "support/random_sets.h"
#include "support/solver_pair.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 1e-10, kGap = 2e-8;

class CertificateTest : public ::testing::Test {
 protected:
  CertificateTest()
      : pair_(ReferencePair{{.type = CoreType::kBox, .size = {1, 1, 1}},
                            {.type = CoreType::kPoint, .radius = 0.5},
                            {},
                            {Eigen::Matrix3d::Identity(), {3, 0.5, 0}}}),
        result_(pair_.GrowthDistance()) {}

  bool Holds() const { return pair_.Certify(result_).Holds(kLength, kGap); }

  SolverPair<double> pair_;
  dgd::Result<double> result_;
};

TEST_F(CertificateTest, RightAnswer_Holds) {
  const dgd::Certificate certificate = pair_.Certify(result_);
  EXPECT_TRUE(certificate.Holds(kLength, kGap));
  EXPECT_NEAR(certificate.proven_lower_bound, 2, 1e-14);
  EXPECT_NEAR(certificate.relative_gap, 0, 1e-14);
}

TEST_F(CertificateTest, WitnessOutsideItsSet_IsNoticed) {
  result_.witness_1.x() += 0.01;
  EXPECT_FALSE(Holds());
  EXPECT_GE(pair_.Certify(result_).primal_infeasibility, 0.01);
}

TEST_F(CertificateTest, WitnessesThatDoNotMeet_AreNoticed) {
  result_.witness_1.y() += 0.01;  // Still on the box.
  EXPECT_FALSE(Holds());
  EXPECT_NEAR(pair_.Certify(result_).primal_infeasibility, 0.02, 1e-12);
}

TEST_F(CertificateTest, TooSmallAGrowthDistance_IsNoticed) {
  result_.upper_bound *= 0.99;
  EXPECT_FALSE(Holds());
}

TEST_F(CertificateTest, TooLargeAGrowthDistance_IsNoticed) {
  // Feasible: both witnesses drawn in towards their centres.
  result_.upper_bound *= 1.01;
  result_.witness_1 = result_.witness_1 / 1.01;
  result_.witness_2 = Vector3d(3, 0.5, 0) + (result_.witness_2 - Vector3d(3, 0.5, 0)) / 1.01;
  const dgd::Certificate certificate = pair_.Certify(result_);
  EXPECT_NEAR(certificate.primal_infeasibility, 0, 1e-14);
  EXPECT_NEAR(certificate.relative_gap, 0.01, 1e-12);
  EXPECT_FALSE(Holds());
}

TEST_F(CertificateTest, WrongNormals_AreNoticed) {
  const Vector3d right = result_.normal;
  for (const Vector3d& wrong : {Vector3d(-right), Vector3d(0, 1, 0), Vector3d(0, 0, 0), Vector3d(1.01 * right),
                                Vector3d(std::cos(0.01), std::sin(0.01), 0)}) {
    result_.normal = wrong;
    EXPECT_FALSE(Holds()) << wrong.transpose();
  }
}

TEST_F(CertificateTest, WrongSeparation_IsNoticed) {
  result_.separation += 1e-6;
  EXPECT_FALSE(Holds());
}

TEST_F(CertificateTest, NanAndInfinity_AreNoticed) {
  const dgd::Result<double> right = result_;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int axis = 0; axis < 3; ++axis) {
      (result_ = right).normal[axis] = bad;
      EXPECT_FALSE(Holds());
      (result_ = right).witness_1[axis] = bad;
      EXPECT_FALSE(Holds());
      (result_ = right).witness_2[axis] = bad;
      EXPECT_FALSE(Holds());
    }
    (result_ = right).upper_bound = bad;
    EXPECT_FALSE(Holds());
    (result_ = right).separation = bad;
    EXPECT_FALSE(Holds());
  }
}

TEST_F(CertificateTest, DefaultResult_DoesNotHold) {
  result_ = {};
  EXPECT_FALSE(Holds());
}

/// In the plane: two rectangles edge to edge, and a circle at the end of an ellipse.
class PlanarCertificateTest : public ::testing::Test {
 protected:
  using Vector2d = Eigen::Vector2d;

  dgd::Certificate CertifyRectangles() const { return Certify(rectangle_, {}, rectangle_, beside_, of_rectangles_); }
  dgd::Certificate CertifyRound() const { return Certify(circle_, {}, ellipse_, beside_, of_round_); }

  const dgd::RoundedSet<dgd::Box<double, 2>> rectangle_{dgd::Box<double, 2>(Vector2d(1, 0.5)), 0};
  const dgd::RoundedSet<dgd::Point<double, 2>> circle_{dgd::Point<double, 2>(), 0.5};
  const dgd::RoundedSet<dgd::Ellipsoid<double, 2>> ellipse_{dgd::Ellipsoid<double, 2>(Vector2d(1.5, 0.2)), 0};
  const dgd::Pose<double, 2> beside_{dgd::SquareMatrix<double, 2>::Identity(), Vector2d(4, 0)};
  dgd::Result<double, 2> of_rectangles_ = GrowthDistance(rectangle_, {}, rectangle_, beside_);
  dgd::Result<double, 2> of_round_ = GrowthDistance(circle_, {}, ellipse_, beside_);
};

TEST_F(PlanarCertificateTest, RightAnswers_Hold) {
  EXPECT_TRUE(CertifyRectangles().Holds(kLength, kGap));
  EXPECT_NEAR(CertifyRectangles().proven_lower_bound, 2, 1e-14);
  EXPECT_TRUE(CertifyRound().Holds(kLength, kGap));
  EXPECT_NEAR(CertifyRound().proven_lower_bound, 2, 1e-14);
}

TEST_F(PlanarCertificateTest, WitnessOutsideItsSet_IsNoticed) {
  of_rectangles_.witness_1.x() += 0.01;
  EXPECT_GE(CertifyRectangles().primal_infeasibility, 0.01);
  of_round_.witness_2.x() -= 0.01;
  EXPECT_GE(CertifyRound().primal_infeasibility, 0.01);
}

TEST_F(PlanarCertificateTest, TooSmallAGrowthDistance_IsNoticed) {
  of_rectangles_.upper_bound *= 0.99;
  EXPECT_FALSE(CertifyRectangles().Holds(kLength, kGap));
  of_round_.upper_bound *= 0.99;
  EXPECT_FALSE(CertifyRound().Holds(kLength, kGap));
}

TEST_F(PlanarCertificateTest, TurnedNormal_IsNoticed) {
  const Vector2d turned(std::cos(0.01), std::sin(0.01));
  of_rectangles_.normal = turned;
  EXPECT_FALSE(CertifyRectangles().Holds(kLength, kGap));
  of_round_.normal = turned;
  EXPECT_FALSE(CertifyRound().Holds(kLength, kGap));
}

TEST_F(PlanarCertificateTest, WrongSeparation_IsNoticed) {
  of_rectangles_.separation += 1e-6;
  EXPECT_FALSE(CertifyRectangles().Holds(kLength, kGap));
  of_round_.separation += 1e-6;
  EXPECT_FALSE(CertifyRound().Holds(kLength, kGap));
}

}  // namespace
}  // namespace dgd_test
