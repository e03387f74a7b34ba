// What must not change the answer: the order of the sets, where in the world the pair is, and the unit of length.
#include <gtest/gtest.h>

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
dgd::Result<S> Swapped(const dgd::Result<S>& result) {
  dgd::Result<S> swapped = result;
  swapped.normal = -result.normal;
  std::swap(swapped.witness_1, swapped.witness_2);
  return swapped;
}

TEST(GrowthDistance, SwappedSets_GiveTheSameBoundsAndTheOppositeNormal) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(20000); ++i) {
    const ReferencePair reference = RandomPairOfAnyType(random);
    const ReferencePair reversed{reference.set_2, reference.set_1, reference.pose_2, reference.pose_1};
    const SolverPair<double> pair(reference);
    const dgd::Result<double> result = pair.GrowthDistance();
    const dgd::Result<double> swapped = Swapped(SolverPair<double>(reversed).GrowthDistance());
    ASSERT_TRUE(Agree(result, swapped, 1e-12));
    // The answer to the reversed question, turned round, is an optimal answer to this one.
    ASSERT_TRUE(IsCertified<double>(reference, pair, swapped));
  }
}

TEST(GrowthDistance, SwappedPolytopes_GiveTheSameFields) {
  Random random(TestSeed());
  const dgd::Settings<double> tight{.relative_tolerance = 1e-13};
  for (int i = 0; i < TestCount(5000); ++i) {
    ReferencePair reference;
    reference.set_1 = RandomHull(random, 8 + random.Below(13), 0.5, 0);
    reference.set_2 = RandomHull(random, 8 + random.Below(13), 0.5, random.Flip() ? 0.04 : 0);
    PlaceRandomly(random, reference, {.closest = 0.2, .farthest = 5});
    const ReferencePair reversed{reference.set_2, reference.set_1, reference.pose_2, reference.pose_1};
    const dgd::Result<double> result = SolverPair<double>(reference).GrowthDistance(tight);
    const dgd::Result<double> swapped = Swapped(SolverPair<double>(reversed).GrowthDistance(tight));
    ASSERT_NEAR(swapped.lower_bound / result.lower_bound, 1, 1e-12) << reference.Dump();
    ASSERT_NEAR(swapped.upper_bound / result.upper_bound, 1, 1e-12) << reference.Dump();
    ASSERT_NEAR((swapped.normal - result.normal).norm(), 0, 1e-6) << reference.Dump();
    ASSERT_NEAR(swapped.separation, result.separation, 1e-12) << reference.Dump();
  }
}

TEST(GrowthDistance, RigidMotion_ChangesNothing) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(20000); ++i) {
    const ReferencePair reference = RandomPairOfAnyType(random);
    const Eigen::Matrix3d rotation = random.Rotation();
    const Eigen::Vector3d translation = random.LogUniform(0.01, 100) * random.UnitVector();
    const auto move = [&](const ReferencePose& pose) {
      return ReferencePose{rotation * pose.rotation, rotation * pose.translation + translation};
    };
    const ReferencePair moved{reference.set_1, reference.set_2, move(reference.pose_1), move(reference.pose_2)};
    const SolverPair<double> pair(reference), moved_pair(moved);
    const dgd::Result<double> result = pair.GrowthDistance();
    const dgd::Result<double> there = moved_pair.GrowthDistance();
    ASSERT_TRUE(IsCertified<double>(moved, moved_pair, there));
    ASSERT_TRUE(Agree(result, there, 1e-10));
    dgd::Result<double> back = there;
    back.normal = rotation.transpose() * there.normal;
    back.witness_1 = rotation.transpose() * (there.witness_1 - translation);
    back.witness_2 = rotation.transpose() * (there.witness_2 - translation);
    // The way there and back has rounded everything to the distance travelled.
    const dgd::Certificate certificate = pair.Certify(back);
    ASSERT_TRUE(certificate.Holds(1e-9 * reference.Extent() + 1e-12, 2e-8)) << reference.Dump();
  }
}

/// Every number of a result, to be compared bit by bit.
std::vector<double> Numbers(const dgd::Result<double>& r, double unit) {
  return {double(r.status),       double(r.iterations),   r.lower_bound,          r.upper_bound,
          r.separation / unit,    r.normal.x(),           r.normal.y(),           r.normal.z(),
          r.witness_1.x() / unit, r.witness_1.y() / unit, r.witness_1.z() / unit, r.witness_2.x() / unit,
          r.witness_2.y() / unit, r.witness_2.z() / unit};
}

// A power of two scales every rounding along, so that a tolerance hidden in metres would be the only difference.
// Polytopes apart: Qhull's sums do not scale to the last bit.
TEST(GrowthDistance, UnitOfLength_DoesNotMatterToTheLastBit) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(20000); ++i) {
    const CoreType type_1 = kCoreTypes[static_cast<std::size_t>(random.Below(6))];
    const CoreType type_2 = kCoreTypes[static_cast<std::size_t>(random.Below(6))];
    const ReferencePair reference = RandomPair(random, type_1, random.Flip(), type_2, random.Flip());
    const std::vector<double> numbers = Numbers(SolverPair<double>(reference).GrowthDistance(), 1);
    for (const double unit : {0x1p-20, 0x1p-3, 0x1p10}) {
      ReferencePair scaled = reference;
      scaled.set_1 = Scaled(reference.set_1, unit);
      scaled.set_2 = Scaled(reference.set_2, unit);
      scaled.pose_1.translation *= unit;
      scaled.pose_2.translation *= unit;
      ASSERT_EQ(Numbers(SolverPair<double>(scaled).GrowthDistance(), unit), numbers) << unit << "\n"
                                                                                     << reference.Dump();
    }
  }
}

// From dust to planets, also in float, where squares of lengths come near the smallest number.
template <class S>
void CertifyAtScale(double unit) {
  Random random(TestSeed());
  for (int i = 0; i < TestCount(2000); ++i) {
    ReferencePair reference = RandomPairOfAnyType(random);
    reference.set_1 = Scaled(reference.set_1, unit);
    reference.set_2 = Scaled(reference.set_2, unit);
    reference.pose_1.translation *= unit;
    reference.pose_2.translation *= unit;
    ASSERT_TRUE(SolvesAndCertifies<S>(reference)) << unit;
  }
}
TEST(GrowthDistance, MicrometresToThousandKilometres_AreCertified) {
  for (const double unit : {1e-9, 1e-6, 1e-3, 1e3, 1e6}) CertifyAtScale<double>(unit);
  for (const double unit : {1e-6, 1e-3, 1e3, 1e6}) CertifyAtScale<float>(unit);
}

}  // namespace
}  // namespace dgd_test
