// What a narrowphase counts, pair of types by pair of types, and how it is written down.
#include "dgd_bullet/statistics.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <numeric>

#include "plugin/pair_query.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

template <class Counts>
std::uint64_t Sum(const Counts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

class Counted : public testing::Test {
 protected:
  Dispatching dispatching_{Route::kConfiguration, Counting()};
  btBoxShape box_{Vec(0.5, 0.5, 0.5)};
  btSphereShape ball_{btScalar(0.5)};
};

TEST_F(Counted, EachCall_IsCountedOnceByItsEnd) {
  PairQuery pair(dispatching_.dispatcher(), box_, box_);
  pair.SetPoses(At(0, 0, 0), At(0, 0, 3));
  pair.Step();
  pair.SetPoses(At(0, 0, 0), At(0, 0, 0.8));
  pair.Step();
  pair.SetPoses(At(0, 0, 0), At(0, 0, 0.999));
  pair.Step();
  pair.SetPoses(At(0, 0, 0), At(0, 0, 0.3));
  pair.Step();  // Deep in each other.
  const dgd_bullet::Statistics statistics = dispatching_.statistics();
  ASSERT_EQ(statistics.pairs.size(), 1U);
  const dgd_bullet::PairStatistics& boxes = statistics.pairs[0];
  EXPECT_EQ(boxes.type_0, int(BOX_SHAPE_PROXYTYPE));
  EXPECT_EQ(boxes.type_1, int(BOX_SHAPE_PROXYTYPE));
  EXPECT_EQ(boxes.calls, 4U);
  EXPECT_EQ(boxes.separated, 1U);
  EXPECT_EQ(boxes.solved, 3U);
  EXPECT_EQ(boxes.deep, 1U);
  EXPECT_EQ(boxes.Fallbacks(), 0U);
  EXPECT_EQ(Sum(boxes.iterations), boxes.calls);
  EXPECT_EQ(Sum(boxes.patch_sizes), boxes.calls);
  EXPECT_EQ(boxes.patch_sizes[0], 1U);
  EXPECT_EQ(boxes.patch_sizes[4], 3U);
  EXPECT_GE(boxes.worst_gap, 0);
  EXPECT_LE(boxes.worst_gap, 1e-8);
}

TEST_F(Counted, Types_AreAPairInEitherOrder) {
  for (const bool ball_first : {true, false}) {
    PairQuery pair(dispatching_.dispatcher(), ball_first ? static_cast<btConvexShape&>(ball_) : box_,
                   ball_first ? static_cast<btConvexShape&>(box_) : ball_);
    pair.SetPoses(At(0, 0, 0), At(0, 0, 0.95));
    pair.Step();
  }
  const dgd_bullet::Statistics statistics = dispatching_.statistics();
  ASSERT_EQ(statistics.pairs.size(), 1U);
  EXPECT_EQ(statistics.pairs[0].type_0, int(BOX_SHAPE_PROXYTYPE));
  EXPECT_EQ(statistics.pairs[0].type_1, int(SPHERE_SHAPE_PROXYTYPE));
  EXPECT_EQ(statistics.pairs[0].calls, 2U);
  EXPECT_EQ(statistics.pairs[0].patch_sizes[1], 2U);
}

TEST_F(Counted, Fallbacks_AreCountedByReasonToo) {
  btTriangleShape flat(Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0));
  flat.setMargin(0);
  dgd_bullet::Options options = Counting();
  options.max_iterations = 1;
  Dispatching hurried(Route::kConfiguration, options);
  PairQuery pair(hurried.dispatcher(), flat, flat);
  pair.SetPoses(At(0, 0, 0), At(0, 0, 0.001));
  pair.Step();
  const dgd_bullet::Statistics statistics = hurried.statistics();
  ASSERT_EQ(statistics.pairs.size(), 1U);
  EXPECT_EQ(statistics.pairs[0].fallbacks_no_interior, 1U);
  EXPECT_EQ(statistics.pairs[0].calls, 1U);
  EXPECT_EQ(statistics.fallbacks_no_interior, 1U);
  EXPECT_EQ(Sum(statistics.pairs[0].iterations), 0U);
}

TEST_F(Counted, Json_SaysTheSame) {
  PairQuery pair(dispatching_.dispatcher(), box_, ball_);
  pair.SetPoses(At(0, 0, 0), At(0, 0, 0.95));
  for (int i = 0; i < 3; ++i) pair.Step();
  const dgd_bullet::Statistics statistics = dispatching_.statistics();
  const auto json = nlohmann::json::parse(dgd_bullet::ToJson(statistics));
  EXPECT_EQ(json["fallbacks_invalid"], 0);
  ASSERT_EQ(json["pairs"].size(), 1U);
  const auto& row = json["pairs"][0];
  EXPECT_EQ(row["type_0"], "BOX");
  EXPECT_EQ(row["type_1"], "SPHERE");
  EXPECT_EQ(row["calls"], statistics.pairs[0].calls);
  EXPECT_EQ(row["separated"], statistics.pairs[0].separated);
  EXPECT_EQ(row["deep"], statistics.pairs[0].deep);
  EXPECT_EQ(row["solved"], statistics.pairs[0].solved);
  EXPECT_EQ(row["fallbacks_not_converged"], 0);
  EXPECT_EQ(row["iterations"].size(), statistics.pairs[0].iterations.size());
  EXPECT_EQ(row["patch_sizes"], statistics.pairs[0].patch_sizes);
  EXPECT_NEAR(row["worst_gap"].get<double>(), statistics.pairs[0].worst_gap, 1e-12);
}

TEST(Statistics, NotAskedFor_HaveNoPairs) {
  Dispatching dispatching(Route::kConfiguration);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  PairQuery pair(dispatching.dispatcher(), box, box);
  pair.SetPoses(At(0, 0, 0), At(0, 0, 0.9));
  pair.Step();
  EXPECT_TRUE(dispatching.statistics().pairs.empty());
  EXPECT_EQ(nlohmann::json::parse(dgd_bullet::ToJson(dispatching.statistics()))["pairs"].size(), 0U);
}

}  // namespace
}  // namespace dgd_test
