// Sets of any shape: the same results as those of the templates, regardless of the two shapes and their order.
#include "dgd/any_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "dgd/contact/reference_face.h"
#include "dgd/shapes.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using dgd::AnySet;
using dgd::RoundedSet;
using Vector3 = Eigen::Vector3d;
using Pose = dgd::Pose<double>;

struct NamedSet {
  std::string name;
  AnySet set;
};

class AnySetTest : public ::testing::Test {
 protected:
  /// One of each shape, about 1 m across, with and without a radius.
  std::vector<NamedSet> MakeSets() {
    std::vector<NamedSet> sets;
    for (const double radius : {0.0, 0.05}) {
      const std::string suffix = radius > 0 ? ", rounded" : "";
      const auto add = [&](const char* name, const auto& core) {
        sets.push_back({name + suffix, RoundedSet{core, radius}});
      };
      add("segment", dgd::Segment<double>(0.5));
      add("triangle", dgd::Triangle<double>({0.5, 0, 0}, {-0.4, 0.4, 0.1}, {-0.3, -0.5, 0}));
      add("box", dgd::Box<double>({0.5, 0.3, 0.2}));
      add("hull", dgd::CoreReference<dgd::Polytope<double>>(hull_));
      add("cylinder", dgd::Cylinder<double>(0.3, 0.5));
      add("cone", dgd::Cone<double>(0.4, 0.9));
      add("frustum", dgd::Frustum<double>(0.4, 0.2, 0.7));
      add("ellipsoid", dgd::Ellipsoid<double>({0.5, 0.3, 0.2}));
      add("custom", dgd::CustomCore(ellipsoid_));
    }
    sets.push_back({"sphere", dgd::Sphere(0.4)});
    return sets;
  }

  Pose RandomPose(double reach) { return {random_.Rotation(), reach * random_.InCube()}; }

  Random random_{TestSeed()};

 private:
  dgd::Polytope<double> MakeHull() {
    std::vector<Vector3> points;
    for (int i = 0; i < 16; ++i) points.push_back(0.5 * random_.UnitVector());
    return dgd::Polytope<double>(points);
  }

  const dgd::Polytope<double> hull_ = MakeHull();
  const dgd::Ellipsoid<double> ellipsoid_{{0.5, 0.3, 0.2}};
};

/// What the sets' own support functions say of a normal.
double SeparationAlong(const Vector3& normal, const AnySet& a, const Pose& pose_a, const AnySet& b,
                       const Pose& pose_b) {
  const Vector3 on_a = pose_a * a.CoreSupport(pose_a.rotation.transpose() * normal) + a.Radius() * normal;
  const Vector3 on_b = pose_b * b.CoreSupport(pose_b.rotation.transpose() * -normal) - b.Radius() * normal;
  return normal.dot(on_b - on_a);
}

TEST_F(AnySetTest, AllPairsOfShapes_GiveTheSameInEitherOrder) {
  const std::vector<NamedSet> sets = MakeSets();
  for (const NamedSet& a : sets) {
    for (const NamedSet& b : sets) {
      if (a.set.CoreInradius() + a.set.Radius() + b.set.CoreInradius() + b.set.Radius() == 0) continue;
      SCOPED_TRACE(a.name + ", " + b.name);
      const Pose pose_a = RandomPose(0.4), pose_b = RandomPose(0.8);
      const auto there = dgd::GrowthDistance(a.set, pose_a, b.set, pose_b);
      const auto back = dgd::GrowthDistance(b.set, pose_b, a.set, pose_a);
      ASSERT_EQ(there.status, dgd::Status::kOptimal);
      ASSERT_EQ(back.status, dgd::Status::kOptimal);
      EXPECT_NEAR(there.upper_bound, back.upper_bound, 1e-6 * there.upper_bound);
      EXPECT_NEAR(there.separation, SeparationAlong(there.normal, a.set, pose_a, b.set, pose_b), 1e-12);

      const auto check = dgd::DetectCollision(a.set, pose_a, b.set, pose_b);
      if (std::abs(there.upper_bound - 1) > 1e-5) {
        EXPECT_EQ(check.status == dgd::Status::kSeparated, there.lower_bound > 1);
        EXPECT_EQ(check.status == dgd::Status::kColliding, there.upper_bound < 1);
      }
      const auto distance = dgd::SignedDistance(a.set, pose_a, b.set, pose_b, there);
      EXPECT_GE(distance.separation, there.separation - 1e-9);
      EXPECT_NEAR(distance.separation, SeparationAlong(distance.normal, a.set, pose_a, b.set, pose_b), 1e-9);
    }
  }
}

// The templates, compiled for the very types here, take the same steps.
TEST_F(AnySetTest, BoxesAndCylinders_GiveWhatTheTemplatesGive) {
  const RoundedSet box{dgd::Box<double>({0.5, 0.3, 0.2}), 0.01};
  const RoundedSet cylinder{dgd::Cylinder<double>(0.3, 0.5)};
  for (int i = 0; i < 100; ++i) {
    const Pose pose_1 = RandomPose(0.3), pose_2 = RandomPose(0.8);
    const auto compiled = dgd::GrowthDistance(AnySet(box), pose_1, AnySet(cylinder), pose_2);
    const auto typed = dgd::GrowthDistance(box, pose_1, cylinder, pose_2);
    EXPECT_EQ(compiled.status, typed.status);
    EXPECT_EQ(compiled.iterations, typed.iterations);
    EXPECT_NEAR(compiled.upper_bound, typed.upper_bound, 1e-12 * typed.upper_bound);
    EXPECT_NEAR((compiled.normal - typed.normal).norm(), 0, 1e-12);
  }
}

TEST_F(AnySetTest, WarmStartAndDistanceOfTheLastFrame_GoOn) {
  const AnySet box = RoundedSet{dgd::Box<double>({0.5, 0.5, 0.5}), 0.05}, capsule = dgd::Capsule(0.1, 0.4);
  Pose pose_1, pose_2;
  pose_2.translation = {0.1, 0, 1.2};
  dgd::WarmStart<double> state, next;
  const auto growth = dgd::GrowthDistance(box, pose_1, capsule, pose_2, {}, &state);
  const auto distance = dgd::SignedDistance(box, pose_1, capsule, pose_2, growth, &state, {}, &next);
  EXPECT_NEAR(distance.separation, 0.15, 1e-12);
  pose_2.translation.z() = 1.1;
  const auto followed = dgd::UpdateDistance(box, pose_1, capsule, pose_2, {}, next);
  EXPECT_EQ(followed.status, dgd::Status::kOptimal);
  EXPECT_NEAR(followed.separation, 0.05, 1e-12);
}

// By whichever way is the shorter one: with no growth distance before it, the signed distance is the same.
TEST_F(AnySetTest, SignedDistanceAlone_IsThatByWayOfTheGrowthDistance) {
  const std::vector<NamedSet> sets = MakeSets();
  int apart = 0, fewer = 0;
  for (const NamedSet& a : sets) {
    for (const NamedSet& b : sets) {
      SCOPED_TRACE(a.name + " and " + b.name);
      for (int i = 0; i < 8; ++i) {
        const Pose pose_a = RandomPose(0.3), pose_b = RandomPose(1.2);
        dgd::WarmStart<double> state, follow;
        const auto growth = dgd::GrowthDistance(a.set, pose_a, b.set, pose_b, {}, &state);
        const auto by_growth = dgd::SignedDistance(a.set, pose_a, b.set, pose_b, growth, &state);
        const auto alone = dgd::SignedDistance(a.set, pose_a, b.set, pose_b, dgd::Settings<double>{}, &follow);
        if (by_growth.status != dgd::Status::kOptimal) continue;
        EXPECT_EQ(alone.status, dgd::Status::kOptimal);
        const double gap = by_growth.upper_bound - by_growth.separation + alone.upper_bound - alone.separation;
        EXPECT_NEAR(alone.separation, by_growth.separation, gap + 1e-14);
        if (!(alone.separation > 0.01)) continue;
        EXPECT_NEAR(alone.separation, by_growth.separation, 1e-8);
        ++apart;
        fewer += alone.iterations < growth.iterations + by_growth.iterations;
        const auto updated = dgd::UpdateDistance(a.set, pose_a, b.set, pose_b, {}, follow);
        EXPECT_EQ(updated.status, dgd::Status::kOptimal);
        EXPECT_NEAR(updated.separation, alone.separation, 1e-8);
      }
    }
  }
  EXPECT_GT(apart, 300);
  EXPECT_GT(fewer, apart / 4);
}

// A query does not ask for more than the core's accuracy, or it would not end.
TEST_F(AnySetTest, CustomCore_IsSolvedToItsAccuracy) {
  const dgd::Box<double> box({0.5, 0.5, 0.5});
  const auto in_float = [](const void* object, const Vector3& direction) -> dgd::SupportPoint<double> {
    const Vector3 point = static_cast<const dgd::Box<double>*>(object)->Support(direction).point;
    return {(point + 1e-7 * direction.normalized().cwiseProduct(direction.normalized())).cast<float>().cast<double>()};
  };
  const AnySet custom = RoundedSet{dgd::CustomCore(&box, in_float, Vector3::Zero(), 0.5, 1e-6)};
  EXPECT_EQ(custom.Accuracy(), 1e-6);
  EXPECT_TRUE(custom.IsCustom());
  for (int i = 0; i < 50; ++i) {
    const Pose pose_2 = RandomPose(1);
    const auto result =
        dgd::GrowthDistance(custom, Pose(), dgd::AnySet(dgd::Sphere(0.3)), pose_2, {.relative_tolerance = 1e-12});
    EXPECT_EQ(result.status, dgd::Status::kOptimal);
    EXPECT_LE(result.RelativeGap(), 1.01e-6);
  }
}

TEST_F(AnySetTest, NotANumberInAPose_IsInvalidInput) {
  Pose broken;
  broken.translation.x() = std::numeric_limits<double>::quiet_NaN();
  for (const NamedSet& a : MakeSets()) {
    const AnySet ball = dgd::Sphere(0.3);
    EXPECT_EQ(dgd::GrowthDistance(a.set, broken, ball, Pose()).status, dgd::Status::kInvalidInput) << a.name;
    EXPECT_EQ(dgd::GrowthDistance(ball, Pose(), a.set, broken).status, dgd::Status::kInvalidInput) << a.name;
  }
}

TEST_F(AnySetTest, MovingSets_TouchWhenTheyDo) {
  const AnySet rod = RoundedSet{dgd::Box<double>({1, 0.05, 0.05}), 0.05}, ball = dgd::Sphere(0.2);
  dgd::Motion<double> motion, rest;
  motion.translation = {0, 1, 0};
  rest.start.translation = {0, 0.8, 0};
  for (const bool is_swapped : {false, true}) {
    const auto impact =
        is_swapped ? dgd::TimeOfImpact(ball, rest, rod, motion) : dgd::TimeOfImpact(rod, motion, ball, rest);
    EXPECT_EQ(impact.status, dgd::Status::kTouching);
    EXPECT_NEAR(impact.time, 0.5, 1e-9);
  }
}

TEST_F(AnySetTest, FacesOnAHalfSpaceAndOnABox_AreFound) {
  const AnySet box = RoundedSet{dgd::Box<double>({0.5, 0.5, 0.5})};
  Pose above;
  above.translation.z() = 0.6;
  const dgd::HalfSpace<double> ground;
  const auto height = dgd::GrowthDistance(box, above, ground, Pose());
  EXPECT_NEAR(height.separation, 0.1, 1e-15);
  EXPECT_EQ(dgd::FindFacingFaces(box, above, ground, height).overlap.size, 4);

  above.translation.z() = 1.1;
  dgd::FacingFaces<double> facing;
  const auto growth = dgd::GrowthDistance(box, Pose(), box, above);
  dgd::FindFacingFaces(box, Pose(), box, above, growth, facing);
  EXPECT_EQ(facing.overlap.size, 4);
  EXPECT_TRUE(facing.is_across_1 && facing.is_across_2);
  EXPECT_EQ(dgd::ReferenceSideOf(facing), dgd::ReferenceSide::kSet1);
}

TEST_F(AnySetTest, CentreThatMoves_IsTheOneThatIsScaledAbout) {
  AnySet plate = RoundedSet{dgd::Box<double>({2, 2, 0.1})};
  plate.MoveCenterNear({1.5, 0, 1});
  EXPECT_NEAR((plate.Center() - Vector3(1.5, 0, 0)).norm(), 0, 1e-15);
  AnySet ball = dgd::Sphere(1.0);
  ball.MoveCenterNear({1, 1, 1});
  EXPECT_EQ(ball.Center(), Vector3::Zero().eval());
}

/// A capsule of radius 0.2 and half length 0.5 behind a support function that computes in float.
dgd::SupportPoint<double> FloatCapsule(const void*, const Vector3& direction) {
  const Eigen::Vector3f outwards = direction.cast<float>().normalized();
  return {(0.2F * outwards + std::copysign(0.5F, outwards.z()) * Eigen::Vector3f::UnitZ()).cast<double>()};
}

// Faces of an expanding polytope that are narrower than the root of that roundoff had no planes: one query in ten took
// hundreds of evaluations.
TEST_F(AnySetTest, SupportInFloat_EndsInFewEvaluationsWithPointsOnBothSets) {
  constexpr double kAccuracy = 4.8e-7;
  const AnySet box = RoundedSet{dgd::Box<double>({0.5, 0.5, 0.5})};
  const AnySet in_float = RoundedSet{dgd::CustomCore(nullptr, FloatCapsule, Vector3::Zero(), 0, kAccuracy)};
  const AnySet exact = dgd::Capsule(0.2, 0.5), point = RoundedSet{dgd::Point<double>()};
  const auto distance_to = [&](const AnySet& set, const Pose& pose, const Vector3& place) {
    return dgd::SignedDistance(set, pose, point, Pose{Eigen::Matrix3d::Identity(), place}).separation;
  };
  int overlaps = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose pose_1, pose_2 = RandomPose(0.9);
    dgd::Result<double> start;  // A direction alone.
    const auto result = dgd::SignedDistance(box, pose_1, in_float, pose_2, start, nullptr, {.max_iterations = 500});
    const auto expected = dgd::SignedDistance(box, pose_1, exact, pose_2);
    EXPECT_EQ(result.status, dgd::Status::kOptimal);
    EXPECT_LE(result.iterations, 64);
    EXPECT_NEAR(result.separation, expected.separation, 0.01 * std::abs(std::min(expected.separation, 0.0)) + 2e-6);
    EXPECT_NEAR(distance_to(box, pose_1, result.witness_1), 0, 1e-5);
    EXPECT_NEAR(distance_to(exact, pose_2, result.witness_2), 0, 1e-5);
    overlaps += result.separation < 0 ? 1 : 0;
  }
  EXPECT_GT(overlaps, 100);
}

}  // namespace
}  // namespace dgd_test
