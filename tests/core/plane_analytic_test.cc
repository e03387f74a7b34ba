// Answers of the plane known in closed form: separate, touching and overlapping.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dgd/certificate.h"
#include "dgd/growth_distance.h"
#include "dgd/shapes.h"
#include "support/pairs/any_pair.h"
#include "support/scalars.h"

namespace dgd_test {
namespace {

using dgd::Status;
using Eigen::Vector2d;

template <class S>
struct Tolerance {
  static constexpr double kRelative = 2 * double(dgd::kSqrtEpsilon<S>);
  static constexpr double kLength = 64 * double(dgd::kEpsilon<S>);
};

template <class S>
dgd::Pose<S, 2> PoseAt(const Vector2d& translation, double angle = 0) {
  return {Eigen::Rotation2Dd(angle).toRotationMatrix().cast<S>(), translation.cast<S>()};
}

/// A point to turn all about and to move all to, so that nothing is aligned with the world.
const Vector2d kPlace(1.5, -0.75);

template <class S>
class PlaneAnalytic : public ::testing::Test {
 protected:
  using Set = AnySet<S, 2>;

  static constexpr std::array kGrowthDistances = {0.125, 0.5, 1.0, 3.0, 20.0};

  /// Set 2's frame `way` from set 1's, as they stand and turned about together; in both orders; cold, then warm after a
  /// little motion. `normal` is zero where there is more than one.
  template <class Core1, class Core2>
  static void Check(const dgd::RoundedSet<Core1>& set_1, const dgd::RoundedSet<Core2>& set_2, const Vector2d& way,
                    double growth_distance, const Vector2d& normal) {
    const Set any_1 = Erase(set_1), any_2 = Erase(set_2);
    for (const double angle : {0.0, 0.3, 2.0}) {
      const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
      const dgd::Pose<S, 2> pose_1 = PoseAt<S>(kPlace, angle);
      const dgd::Pose<S, 2> pose_2 = PoseAt<S>(kPlace + turn * way, angle);
      SCOPED_TRACE("growth distance " + std::to_string(growth_distance) + ", turned by " + std::to_string(angle));
      CheckInOrder(any_1, pose_1, any_2, pose_2, growth_distance, turn * normal);
      CheckInOrder(any_2, pose_2, any_1, pose_1, growth_distance, -(turn * normal));
    }
  }

 private:
  static void CheckInOrder(const Set& set_1, const dgd::Pose<S, 2>& pose_1, const Set& set_2,
                           const dgd::Pose<S, 2>& pose_2, double growth_distance, const Vector2d& normal) {
    const AnyPair<S, 2> pair(set_1, pose_1, set_2, pose_2);
    dgd::WarmStart<S, 2> warm_start;
    dgd::Pose<S, 2> moved = pose_2;
    moved.translation += dgd::Vector2<S>(S(0.01), S(-0.02));
    (void)AnyPair<S, 2>(set_1, pose_1, set_2, moved).GrowthDistance({}, &warm_start);
    for (dgd::WarmStart<S, 2>* start : {static_cast<dgd::WarmStart<S, 2>*>(nullptr), &warm_start}) {
      SCOPED_TRACE(start == nullptr ? "cold" : "warm");
      const dgd::Result<S, 2> result = pair.GrowthDistance({}, start);
      EXPECT_EQ(result.status, Status::kOptimal);
      EXPECT_NEAR(double(result.lower_bound) / growth_distance, 1, Tolerance<S>::kRelative);
      EXPECT_NEAR(double(result.upper_bound) / growth_distance, 1, Tolerance<S>::kRelative);
      EXPECT_TRUE(
          pair.Certify(result).Holds(Tolerance<S>::kLength * (1 + growth_distance) * 10, Tolerance<S>::kRelative));
      // The gap is of second order in the normal's error on a curved side.
      if (normal.norm() > 0) {
        EXPECT_LE((result.normal.template cast<double>() - normal).norm(), 4 * std::sqrt(Tolerance<S>::kRelative));
      }
      CheckYesNo(pair.DetectCollision({}, start), growth_distance);
    }
  }

  static void CheckYesNo(const dgd::CollisionResult<S, 2>& answer, double growth_distance) {
    if (growth_distance > 1) {
      EXPECT_EQ(answer.status, Status::kSeparated);
      EXPECT_GT(answer.separation, 0);
    } else if (growth_distance < 1) {
      EXPECT_EQ(answer.status, Status::kColliding);
    } else {
      EXPECT_TRUE(answer.status == Status::kSeparated || answer.status == Status::kColliding ||
                  answer.status == Status::kTouching);
    }
  }
};

TYPED_TEST_SUITE(PlaneAnalytic, Scalars);

TYPED_TEST(PlaneAnalytic, Circles_AddTheirRadii) {
  using S = TypeParam;
  for (const double growth_distance : this->kGrowthDistances) {
    for (const Vector2d& normal : {Vector2d(1, 0), Vector2d(0, -1), Vector2d(-0.6, 0.8)}) {
      this->Check(dgd::Circle<S>(S(0.25)), dgd::Circle<S>(S(0.75)), growth_distance * normal, growth_distance, normal);
    }
  }
}

// The larger of the two coordinates' growth distances; the normal is that coordinate's axis.
TYPED_TEST(PlaneAnalytic, AlignedRectangles_MeetInTheLargerCoordinate) {
  using S = TypeParam;
  const dgd::RoundedSet one{dgd::Rectangle<S>({S(0.5), S(1)})}, two{dgd::Rectangle<S>({S(0.25), S(2)})};
  for (const double growth_distance : this->kGrowthDistances) {
    this->Check(one, two, growth_distance * Vector2d(0.75, 1), growth_distance, {1, 0});
    this->Check(one, two, growth_distance * Vector2d(-0.25, -3), growth_distance, {0, -1});
    this->Check(one, two, growth_distance * Vector2d(0, 3), growth_distance, {0, 1});
    this->Check(one, two, growth_distance * Vector2d(0.75, 3), growth_distance, {0, 0});  // Corner to corner.
  }
}

TYPED_TEST(PlaneAnalytic, EllipseAndCircle_MeetAtTheAxes) {
  using S = TypeParam;
  const dgd::RoundedSet ellipse{dgd::Ellipse<S>({S(1.5), S(0.5)})};
  const dgd::RoundedSet circle = dgd::Circle<S>(S(0.25));
  for (const double growth_distance : this->kGrowthDistances) {
    this->Check(ellipse, circle, growth_distance * Vector2d(1.75, 0), growth_distance, {1, 0});
    this->Check(ellipse, circle, growth_distance * Vector2d(0, -0.75), growth_distance, {0, -1});
  }
}

// Ellipses of one shape are circles in stretched coordinates.
TYPED_TEST(PlaneAnalytic, EqualEllipses_AreStretchedCircles) {
  using S = TypeParam;
  const dgd::RoundedSet ellipse{dgd::Ellipse<S>({S(1.5), S(0.5)})};
  for (const double growth_distance : this->kGrowthDistances) {
    const Vector2d way(1.5 * 2 * 0.6, 0.5 * 2 * 0.8);
    this->Check(ellipse, ellipse, growth_distance * way, growth_distance, Vector2d(0.6 / 1.5, 0.8 / 0.5).normalized());
  }
}

// A square on its corner, the unit ball of the 1-norm, against a triangle.
TYPED_TEST(PlaneAnalytic, Polygons_MeetSideToCorner) {
  using S = TypeParam;
  const std::vector<Vector2d> corners{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, triangle{{-1, -1}, {2, -1}, {-1, 2}};
  const dgd::RoundedSet diamond{dgd::Polygon<S>(corners)};
  const dgd::RoundedSet wedge{dgd::Polygon<S>(triangle)};  // Its centroid is its frame's origin.
  const double half_root = std::sqrt(0.5);
  for (const double growth_distance : this->kGrowthDistances) {
    this->Check(diamond, diamond, growth_distance * Vector2d(1.5, 0.5), growth_distance, {half_root, half_root});
    // The wedge's long side, 1 / sqrt(2) from its centre, to a side of the diamond's, as far from its own.
    this->Check(wedge, diamond, growth_distance * Vector2d(0.75, 1.25), growth_distance, {half_root, half_root});
    // Its lower side, 1 from the centre, to the diamond's corner.
    this->Check(wedge, diamond, growth_distance * Vector2d(0.25, -2), growth_distance, {0, -1});
  }
}

// Along y from -0.75 to 0.75, with a radius of 0.25: beside the straight part, and beyond the end.
TYPED_TEST(PlaneAnalytic, Stadium_HasSidesAndEnds) {
  using S = TypeParam;
  const dgd::RoundedSet stadium = dgd::Stadium<S>(S(0.25), S(0.75));
  for (const double growth_distance : this->kGrowthDistances) {
    this->Check(stadium, stadium, growth_distance * Vector2d(0.5, 0.5), growth_distance, {1, 0});
    this->Check(stadium, dgd::Circle<S>(S(0.5)), growth_distance * Vector2d(-0.75, 0.25), growth_distance, {-1, 0});
    this->Check(stadium, stadium, growth_distance * (Vector2d(0, 1.5) + 0.5 * Vector2d(0.6, 0.8)), growth_distance,
                {0.6, 0.8});
    const dgd::RoundedSet rectangle{dgd::Rectangle<S>({S(1), S(0.5)})};
    this->Check(stadium, rectangle, growth_distance * Vector2d(0.5, 1.5), growth_distance, {0, 1});
  }
}

TYPED_TEST(PlaneAnalytic, RoundedRectangles_MeetAtRoundedCorners) {
  using S = TypeParam;
  const dgd::RoundedSet rectangle{dgd::Rectangle<S>({S(0.5), S(1)}), S(0.25)};
  const Vector2d normal(0.6, -0.8);
  for (const double growth_distance : this->kGrowthDistances) {
    this->Check(rectangle, rectangle, growth_distance * (Vector2d(1, -2) + 0.5 * normal), growth_distance, normal);
    this->Check(rectangle, rectangle, growth_distance * Vector2d(1.5, 0.5), growth_distance, {1, 0});
  }
}

TYPED_TEST(PlaneAnalytic, CoincidentCenters_GiveZeroAndSomeNormal) {
  using S = TypeParam;
  const auto rectangle = Erase(dgd::RoundedSet{dgd::Rectangle<S>({S(0.5), S(1)})});
  const auto circle = Erase(dgd::Circle<S>(S(0.25)));
  const dgd::Pose<S, 2> pose = PoseAt<S>(kPlace, 0.3);
  const dgd::Result<S, 2> result = AnyPair<S, 2>(rectangle, pose, circle, pose).GrowthDistance();
  EXPECT_EQ(result.status, Status::kCoincidentCenters);
  EXPECT_EQ(result.lower_bound, 0);
  EXPECT_EQ(result.upper_bound, 0);
  EXPECT_NEAR(double(result.normal.norm()), 1, 4 * double(dgd::kEpsilon<S>));
  EXPECT_LE(double(result.separation), -0.75 + Tolerance<S>::kLength);
  EXPECT_EQ(result.witness_1, pose.translation);
  EXPECT_EQ((AnyPair<S, 2>(rectangle, pose, rectangle, pose).DetectCollision().status), Status::kColliding);
}

TYPED_TEST(PlaneAnalytic, FlatSets_HaveNoGrowthDistance) {
  using S = TypeParam;
  const auto segment = Erase(dgd::RoundedSet{dgd::Segment<S, 2>(S(1))});
  const auto point = Erase(dgd::RoundedSet{dgd::Point<S, 2>()});
  const dgd::Pose<S, 2> pose_1 = PoseAt<S>(kPlace), pose_2 = PoseAt<S>(kPlace + Vector2d(1, 0.5));
  const AnyPair<S, 2> with_point(segment, pose_1, point, pose_2), with_segment(segment, pose_1, segment, pose_2);
  for (const dgd::Result<S, 2>& result : {with_point.GrowthDistance(), with_segment.GrowthDistance()}) {
    EXPECT_EQ(result.status, Status::kNoInterior);
    EXPECT_EQ(result.lower_bound, 0);
    EXPECT_EQ(result.upper_bound, std::numeric_limits<S>::infinity());
    EXPECT_EQ(result.normal.norm(), 1);
  }
  EXPECT_EQ(with_point.DetectCollision().status, Status::kNoInterior);
}

TYPED_TEST(PlaneAnalytic, SeparationLimit_EndsTheQuery) {
  using S = TypeParam;
  const auto circle = Erase(dgd::Circle<S>(S(0.5)));
  const dgd::Pose<S, 2> pose_1 = PoseAt<S>(kPlace), pose_2 = PoseAt<S>(kPlace + Vector2d(3, 0));
  const AnyPair<S, 2> pair(circle, pose_1, circle, pose_2);
  dgd::WarmStart<S, 2> warm_start;
  for (int frame = 0; frame < 2; ++frame) {
    const dgd::Result<S, 2> result = pair.GrowthDistance({.separation_limit = S(1)}, &warm_start);
    EXPECT_EQ(result.status, Status::kSeparated);
    EXPECT_NEAR(double(result.separation), 2, Tolerance<S>::kLength);
  }
}

}  // namespace
}  // namespace dgd_test
