// A start from the last query's state is only a start: the answer is the cold one, sooner.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "dgd/shapes/polytope.h"
#include "support/checks.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

ReferencePair RandomPairOfAnyType(Random& random) {
  const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
  const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(random.Below(7))];
  return RandomPair(random, type_1, random.Flip(), type_2, random.Flip());
}

template <class S>
void FollowMovingPairs(int pairs) {
  Random random(TestSeed());
  for (int i = 0; i < pairs; ++i) {
    ReferencePair reference = RandomPairOfAnyType(random);
    dgd::WarmStart<S> warm_start;
    const double step = random.LogUniform(1e-6, 0.3);
    for (int frame = 0; frame < 5; ++frame) {
      const SolverPair<S> pair(reference);
      const dgd::Result<S> warm = pair.GrowthDistance({}, &warm_start);
      ASSERT_TRUE(IsCertified<S>(reference, pair, warm)) << "frame " << frame << " step " << step;
      // Nearly coincident centres magnify the rounding of coordinates, also of those that only one of the two met.
      const double gap = Bounds<S>::Gap(pair, reference.Extent());
      const S slack = 64 * dgd::kEpsilon<S> + static_cast<S>(gap - 1.0001 * double(dgd::kSqrtEpsilon<S>));
      ASSERT_TRUE(Agree(warm, pair.GrowthDistance(), slack)) << reference.Dump();
      reference = Moved(random, reference, step);
    }
  }
}

TEST(WarmStart, MovingPairs_AreCertifiedAndAgreeWithColdInDouble) { FollowMovingPairs<double>(TestCount(5000)); }
TEST(WarmStart, MovingPairs_AreCertifiedAndAgreeWithColdInFloat) { FollowMovingPairs<float>(TestCount(2000)); }

/// Mean iterations of polytope pairs after a motion of 1 %, cold and warm.
void CompareIterations(double radius) {
  Random random(TestSeed());
  long cold = 0, warm = 0;
  const int pairs = TestCount(5000, 200);
  for (int i = 0; i < pairs; ++i) {
    ReferencePair reference;
    reference.set_1 = RandomHull(random, 8 + random.Below(13), 0.5, radius);
    reference.set_2 = RandomHull(random, 8 + random.Below(13), 0.5, radius);
    PlaceRandomly(random, reference, {.closest = 0.2, .farthest = 5});
    dgd::WarmStart<double> warm_start;
    (void)SolverPair<double>(reference).GrowthDistance({}, &warm_start);
    const SolverPair<double> pair(Moved(random, reference, 0.01));
    cold += pair.GrowthDistance().iterations;
    warm += pair.GrowthDistance({}, &warm_start).iterations;
  }
  std::printf("radius %g: mean iterations cold %.2f, warm %.2f\n", radius, double(cold) / pairs, double(warm) / pairs);
  EXPECT_LT(double(warm), 0.7 * double(cold));
}

TEST(WarmStart, PolytopesAfterOnePercentMotion_NeedFewerIterations) {
  CompareIterations(0);
  CompareIterations(0.04);
}

TEST(WarmStart, UnmovedPolytopes_NeedOneOrTwoIterations) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(2000); ++i) {
    ReferencePair reference;
    reference.set_1 = RandomHull(random, 12, 0.5, 0);
    reference.set_2 = RandomHull(random, 12, 0.5, random.Flip() ? 0.04 : 0);
    PlaceRandomly(random, reference, {.closest = 0.2, .farthest = 5});
    const SolverPair<double> pair(reference);
    dgd::WarmStart<double> warm_start;
    (void)pair.GrowthDistance({}, &warm_start);
    ASSERT_LE(pair.GrowthDistance({}, &warm_start).iterations, 2) << reference.Dump();
  }
}

// State of another pair, of other shapes with fewer or more vertices.
template <class S>
void StartFromOtherPairs(int pairs) {
  Random random(TestSeed());
  dgd::WarmStart<S> warm_start;
  for (int i = 0; i < pairs; ++i) {
    const ReferencePair reference = RandomPairOfAnyType(random);
    const SolverPair<S> pair(reference);
    ASSERT_TRUE(IsCertified<S>(reference, pair, pair.GrowthDistance({}, &warm_start)));
    const dgd::CollisionResult<S> warm = pair.DetectCollision({}, &warm_start);
    const dgd::CollisionResult<S> cold = pair.DetectCollision();
    if (warm.status != dgd::Status::kTouching && cold.status != dgd::Status::kTouching) {
      ASSERT_EQ(warm.status, cold.status) << reference.Dump();
    }
  }
}
TEST(WarmStart, StateOfOtherPairs_DoesNoHarmInDouble) { StartFromOtherPairs<double>(TestCount(20000)); }
TEST(WarmStart, StateOfOtherPairs_DoesNoHarmInFloat) { StartFromOtherPairs<float>(TestCount(5000)); }

// Any unit vector, any vertex numbers, any size that the type allows: equal points, missing points, the far side.
TEST(WarmStart, ArbitraryState_DoesNoHarm) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(20000); ++i) {
    const ReferencePair reference = RandomPairOfAnyType(random);
    const SolverPair<double> pair(reference);
    dgd::WarmStart<double> warm_start;
    warm_start.normal_1 = random.Flip() ? random.UnitVector() : Eigen::Vector3d(Eigen::Vector3d::Zero());
    warm_start.size = random.Below(4);
    for (std::size_t k = 0; k < warm_start.features_1.size(); ++k) {
      const int range = random.Flip() ? 3 : 40;
      warm_start.features_1[k] = static_cast<dgd::VertexId>(random.Below(range));
      warm_start.features_2[k] =
          random.Below(10) == 0 ? dgd::kNoFeature : static_cast<dgd::VertexId>(random.Below(range));
    }
    ASSERT_TRUE(IsCertified<double>(reference, pair, pair.GrowthDistance({}, &warm_start)));
  }
}

// Not even a state that no query has written: not unit, not finite.
TEST(WarmStart, CorruptNormal_DoesNoHarm) {
  Random random(TestSeed());
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (int i = 0; i < TestCount(2000); ++i) {
    const ReferencePair reference = RandomPairOfAnyType(random);
    const SolverPair<double> pair(reference);
    const Eigen::Vector3d normals[] = {{nan, nan, nan},
                                       {infinity, 0, 0},
                                       {1, nan, 1},
                                       1e3 * random.UnitVector(),
                                       1e-3 * random.UnitVector(),
                                       1e-200 * random.UnitVector(),
                                       1e200 * random.UnitVector()};
    for (const Eigen::Vector3d& normal : normals) {
      dgd::WarmStart<double> warm_start;
      warm_start.normal_1 = normal;
      ASSERT_TRUE(IsCertified<double>(reference, pair, pair.GrowthDistance({}, &warm_start)))
          << "normal " << normal.transpose();
    }
  }
}

// A pair that stays apart is answered from the remembered normal alone, over and over: the normal must stay a unit
// vector, also where the rotations handed in are orthonormal only to float's rounding, as Bullet's are.
TEST(WarmStart, ManySeparatedFrames_KeepTheNormalAUnitVector) {
  Random random(TestSeed());
  ReferencePair reference;
  reference.set_1 = RandomHull(random, 12, 0.5, 0.04);
  reference.set_2 = RandomHull(random, 12, 0.5, 0.04);
  PlaceRandomly(random, reference, {.closest = 5, .farthest = 5});
  SolverPair<float> pair(reference);
  pair.pose_1.rotation *= 1 + 3e-7F;
  dgd::WarmStart<float> warm_start;
  for (int frame = 0; frame < 200000; ++frame) {
    const dgd::Result<float> result = pair.GrowthDistance({.separation_limit = 0.02F}, &warm_start);
    ASSERT_EQ(result.status, dgd::Status::kSeparated);
    ASSERT_NEAR(result.normal.norm(), 1, 2e-6) << "frame " << frame;
  }
}

// The plugin solves in double what Bullet knows in float: rotations that are off by 1e-7. A pair that stays apart is
// answered from its normal nonetheless, whichever way that was found.
TEST(WarmStart, RotationsRoundedToFloat_KeepTheNormal) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(500); ++i) {
    ReferencePair reference;
    reference.set_1 = RandomHull(random, 12, 0.5, 0.04);
    reference.set_2 = RandomHull(random, 12, 0.5, 0.04);
    PlaceRandomly(random, reference, {.closest = 1.1, .farthest = 1.1});
    SolverPair<double> pair(reference);
    for (dgd::Pose<double>* pose : {&pair.pose_1, &pair.pose_2}) {
      pose->rotation = pose->rotation.cast<float>().cast<double>().eval();
    }
    dgd::WarmStart<double> by_distance, by_check;
    const dgd::Settings<double> settings{.separation_limit = 0};
    ASSERT_EQ(pair.GrowthDistance(settings, &by_distance).status, dgd::Status::kSeparated);
    ASSERT_EQ(pair.DetectCollision({}, &by_check).status, dgd::Status::kSeparated);
    for (dgd::WarmStart<double>* state : {&by_distance, &by_check}) {
      ASSERT_TRUE(dgd::HasSeparatingAxis(state)) << state->normal_1.norm() - 1;
      ASSERT_EQ(pair.GrowthDistance(settings, state).iterations, 1);
    }
  }
}

// What stays after a change of vertices while the state is kept: numbers that no longer exist are ignored.
TEST(WarmStart, FewerVertices_AreNoticed) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(500); ++i) {
    ReferencePair many;
    many.set_1 = RandomHull(random, 60, 0.5, 0);
    many.set_2 = RandomHull(random, 60, 0.5, 0);
    PlaceRandomly(random, many);
    ReferencePair few = many;
    few.set_1.points.resize(4);
    few.set_2.points.resize(4);
    dgd::WarmStart<double> warm_start;
    (void)SolverPair<double>(many).GrowthDistance({}, &warm_start);
    const SolverPair<double> pair(few);
    ASSERT_TRUE(IsCertified<double>(few, pair, pair.GrowthDistance({}, &warm_start)));
  }
}

}  // namespace
}  // namespace dgd_test
