// Every way a query ends, and that it then leaves no field unset.
#include <gtest/gtest.h>

#include "dgd/shapes.h"
#include "support/checks.h"
#include "support/random_sets.h"
#include "support/scalars.h"
#include "support/sets/transformed.h"

namespace dgd_test {
namespace {

using dgd::Status;
using Eigen::Vector3d;

template <class S>
class GrowthDistanceStatus : public ::testing::Test {
 protected:
  using Scalar = S;

  /// What a result holds when there is nothing to report.
  static void ExpectNoAnswer(const dgd::Result<S>& result, Status status) {
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(result.lower_bound, 0);
    EXPECT_EQ(result.upper_bound, std::numeric_limits<S>::infinity());
    EXPECT_EQ(result.normal.norm(), 1);
    EXPECT_EQ(result.separation, 0);
    EXPECT_TRUE(result.witness_1.allFinite());
    EXPECT_TRUE(result.witness_2.allFinite());
    EXPECT_EQ(result.iterations, 0);
  }
  static void ExpectNoAnswer(const dgd::CollisionResult<S>& result, Status status) {
    EXPECT_EQ(result.status, status);
    EXPECT_EQ(result.normal.norm(), 1);
    EXPECT_EQ(result.separation, 0);
    EXPECT_TRUE(result.point.allFinite());
    EXPECT_EQ(result.iterations, 0);
  }

  static ReferencePair TwoOf(CoreType type, double distance, double radius = 0) {
    Random random(5);
    ReferencePair pair;
    pair.set_1 = pair.set_2 = RandomSet(random, type, false);
    pair.set_1.radius = pair.set_2.radius = radius;
    pair.pose_1.rotation = pair.pose_2.rotation = random.Rotation();
    pair.pose_1.translation = Vector3d(1, 2, 3);
    pair.pose_2.translation = Vector3d(1, 2 + distance, 3);
    return pair;
  }
};

TYPED_TEST_SUITE(GrowthDistanceStatus, Scalars);

TYPED_TEST(GrowthDistanceStatus, Separated_ByMoreThanTheLimit) {
  using S = TypeParam;
  Random random(TestSeed());
  int separated = 0;
  const int pairs = TestCount(5000, 300);
  for (int i = 0; i < pairs; ++i) {
    const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
    const ReferencePair reference = RandomPair(random, type_1, random.Flip(), type_2, random.Flip());
    const SolverPair<S> pair(reference);
    const S limit = static_cast<S>(random.Flip() ? 0 : random.LogUniform(1e-3, 1) * reference.Extent());
    const dgd::Result<S> result = pair.GrowthDistance({.separation_limit = limit});
    if (result.status != Status::kSeparated) {
      EXPECT_TRUE(IsCertified<S>(reference, pair, result));
      EXPECT_LE(result.separation, limit);
      continue;
    }
    ++separated;
    ASSERT_TRUE(IsFiniteAndOrdered(result)) << reference.Dump();
    ASSERT_GT(result.separation, limit);
    ASSERT_NEAR(reference.SeparationAlong(result.normal.template cast<double>()), double(result.separation),
                Bounds<S>::SeparationError(pair, reference.Extent()));
    const dgd::Certificate certificate = pair.Certify(result);
    ASSERT_LE(certificate.primal_infeasibility,
              Bounds<S>::Infeasibility(pair, reference.Extent(), double(result.upper_bound)))
        << reference.Dump();
    ASSERT_NEAR(certificate.proven_lower_bound / double(result.lower_bound), 1,
                Bounds<S>::Gap(pair, reference.Extent()));
    ASSERT_GT(result.lower_bound, 1);
  }
  EXPECT_GE(separated, 0.2 * pairs);
}

// A cylinder of 5 m whose own origin is 840 000 km away, beside a box of 13 m: in float its points are 64 m apart.
// fuzz_solver found it, with a growth distance that was off by its half.
TYPED_TEST(GrowthDistanceStatus, InteriorBelowRounding_OfAFarOrigin) {
  using S = TypeParam;
  using Vector = dgd::Vector3<S>;
  const S far = S(60) / dgd::kEpsilon<S>;
  const auto box = Erase(dgd::RoundedSet{dgd::Box<S>(Vector(4, 6, 4))});
  const auto ask = [&](S offset) {
    const dgd::RoundedSet cylinder{Transformed(
        dgd::Cylinder<S>(S(0.1), S(2.5)), dgd::Matrix3<S>(dgd::Matrix3<S>::Identity()), Vector(4, -offset, -offset))};
    return AnyPair<S, 3>(box, {}, Erase(cylinder), {}).GrowthDistance();
  };
  this->ExpectNoAnswer(ask(far), Status::kNoInterior);
  EXPECT_EQ(ask(far / 1000).status, Status::kOptimal);
}

// The centroid of a triangle is in its plane but for rounding, of which a tiny radius makes no interior: fuzz_solver
// found a triangle of three equal points whose growth distance was 3000 times too small.
TYPED_TEST(GrowthDistanceStatus, InteriorBelowRounding_OfARadius) {
  using S = TypeParam;
  using Vector = dgd::Vector3<S>;
  const Vector corner = Vector::Constant(S(0.313720703125));
  const dgd::Triangle<S> degenerate(corner, corner, corner), oblique(corner, corner + Vector(1, 0, S(0.3)), -corner);
  const dgd::Point<S> point;
  dgd::Pose<S> pose;
  pose.translation = Vector(7, -1, -5);
  for (const dgd::Triangle<S>& triangle : {degenerate, oblique}) {
    const auto ask = [&](S radius) {
      const AnyPair<S, 3> pair(Erase(dgd::RoundedSet{triangle}), {}, Erase(dgd::RoundedSet{point, radius}), pose);
      EXPECT_EQ(pair.DetectCollision().status, Status::kSeparated);
      return pair.GrowthDistance();
    };
    this->ExpectNoAnswer(ask(dgd::kEpsilon<S> / 10000), Status::kNoInterior);
    EXPECT_EQ(ask(S(0.01)).status, Status::kOptimal);
  }
}

TYPED_TEST(GrowthDistanceStatus, CoincidentCenters_GiveZeroAndSomeNormal) {
  using S = TypeParam;
  for (const CoreType type : kCoreTypes) {
    SCOPED_TRACE(Name(type));
    const ReferencePair reference = this->TwoOf(type, 0, 0.25);
    const SolverPair<S> pair(reference);
    dgd::WarmStart<S> warm_start;
    warm_start.normal_1 = dgd::Vector3<S>(0, S(-0.6), S(0.8));
    for (dgd::WarmStart<S>* start : {static_cast<dgd::WarmStart<S>*>(nullptr), &warm_start}) {
      const dgd::Result<S> result = pair.GrowthDistance({}, start);
      EXPECT_EQ(result.status, Status::kCoincidentCenters);
      EXPECT_EQ(result.iterations, 1);
      EXPECT_EQ(result.lower_bound, 0);
      EXPECT_EQ(result.upper_bound, 0);
      EXPECT_EQ(result.witness_1, pair.Center1());
      EXPECT_EQ(result.witness_2, pair.Center2());
      EXPECT_NEAR(double(result.normal.norm()), 1, 4 * dgd::kEpsilon<S>);
      EXPECT_LT(result.separation, 0);
      EXPECT_NEAR(reference.SeparationAlong(result.normal.template cast<double>()), double(result.separation),
                  Bounds<S>::SeparationError(pair, reference.Extent()));
    }
    const dgd::CollisionResult<S> collision = pair.DetectCollision();
    EXPECT_EQ(collision.status, Status::kColliding);
    EXPECT_EQ(collision.point, pair.Center1());
  }
}

// The remembered normal is the one that is used, so that a pair at rest on one centre keeps its normal.
TYPED_TEST(GrowthDistanceStatus, CoincidentCenters_KeepTheLastNormal) {
  using S = TypeParam;
  const ReferencePair apart = this->TwoOf(CoreType::kBox, 0.5), coincident = this->TwoOf(CoreType::kBox, 0);
  dgd::WarmStart<S> warm_start;
  const dgd::Result<S> before = SolverPair<S>(apart).GrowthDistance({}, &warm_start);
  const dgd::Result<S> result = SolverPair<S>(coincident).GrowthDistance({}, &warm_start);
  EXPECT_EQ(result.status, Status::kCoincidentCenters);
  EXPECT_NEAR(std::abs(double(result.normal.dot(before.normal))), 1, 1e-5);
  EXPECT_GT(double(result.normal.dot(before.normal)), 0);
}

TYPED_TEST(GrowthDistanceStatus, IterationLimit_LeavesBoundsThatHoldTheAnswer) {
  using S = TypeParam;
  for (const CoreType type : {CoreType::kCylinder, CoreType::kCone, CoreType::kPolytope}) {
    const SolverPair<S> pair(this->TwoOf(type, 2));
    const dgd::Result<S> optimal = pair.GrowthDistance();
    ASSERT_EQ(optimal.status, Status::kOptimal);
    for (int limit = 1; limit <= 3 && limit < optimal.iterations; ++limit) {
      const dgd::Result<S> result = pair.GrowthDistance({.max_iterations = limit});
      EXPECT_EQ(result.status, Status::kIterationLimit);
      EXPECT_EQ(result.iterations, limit);
      EXPECT_TRUE(IsFiniteAndOrdered(result));
      EXPECT_GT(result.lower_bound, 0);
      EXPECT_LE(result.lower_bound, optimal.upper_bound);
      EXPECT_GE(result.upper_bound, optimal.lower_bound);
      const dgd::CollisionResult<S> collision = pair.DetectCollision({.max_iterations = limit});
      EXPECT_NEAR(double(collision.normal.norm()), 1, 4 * dgd::kEpsilon<S>);
      EXPECT_TRUE(collision.point.allFinite());
    }
  }
}

TYPED_TEST(GrowthDistanceStatus, NoInterior_ForTwoFlatSets) {
  using S = TypeParam;
  const ReferenceSet flat[] = {
      {.type = CoreType::kPoint},
      {.type = CoreType::kSegment, .size = {1, 0, 0}},
      {.type = CoreType::kTriangle, .points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      {.type = CoreType::kBox, .size = {1, 1, 0}},
      {.type = CoreType::kCylinder, .size = {1, 0, 0}},
      {.type = CoreType::kCone, .size = {1, 0, 0}},
      {.type = CoreType::kPolytope, .points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}},
      {.type = CoreType::kPolytope, .points = {{1, 1, 1}}},
  };
  for (const ReferenceSet& set_1 : flat) {
    for (const ReferenceSet& set_2 : flat) {
      for (const double distance : {0.0, 3.0}) {
        const SolverPair<S> pair(ReferencePair{set_1, set_2, {}, {Eigen::Matrix3d::Identity(), {0, distance, 0}}});
        dgd::WarmStart<S> warm_start;
        this->ExpectNoAnswer(pair.GrowthDistance(), Status::kNoInterior);
        this->ExpectNoAnswer(pair.GrowthDistance({}, &warm_start), Status::kNoInterior);
        this->ExpectNoAnswer(pair.DetectCollision({}, &warm_start), Status::kNoInterior);
        EXPECT_EQ(warm_start.size, 0);
      }
    }
  }
}

template <class S>
void SetRadius(AnySet<S, 3>& set, S radius) {
  std::visit([radius](auto& a) { a.radius = radius; }, set);
}

TYPED_TEST(GrowthDistanceStatus, InvalidInput_ForNanAndInfinityAnywhere) {
  using S = TypeParam;
  const S bad_values[] = {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity(),
                          -std::numeric_limits<S>::infinity()};
  for (const CoreType type : kCoreTypes) {
    SCOPED_TRACE(Name(type));
    for (const double radius : {0.0, 0.25}) {
      const SolverPair<S> good(this->TwoOf(type, 2, radius));
      for (const S bad : bad_values) {
        for (int which = 0; which < 26; ++which) {
          SCOPED_TRACE(::testing::Message() << "radius " << radius << ", " << bad << " at " << which);
          SolverPair<S> pair = good;
          dgd::Pose<S>& pose = which < 13 ? pair.pose_1 : pair.pose_2;
          const int entry = which % 13;
          if (entry < 9) pose.rotation(entry / 3, entry % 3) = bad;
          if (entry >= 9 && entry < 12) pose.translation[entry - 9] = bad;
          if (entry == 12) SetRadius(which < 13 ? pair.set_1 : pair.set_2, bad);
          dgd::WarmStart<S> warm_start;
          if (radius > 0) (void)good.GrowthDistance({}, &warm_start);
          const dgd::WarmStart<S> before = warm_start;
          this->ExpectNoAnswer(pair.GrowthDistance(), Status::kInvalidInput);
          this->ExpectNoAnswer(pair.GrowthDistance({}, &warm_start), Status::kInvalidInput);
          this->ExpectNoAnswer(pair.DetectCollision({}, &warm_start), Status::kInvalidInput);
          // What was remembered survives a bad frame.
          EXPECT_EQ(warm_start.normal_1, before.normal_1);
          EXPECT_EQ(warm_start.size, before.size);
        }
      }
    }
  }
}

TYPED_TEST(GrowthDistanceStatus, InvalidInput_ForVerticesBeyondTheScalar) {
  using S = TypeParam;
  if constexpr (sizeof(S) == 4) {
    const std::vector<Vector3d> points = {{1e60, 0, 0}, {-1e60, 0, 0}, {0, 1e60, 0}, {0, 0, 1e60}};
    const SolverPair<S> pair(ReferencePair{{.type = CoreType::kPolytope, .points = points},
                                           {.type = CoreType::kBox, .size = {1, 1, 1}},
                                           {},
                                           {Eigen::Matrix3d::Identity(), {1, 0, 0}}});
    this->ExpectNoAnswer(pair.GrowthDistance(), Status::kInvalidInput);
  }
}

// So far away that the squares of lengths overflow: no answer rather than a wrong one.
TYPED_TEST(GrowthDistanceStatus, InvalidInput_WhereLengthsOverflow) {
  using S = TypeParam;
  const double far = double(std::numeric_limits<S>::max()) * 0.5;
  const ReferenceSet box{.type = CoreType::kBox, .size = {1, 1, 1}};
  const SolverPair<S> pair(ReferencePair{box, box, {}, {Eigen::Matrix3d::Identity(), {far, far, 0}}});
  this->ExpectNoAnswer(pair.GrowthDistance(), Status::kInvalidInput);
}

}  // namespace
}  // namespace dgd_test
