// Gradients of the growth distance and the signed distance: closed forms, and where they are not unique. Random pairs
// against difference quotients are in gradient_random_test.cc.
#include "dgd/gradient.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "dgd/any_set.h"
#include "dgd/shapes.h"
#include "support/pairs/any_pair.h"
#include "support/scalars.h"

namespace dgd_test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

dgd::Pose<double> PoseAt(const Vector3d& translation, double angle = 0, const Vector3d& axis = Vector3d::UnitZ()) {
  return {Eigen::AngleAxisd(angle, axis).toRotationMatrix(), translation};
}

dgd::RoundedSet<dgd::Box<double>> BoxOf(double x, double y, double z) { return {dgd::Box<double>({x, y, z})}; }

// The queries whose results have the gradients are compiled once; the gradients are those of the types.
template <class Set1, class Set2, class S, int L>
dgd::Result<S, L> Growth(const Set1& set_1, const dgd::Pose<S, L>& pose_1, const Set2& set_2,
                         const dgd::Pose<S, L>& pose_2, const dgd::Settings<S>& settings = {}) {
  return AnyPair<S, L>(Erase(set_1), pose_1, Erase(set_2), pose_2).GrowthDistance(settings);
}
template <class Set1, class Set2>
dgd::SignedDistanceResult<double> Distance(const Set1& set_1, const dgd::Pose<double>& pose_1, const Set2& set_2,
                                           const dgd::Pose<double>& pose_2, const dgd::Result<double>& growth) {
  return AnyPair<double, 3>(Erase(set_1), pose_1, Erase(set_2), pose_2).SignedDistance(growth);
}

template <class Set1, class Set2, int L>
dgd::Gradient<double, L> GradientOf(const Set1& set_1, const dgd::Pose<double, L>& pose_1, const Set2& set_2,
                                    const dgd::Pose<double, L>& pose_2) {
  const auto result = Growth(set_1, pose_1, set_2, pose_2, dgd::Settings<double>{.relative_tolerance = 1e-14});
  return dgd::GrowthDistanceGradient(set_1, pose_1, set_2, pose_2, result);
}

template <class Set1, class Set2>
dgd::Gradient<double> SignedGradientOf(const Set1& set_1, const dgd::Pose<double>& pose_1, const Set2& set_2,
                                       const dgd::Pose<double>& pose_2) {
  const auto result = Distance(set_1, pose_1, set_2, pose_2, Growth(set_1, pose_1, set_2, pose_2));
  return dgd::SignedDistanceGradient(set_1, pose_1, set_2, pose_2, result);
}

template <int L>
bool IsZero(const dgd::Gradient<double, L>& gradient) {
  return gradient.pose_1.linear.isZero(0) && gradient.pose_1.angular.isZero(0) && gradient.pose_2.linear.isZero(0) &&
         gradient.pose_2.angular.isZero(0) && !gradient.is_normal_unique && !gradient.is_contact_unique;
}

template <class S>
class GradientOfScalar : public ::testing::Test {};
TYPED_TEST_SUITE(GradientOfScalar, Scalars);

// s = |d| / (r_1 + r_2): the force along d, through both centres.
TYPED_TEST(GradientOfScalar, Balls_HaveTheClosedForm) {
  using S = TypeParam;
  const auto ball_1 = dgd::Sphere(S(0.5)), ball_2 = dgd::Sphere(S(1.5));
  dgd::Pose<S> pose_1, pose_2;
  pose_1.translation = {1, 2, 3};
  pose_2.translation = {3, 5, 9};
  const auto result = Growth(ball_1, pose_1, ball_2, pose_2);
  const auto gradient = dgd::GrowthDistanceGradient(ball_1, pose_1, ball_2, pose_2, result);
  EXPECT_EQ(gradient.status, dgd::Status::kOptimal);
  EXPECT_TRUE(gradient.is_normal_unique);
  EXPECT_TRUE(gradient.is_contact_unique);
  const dgd::Vector3<S> expected = dgd::Vector3<S>(2, 3, 6) / 7 / 2;
  const S tolerance = 64 * dgd::kEpsilon<S>;
  EXPECT_LE((gradient.pose_2.linear - expected).norm(), tolerance);
  EXPECT_LE((gradient.pose_1.linear + expected).norm(), tolerance);
  EXPECT_LE(gradient.pose_1.angular.norm(), tolerance);
  EXPECT_LE(gradient.pose_2.angular.norm(), tolerance);
}

TEST(Gradient, CirclesInThePlane_HaveTheClosedForm) {
  const dgd::Pose<double, 2> pose_1;
  dgd::Pose<double, 2> pose_2;
  pose_2.translation = {3, 4};
  const dgd::Gradient<double, 2> gradient = GradientOf(dgd::Circle(0.5), pose_1, dgd::Circle(2.0), pose_2);
  EXPECT_TRUE(gradient.IsUnique());
  EXPECT_LE((gradient.pose_2.linear - Vector2d(3, 4) / 12.5).norm(), 1e-14);
  EXPECT_LE(std::abs(gradient.pose_2.angular[0]) + std::abs(gradient.pose_1.angular[0]), 1e-14);
}

// A corner of a square turned by 45 degrees, c = sqrt(2) from its centre, above a long bar's upper side: its height as
// it turns by a is c cos(a), so that s = d / (1 + c cos(a)) has no slope there; turned by b more, it has.
TEST(Gradient, TurnedSquareInThePlane_HasTheClosedForm) {
  const dgd::RoundedSet bar{dgd::Rectangle<double>({10, 1})}, square{dgd::Rectangle<double>({1, 1})};
  const double turn = 0.1, corner = std::numbers::sqrt2;
  const dgd::Pose<double, 2> pose_1;
  dgd::Pose<double, 2> pose_2;
  pose_2.translation = {0.5, 4};
  pose_2.rotation = Eigen::Rotation2Dd(std::numbers::pi / 4 + turn).toRotationMatrix();
  const dgd::Gradient<double, 2> gradient = GradientOf(bar, pose_1, square, pose_2);
  EXPECT_TRUE(gradient.IsUnique());
  const double height = 1 + corner * std::cos(turn);
  EXPECT_LE((gradient.pose_2.linear - Vector2d(0, 1 / height)).norm(), 1e-14);
  EXPECT_NEAR(gradient.pose_2.angular[0], 4 / (height * height) * corner * std::sin(turn), 1e-14);
}

// A force and its opposite at one point: no rigid motion of the pair does any work.
TEST(Gradient, MovingBothSetsTogether_ChangesNothing) {
  const auto box = BoxOf(1, 2, 3);
  const dgd::RoundedSet cone{dgd::Cone<double>(0.5, 2), 0.1};
  const dgd::Pose<double> pose_1 = PoseAt({5, 1, -2}, 0.4, Vector3d(1, 2, 3).normalized());
  const dgd::Pose<double> pose_2 = PoseAt({8, -1, 2}, 2.1, Vector3d(3, -1, 2).normalized());
  const Vector3d velocity(1, -2, 0.5), angular_velocity(0.3, 0.7, -1.1);
  for (const auto& gradient : {GradientOf(box, pose_1, cone, pose_2), SignedGradientOf(box, pose_1, cone, pose_2)}) {
    EXPECT_TRUE(gradient.IsUnique());
    EXPECT_GT(gradient.pose_1.angular.norm(), 0.1);
    const double rate = gradient.pose_1.Rate(velocity + angular_velocity.cross(pose_1.translation), angular_velocity) +
                        gradient.pose_2.Rate(velocity + angular_velocity.cross(pose_2.translation), angular_velocity);
    EXPECT_NEAR(rate, 0, 1e-12);
  }
}

TEST(Gradient, FaceOnFace_HasManyContactPoints) {
  const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), BoxOf(0.5, 0.5, 0.5), PoseAt({0.2, 0.1, 3}));
  EXPECT_TRUE(gradient.is_normal_unique);
  EXPECT_FALSE(gradient.is_contact_unique);
  EXPECT_LE((gradient.pose_2.linear - Vector3d(0, 0, 1 / 1.5)).norm(), 1e-14);
}

TEST(Gradient, CornerOnFace_IsUnique) {
  const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), BoxOf(0.5, 0.5, 0.5),
                                   PoseAt({0.2, 0.1, 3}, 0.5, Vector3d(2, 1, 0).normalized()));
  EXPECT_TRUE(gradient.IsUnique());
}

TEST(Gradient, EdgeAlongFace_HasManyContactPoints) {
  const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), BoxOf(0.5, 0.5, 0.5),
                                   PoseAt({0.2, 0.1, 3}, 0.5, Vector3d::UnitX()));
  EXPECT_TRUE(gradient.is_normal_unique);
  EXPECT_FALSE(gradient.is_contact_unique);
}

// The Minkowski difference is a box whose corners are at (+-1.5, +-1.5, +-1.5).
TEST(Gradient, RayThroughAnEdgeOrACorner_HasManyNormals) {
  for (const Vector3d& between : {Vector3d(3, 3, 0.4), Vector3d(3, 3, 3)}) {
    const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), BoxOf(0.5, 0.5, 0.5), PoseAt(between));
    EXPECT_FALSE(gradient.is_normal_unique) << between.transpose();
  }
}

TEST(Gradient, RayByAnEdge_HasOneNormal) {
  const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), BoxOf(0.5, 0.5, 0.5), PoseAt({3, 3.001, 0.4}));
  EXPECT_TRUE(gradient.is_normal_unique);
  EXPECT_LE((gradient.pose_2.linear - Vector3d(0, 1 / 1.5, 0)).norm(), 1e-14);
}

TEST(Gradient, RayThroughARoundedCorner_IsUnique) {
  const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), dgd::Sphere(0.5), PoseAt({3, 3, 3}));
  EXPECT_TRUE(gradient.IsUnique());
  const double height = std::numbers::sqrt3 + 0.5;
  EXPECT_LE((gradient.pose_2.linear - Vector3d(1, 1, 1).normalized() / height).norm(), 1e-12);
}

TEST(Gradient, RayThroughAnApex_HasManyNormals) {
  const dgd::RoundedSet cone{dgd::Cone<double>(0.5, 2)};
  const dgd::RoundedSet point{dgd::Point<double>()};
  EXPECT_FALSE(GradientOf(cone, PoseAt({0, 0, 0}), point, PoseAt({0, 0, 4})).is_normal_unique);
  const auto on_face = GradientOf(cone, PoseAt({0, 0, 0}), BoxOf(2, 2, 1), PoseAt({0.3, 0, 4}));
  EXPECT_TRUE(on_face.IsUnique());
  EXPECT_LE((on_face.pose_2.linear - Vector3d(0, 0, 1 / 2.5)).norm(), 1e-12);
}

TEST(Gradient, RayThroughACornerInThePlane_HasManyNormals) {
  const dgd::RoundedSet square{dgd::Rectangle<double>({1, 1})};
  const dgd::RoundedSet point{dgd::Point<double, 2>()};
  const dgd::Pose<double, 2> pose_1;
  dgd::Pose<double, 2> pose_2;
  pose_2.translation = {2, 2};
  EXPECT_FALSE(GradientOf(square, pose_1, point, pose_2).is_normal_unique);
  pose_2.translation = {2, 1.9};
  EXPECT_TRUE(GradientOf(square, pose_1, point, pose_2).IsUnique());
  const auto side_on_side = GradientOf(square, pose_1, square, pose_2);
  EXPECT_TRUE(side_on_side.is_normal_unique);
  EXPECT_FALSE(side_on_side.is_contact_unique);
}

TEST(Gradient, ParallelAndCrossedCapsules_DifferInTheirContact) {
  const auto capsule = dgd::Capsule(0.2, 1.0);
  const auto parallel = GradientOf(capsule, PoseAt({0, 0, 0}), capsule, PoseAt({0.9, 0, 0.3}));
  EXPECT_TRUE(parallel.is_normal_unique);
  EXPECT_FALSE(parallel.is_contact_unique);
  const auto crossed =
      GradientOf(capsule, PoseAt({0, 0, 0}), capsule, PoseAt({0.9, 0.1, 0.3}, 1e-3, Vector3d::UnitX()));
  EXPECT_TRUE(crossed.IsUnique());
}

TEST(Gradient, StandingAndLyingCylinders_HaveManyContactPoints) {
  const dgd::RoundedSet cylinder{dgd::Cylinder<double>(0.5, 1)};
  const auto box = BoxOf(3, 3, 1);
  const double quarter = std::numbers::pi / 2;
  const auto standing = GradientOf(box, PoseAt({0, 0, 0}), cylinder, PoseAt({0.2, 0.1, 3}));
  EXPECT_TRUE(standing.is_normal_unique);
  EXPECT_FALSE(standing.is_contact_unique);
  const auto lying = GradientOf(box, PoseAt({0, 0, 0}), cylinder, PoseAt({0.2, 0.1, 3}, quarter, Vector3d::UnitX()));
  EXPECT_TRUE(lying.is_normal_unique);
  EXPECT_FALSE(lying.is_contact_unique);
  const auto tilted = GradientOf(box, PoseAt({0, 0, 0}), cylinder, PoseAt({0.2, 0.1, 3}, 0.3, Vector3d::UnitX()));
  EXPECT_TRUE(tilted.IsUnique());
  EXPECT_LE((tilted.pose_2.linear - Vector3d(0, 0, 1 / (1 + std::cos(0.3) + 0.5 * std::sin(0.3)))).norm(), 1e-12);
}

// Its radius of curvature is 20 semi-axes where it lies on the face: a curve, not a face.
TEST(Gradient, LargeEllipsoid_IsNotTakenForAFace) {
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({1, 1, 0.05})};
  const auto gradient = GradientOf(BoxOf(2, 2, 1), PoseAt({0, 0, 0}), ellipsoid, PoseAt({0.1, 0.2, 2}));
  EXPECT_TRUE(gradient.IsUnique());
  EXPECT_LE((gradient.pose_2.linear - Vector3d(0, 0, 1 / 1.05)).norm(), 1e-12);
}

// For translations the growth distance is convex, and each of its subgradients supports it.
TEST(Gradient, AtACorner_IsASubgradient) {
  const auto box_1 = BoxOf(1, 1, 1), box_2 = BoxOf(0.5, 0.5, 0.5);
  const Vector3d place(3, 3, 3);
  const auto at = [&](const Vector3d& offset) {
    return Growth(box_1, PoseAt({0, 0, 0}), box_2, PoseAt(place + offset)).GrowthDistance();
  };
  const auto gradient = GradientOf(box_1, PoseAt({0, 0, 0}), box_2, PoseAt(place));
  int above = 0;
  for (const double x : {-0.5, 0.0, 0.5}) {
    for (const double y : {-0.5, 0.0, 0.5}) {
      for (const double z : {-0.5, 0.0, 0.5}) {
        const double linear = at(Vector3d::Zero()) + gradient.pose_2.linear.dot(Vector3d(x, y, z));
        EXPECT_GE(at({x, y, z}), linear - 1e-12);
        above += at({x, y, z}) > linear + 0.01;
      }
    }
  }
  EXPECT_GE(above, 5) << "at a corner no plane touches all around";
}

TEST(Gradient, CoincidentCenters_IsASubgradient) {
  const auto gradient = GradientOf(BoxOf(1, 1, 1), PoseAt({1, 2, 3}), dgd::Sphere(0.5), PoseAt({1, 2, 3}));
  EXPECT_EQ(gradient.status, dgd::Status::kCoincidentCenters);
  EXPECT_FALSE(gradient.is_normal_unique);
  EXPECT_GT(gradient.pose_2.linear.norm(), 0);
  // s >= <gradient, d> for all d: here for those along the axes, where s is |d| / 1.5.
  EXPECT_LE(gradient.pose_2.linear.cwiseAbs().maxCoeff(), 1 / 1.5 + 1e-12);
}

TEST(Gradient, UnfinishedAndStoppedQueries_HaveADefinedGradient) {
  const dgd::RoundedSet ellipsoid{dgd::Ellipsoid<double>({1, 2, 0.5})};
  const dgd::RoundedSet cone{dgd::Cone<double>(0.5, 2)};
  const dgd::Pose<double> pose_1, pose_2 = PoseAt({3, 2, 1});
  const auto first = Growth(ellipsoid, pose_1, cone, pose_2, dgd::Settings<double>{.max_iterations = 1});
  ASSERT_EQ(first.status, dgd::Status::kIterationLimit);
  const auto unfinished = dgd::GrowthDistanceGradient(ellipsoid, pose_1, cone, pose_2, first);
  EXPECT_EQ(unfinished.status, dgd::Status::kIterationLimit);
  EXPECT_TRUE(unfinished.pose_2.linear.allFinite() && unfinished.pose_2.angular.allFinite());

  const auto apart = Growth(ellipsoid, pose_1, cone, pose_2, dgd::Settings<double>{.separation_limit = 0.1});
  ASSERT_EQ(apart.status, dgd::Status::kSeparated);
  const auto stopped = dgd::GrowthDistanceGradient(ellipsoid, pose_1, cone, pose_2, apart);
  EXPECT_EQ(stopped.status, dgd::Status::kSeparated);
  EXPECT_TRUE(IsZero(stopped));

  const dgd::RoundedSet point{dgd::Point<double>()};
  const auto nothing = Growth(point, pose_1, point, pose_2);
  ASSERT_EQ(nothing.status, dgd::Status::kNoInterior);
  const auto of_nothing = dgd::GrowthDistanceGradient(point, pose_1, point, pose_2, nothing);
  EXPECT_EQ(of_nothing.status, dgd::Status::kNoInterior);
  EXPECT_TRUE(IsZero(of_nothing));
}

TEST(Gradient, NanAndInfinity_AreInvalidInput) {
  const auto box = BoxOf(1, 1, 1);
  const auto ball = dgd::Sphere(0.5);
  const dgd::Pose<double> pose_1, pose_2 = PoseAt({3, 2, 1});
  const auto growth = Growth(box, pose_1, ball, pose_2);
  const auto distance = Distance(box, pose_1, ball, pose_2, growth);
  const auto expect_invalid = [&](const auto& ball_too, const dgd::Pose<double>& pose_too,
                                  const dgd::Result<double>& growth_too,
                                  const dgd::SignedDistanceResult<double>& distance_too) {
    for (const auto& gradient : {dgd::GrowthDistanceGradient(box, pose_1, ball_too, pose_too, growth_too),
                                 dgd::SignedDistanceGradient(box, pose_1, ball_too, pose_too, distance_too)}) {
      EXPECT_EQ(gradient.status, dgd::Status::kInvalidInput);
      EXPECT_TRUE(IsZero(gradient));
    }
  };
  EXPECT_EQ(dgd::GrowthDistanceGradient(box, pose_1, ball, pose_2, growth).status, dgd::Status::kOptimal);
  EXPECT_EQ(dgd::SignedDistanceGradient(box, pose_1, ball, pose_2, distance).status, dgd::Status::kOptimal);
  for (const double bad : {kNan, kInfinity}) {
    auto bad_pose = pose_2;
    bad_pose.translation.y() = bad;
    expect_invalid(ball, bad_pose, growth, distance);
    bad_pose = pose_2;
    bad_pose.rotation(1, 2) = bad;
    expect_invalid(ball, bad_pose, growth, distance);
    auto bad_ball = ball;
    bad_ball.radius = bad;
    expect_invalid(bad_ball, pose_2, growth, distance);
    for (const double normal : {bad, 2.0}) {
      auto bad_growth = growth;
      auto bad_distance = distance;
      bad_growth.normal.z() = bad_distance.normal.z() = normal;
      expect_invalid(ball, pose_2, bad_growth, bad_distance);
    }
    auto bad_growth = growth;
    auto bad_distance = distance;
    bad_growth.witness_1.x() = bad_distance.witness_2.x() = bad;
    expect_invalid(ball, pose_2, bad_growth, bad_distance);
  }
  expect_invalid(ball, pose_2, {}, {});
}

TEST(Gradient, AnySet_HasThatOfItsShape) {
  const dgd::RoundedSet cylinder{dgd::Cylinder<double>(0.5, 1), 0.1};
  const auto box = BoxOf(1, 2, 3);
  const dgd::AnySet any_cylinder = cylinder, any_box = box;
  const dgd::Pose<double> pose_1 = PoseAt({1, 0, 0}, 0.3, Vector3d::UnitX()), pose_2 = PoseAt({4, 1, 2}, 1, {0, 1, 0});
  const dgd::Result<double> growth = dgd::GrowthDistance(any_cylinder, pose_1, any_box, pose_2);
  const auto distance = dgd::SignedDistance(any_cylinder, pose_1, any_box, pose_2, growth);
  const auto expect_same = [](const dgd::Gradient<double>& any, const dgd::Gradient<double>& known) {
    EXPECT_EQ(any.status, dgd::Status::kOptimal);
    EXPECT_EQ(any.pose_1.angular, known.pose_1.angular);
    EXPECT_EQ(any.pose_2.linear, known.pose_2.linear);
    EXPECT_EQ(any.is_normal_unique, known.is_normal_unique);
    EXPECT_EQ(any.is_contact_unique, known.is_contact_unique);
    EXPECT_GT(any.pose_1.angular.norm(), 0);
  };
  expect_same(dgd::GrowthDistanceGradient(any_cylinder, pose_1, any_box, pose_2, growth),
              dgd::GrowthDistanceGradient(cylinder, pose_1, box, pose_2, growth));
  expect_same(dgd::SignedDistanceGradient(any_cylinder, pose_1, any_box, pose_2, distance),
              dgd::SignedDistanceGradient(cylinder, pose_1, box, pose_2, distance));
}

// A ball above a bar that turns about its own origin, 2 m from it: its surface rises by 2 m per radian there.
TEST(SignedDistanceGradient, BallAboveABar_HasTheClosedForm) {
  const auto gradient = SignedGradientOf(BoxOf(5, 1, 1), PoseAt({0, 0, 0}), dgd::Sphere(0.5), PoseAt({2, 0.1, 4}));
  EXPECT_EQ(gradient.status, dgd::Status::kOptimal);
  EXPECT_TRUE(gradient.IsUnique());
  EXPECT_LE((gradient.pose_2.linear - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LE((gradient.pose_1.linear + Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LE((gradient.pose_1.angular - Vector3d(-0.1, 2, 0)).norm(), 1e-12);
  EXPECT_LE(gradient.pose_2.angular.norm(), 1e-12);
}

TEST(SignedDistanceGradient, FaceOnFaceAndOverlappingCores_AreNotUnique) {
  const auto face = SignedGradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), BoxOf(1, 1, 1), PoseAt({0.2, 0.1, 3}));
  EXPECT_TRUE(face.is_normal_unique);
  EXPECT_FALSE(face.is_contact_unique);
  const auto overlap = SignedGradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), dgd::Sphere(0.5), PoseAt({0.9, 0.1, 0.2}));
  EXPECT_FALSE(overlap.is_normal_unique);
  EXPECT_LE((overlap.pose_2.linear - Vector3d::UnitX()).norm(), 1e-12);
  // Within the radius alone, the cores are apart, and their nearest points are unique.
  const auto shallow = SignedGradientOf(BoxOf(1, 1, 1), PoseAt({0, 0, 0}), dgd::Sphere(0.5), PoseAt({1.2, 0.1, 0.2}));
  EXPECT_TRUE(shallow.IsUnique());
}

// Its bounds are too far apart to say where the optimum is.
TEST(SignedDistanceGradient, UnfinishedResult_IsNotUnique) {
  const auto box = BoxOf(1, 1, 1);
  const auto ball = dgd::Sphere(0.5);
  const auto pose_2 = PoseAt({2, 0.1, 0.2});
  auto result = Distance(box, dgd::Pose<double>(), ball, pose_2, Growth(box, dgd::Pose<double>(), ball, pose_2));
  EXPECT_TRUE(dgd::SignedDistanceGradient(box, {}, ball, pose_2, result).IsUnique());
  result.status = dgd::Status::kIterationLimit;
  result.upper_bound = result.separation + 0.001;
  const auto gradient = dgd::SignedDistanceGradient(box, {}, ball, pose_2, result);
  EXPECT_EQ(gradient.status, dgd::Status::kIterationLimit);
  EXPECT_FALSE(gradient.is_normal_unique);
  EXPECT_EQ(gradient.pose_2.linear, result.normal);
}

}  // namespace
}  // namespace dgd_test
