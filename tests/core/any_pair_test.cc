// Most tests ask of sets whose types are hidden (support/pairs/any_pair.h): a user's sets, whose types the solver
// knows, get the same answers to the last bit.
#include "support/pairs/any_pair.h"

#include <gtest/gtest.h>

#include "dgd/shapes/box.h"
#include "dgd/shapes/cone.h"
#include "dgd/shapes/cylinder.h"
#include "dgd/shapes/polytope.h"
#include "support/random_sets.h"

namespace dgd_test {
namespace {

template <class Answer>
void ExpectEqualBits(const Answer& a, const Answer& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.separation, b.separation);
  EXPECT_EQ(a.upper_bound, b.upper_bound);
  EXPECT_EQ(a.witness_1, b.witness_1);
  EXPECT_EQ(a.witness_2, b.witness_2);
}

/// Cold and then warm, from deep inside to apart.
template <class Set1, class Set2>
void Compare(const Set1& set_1, const Set2& set_2) {
  using S = typename Set1::Scalar;
  Random random(TestSeed());
  AnyPair<S, 3> pair(Erase(set_1), {}, Erase(set_2), {});
  for (int i = 0; i < TestCount(200, 20) && !testing::Test::HasFailure(); ++i) {
    const dgd::Pose<S> pose_1{random.Rotation().cast<S>(), random.InCube().cast<S>()};
    dgd::Pose<S> pose_2{random.Rotation().cast<S>(), pose_1.translation};
    pose_2.translation += (random.Uniform(0, 2) * random.UnitVector()).template cast<S>();
    dgd::WarmStart<S> warm, any_warm;
    for (int frame = 0; frame < 2; ++frame) {
      pair.MoveTo(pose_1, pose_2);
      const auto growth = dgd::GrowthDistance(set_1, pose_1, set_2, pose_2, {}, &warm);
      const auto any_growth = pair.GrowthDistance({}, &any_warm);
      ExpectEqualBits(growth, any_growth);
      EXPECT_EQ(growth.lower_bound, any_growth.lower_bound);
      ExpectEqualBits(dgd::SignedDistance(set_1, pose_1, set_2, pose_2, growth, &warm),
                      pair.SignedDistance(any_growth, &any_warm));
      pose_2.translation += (0.01 * random.UnitVector()).template cast<S>();
    }
  }
}

template <class S>
dgd::Polytope<S> RandomPolytope() {
  Random random(TestSeed());
  return dgd::Polytope<S>(RandomHull(random, 30, 1, 0).points);
}

TEST(AnyPair, Polytopes_AsTheirTypes) {
  Compare(dgd::RoundedSet{RandomPolytope<double>(), 0.1}, dgd::RoundedSet{dgd::Box<double>({0.3, 0.2, 0.4})});
}

TEST(AnyPair, CurvedSets_AsTheirTypes) {
  Compare(dgd::RoundedSet{dgd::Cone<double>(0.3, 0.6)}, dgd::RoundedSet{dgd::Cylinder<double>(0.3, 0.2), 0.05});
}

TEST(AnyPair, SetsInFloat_AsTheirTypes) {
  Compare(dgd::RoundedSet{RandomPolytope<float>()}, dgd::RoundedSet{dgd::Box<float>({0.3F, 0.2F, 0.4F}), 0.05F});
}

}  // namespace
}  // namespace dgd_test
