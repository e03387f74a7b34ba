// What the pairs of a dispatcher share, under several threads: hulls, options, counters, the fallback. The pairs here
// have their manifolds beforehand, since Debian's Bullet does not lock its own pools.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

constexpr int kThreads = 4;
constexpr int kPairs = 1000;
constexpr int kSteps = 20;

/// A thousand pairs of a few shapes, so that all threads ask for the same hulls.
class Crowd {
 public:
  explicit Crowd(btCollisionDispatcher& dispatcher) {
    Random random(TestSeed());
    for (int i = 0; i < kPairs; ++i) {
      const ZooShape& a = shapes_[std::size_t(random.Below(int(shapes_.size())))];
      const ZooShape& b = shapes_[std::size_t(random.Below(int(shapes_.size())))];
      pairs_.push_back(std::make_unique<PairQuery>(dispatcher, *a.shape, *b.shape));
      pairs_.back()->SetPoses(MakeTransform(random.Rotation(), {0, 0, 0}),
                              MakeTransform(random.Rotation(), random.Uniform(0.3, 0.7) * random.UnitVector()));
      pairs_.back()->Step();
    }
  }

  /// Each pair on a way of its own, the pairs shared out among the threads.
  std::vector<std::vector<Contact>> Run(int threads) {
    std::vector<std::vector<Contact>> contacts(pairs_.size());
    const auto work = [&](int thread) {
      for (std::size_t i = std::size_t(thread); i < pairs_.size(); i += std::size_t(threads)) {
        Random random(i);
        for (int step = 0; step < kSteps; ++step) {
          pairs_[i]->body_b().getWorldTransform().getOrigin() += ToBullet(0.005 * random.UnitVector());
          const std::vector<Contact> found = pairs_[i]->Step();
          contacts[i].insert(contacts[i].end(), found.begin(), found.end());
        }
      }
    };
    std::vector<std::thread> workers;
    for (int thread = 1; thread < threads; ++thread) workers.emplace_back(work, thread);
    work(0);
    for (std::thread& worker : workers) worker.join();
    return contacts;
  }

 private:
  std::vector<ZooShape> shapes_ = MakeShapeZoo(0.5);
  std::vector<std::unique_ptr<PairQuery>> pairs_;
};

TEST(Threads, ManyOrOne_GiveTheSameContactsToTheLastBitAndTheSameCounts) {
  Dispatching alone(Route::kConfiguration, Counting()), shared(Route::kConfiguration, Counting());
  const std::vector<std::vector<Contact>> expected = Crowd(alone.dispatcher()).Run(1);
  const std::vector<std::vector<Contact>> contacts = Crowd(shared.dispatcher()).Run(kThreads);
  std::size_t count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(contacts[i].size(), expected[i].size()) << i;
    count += expected[i].size();
    for (std::size_t j = 0; j < expected[i].size(); ++j) {
      EXPECT_EQ(contacts[i][j].normal_b_to_a, expected[i][j].normal_b_to_a);
      EXPECT_EQ(contacts[i][j].on_b, expected[i][j].on_b);
      EXPECT_EQ(contacts[i][j].depth, expected[i][j].depth);
    }
  }
  EXPECT_GT(count, std::size_t{kPairs});
  EXPECT_EQ(dgd_bullet::ToJson(shared.statistics()), dgd_bullet::ToJson(alone.statistics()));
}

// As the triangles of a mesh, which are new pairs at every step, find their partner's hull.
TEST(Threads, NewPairs_FindTheHullsThatAreThere) {
  Dispatching dispatching(Route::kConfiguration);
  Random random(TestSeed());
  std::vector<std::shared_ptr<btConvexHullShape>> hulls;
  for (int i = 0; i < 100; ++i) hulls.push_back(MakeRandomHull(random, 12, 0.5));
  // One algorithm a thread, used for pair after pair, as GImpact does: the hull is looked up each time.
  std::vector<std::unique_ptr<PairQuery>> pairs;
  for (int i = 0; i < kThreads; ++i) {
    pairs.push_back(std::make_unique<PairQuery>(dispatching.dispatcher(), *hulls[0], *hulls[1]));
    pairs.back()->SetPoses(btTransform::getIdentity(), MakeTransform(Eigen::Matrix3d::Identity(), {0, 0, 0.45}));
    pairs.back()->Step();
  }
  std::vector<int> touching(kThreads, 0);
  const auto work = [&](int thread) {
    PairQuery& pair = *pairs[std::size_t(thread)];
    for (std::size_t i = 0; i < 2000; ++i) {
      pair.body_a().setCollisionShape(hulls[i % hulls.size()].get());
      pair.body_b().setCollisionShape(hulls[(7 * i + 3) % hulls.size()].get());
      touching[std::size_t(thread)] += !pair.Step().empty();
    }
  };
  std::vector<std::thread> workers;
  for (int thread = 0; thread < kThreads; ++thread) workers.emplace_back(work, thread);
  for (std::thread& worker : workers) worker.join();
  EXPECT_GT(touching[0], 200);
  for (const int count : touching) EXPECT_EQ(count, touching[0]);
}

}  // namespace
}  // namespace dgd_test
