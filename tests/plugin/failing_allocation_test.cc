// Memory that runs out: each allocation of a pair's first steps fails in turn. Nothing is thrown into Bullet, nothing
// that is not finite is written, and with memory again the contacts are those of a pair that never lacked any.
//
// Apart from the other tests, for operator new is the program's.
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "plugin/fallback_fixture.h"
#include "plugin/shape_zoo.h"
#include "plugin/triangle_grid.h"

namespace {

/// Allocations until one fails, and from then on all; negative for never.
thread_local long allocations_left = -1;

thread_local long allocations_made = 0;

/// Null where there is no memory.
void* Allocate(std::size_t size) {
  ++allocations_made;
  if (allocations_left == 0) return nullptr;
  if (allocations_left > 0) --allocations_left;
  return std::malloc(size);
}

void* AllocateOrThrow(std::size_t size) {
  if (void* memory = Allocate(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// All forms that are in use: a sanitizer's own would not go together with these.
void* operator new(std::size_t size) { return AllocateOrThrow(size); }
void* operator new[](std::size_t size) { return AllocateOrThrow(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return Allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return Allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace dgd_test {
namespace {

/// Until it is over, the (n + 1)-th allocation and all later ones fail.
class MemoryForSome {
 public:
  explicit MemoryForSome(long n) { allocations_left = n; }
  ~MemoryForSome() { allocations_left = -1; }
  MemoryForSome(const MemoryForSome&) = delete;
  MemoryForSome& operator=(const MemoryForSome&) = delete;

  /// Whether one has failed, or the next would.
  bool IsOver() const { return allocations_left == 0; }
};

/// Contacts go into the manifold, as in a world: what PairQuery collects them in may have no memory either.
class BarePair {
 public:
  BarePair(btCollisionDispatcher& dispatcher, btCollisionShape& shape_a, btCollisionShape& shape_b)
      : dispatcher_(dispatcher) {
    a_.setCollisionShape(&shape_a);
    b_.setCollisionShape(&shape_b);
    a_.setWorldTransform(At(0.02, 0.01, 0.85));
  }
  ~BarePair() {
    if (algorithm_ == nullptr) return;
    algorithm_->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(algorithm_);
  }
  BarePair(const BarePair&) = delete;
  BarePair& operator=(const BarePair&) = delete;

  void Step() {
    const btCollisionObjectWrapper a(nullptr, a_.getCollisionShape(), &a_, a_.getWorldTransform(), -1, -1);
    const btCollisionObjectWrapper b(nullptr, b_.getCollisionShape(), &b_, b_.getWorldTransform(), -1, -1);
    if (algorithm_ == nullptr) algorithm_ = dispatcher_.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    btManifoldResult result(&a, &b);
    algorithm_->processCollision(&a, &b, btDispatcherInfo(), &result);
  }

  btPersistentManifold& Manifold() {
    btManifoldArray manifolds;
    algorithm_->getAllContactManifolds(manifolds);
    return *manifolds[0];
  }

 private:
  btCollisionDispatcher& dispatcher_;
  btCollisionObject a_, b_;
  btCollisionAlgorithm* algorithm_ = nullptr;
};

TEST(FailingAllocation, EachInTurn_NothingThrownAndMadeUpForLater) {
  dgd_bullet::Options options = Counting();
  options.on_first_fallback = nullptr;
  int failures = 0;
  const std::vector<ZooShape> zoo = MakeShapeZoo(1);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  for (const ZooShape& shape : zoo) {
    SCOPED_TRACE(shape.name);
    Dispatching undisturbed(Route::kConfiguration, options);
    BarePair expected(undisturbed.dispatcher(), *shape.shape, box);
    for (int step = 0; step < 3; ++step) expected.Step();
    for (long n = 0; n < 1000; ++n) {
      // Hulls that another pair has made are found again, on this thread: a new shape is not known to it.
      Dispatching dispatching(Route::kConfiguration, options);
      const std::vector<ZooShape> fresh = MakeShapeZoo(1);
      BarePair pair(dispatching.dispatcher(), *fresh[std::size_t(&shape - zoo.data())].shape, box);
      bool is_over = false;
      {
        const MemoryForSome memory(n);
        for (int step = 0; step < 3; ++step) pair.Step();
        is_over = memory.IsOver();
      }
      failures += dispatching.statistics().Fallbacks() > 0;
      for (int step = 0; step < 3; ++step) pair.Step();
      ASSERT_EQ(pair.Manifold().getNumContacts(), expected.Manifold().getNumContacts()) << n;
      for (int i = 0; i < pair.Manifold().getNumContacts(); ++i) {
        EXPECT_NEAR(double(pair.Manifold().getContactPoint(i).getDistance()),
                    double(expected.Manifold().getContactPoint(i).getDistance()), kLength);
      }
      if (!is_over) break;
    }
  }
  EXPECT_GT(failures, 20) << "hulls need memory";
}

// Of a mesh, the triangles' algorithms are kept in memory of ours.
TEST(FailingAllocation, OfAMesh_EachInTurn_MadeUpForLater) {
  dgd_bullet::Options options = Counting();
  options.on_first_fallback = nullptr;
  btTriangleMesh triangles;
  AddGrid(triangles, 6, 0.3, [](double x, double y) { return 0.5 + 0.1 * x * y; });
  btBvhTriangleMeshShape mesh(&triangles, true);
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  Dispatching undisturbed(Route::kConfiguration, options);
  BarePair expected(undisturbed.dispatcher(), box, mesh);
  for (int step = 0; step < 6; ++step) expected.Step();
  ASSERT_GT(expected.Manifold().getNumContacts(), 0);
  long n = 0;
  for (bool is_over = true; is_over; ++n) {
    Dispatching dispatching(Route::kConfiguration, options);
    BarePair pair(dispatching.dispatcher(), box, mesh);
    {
      const MemoryForSome memory(n);
      for (int step = 0; step < 3; ++step) pair.Step();
      is_over = memory.IsOver();
    }
    for (int step = 0; step < 3; ++step) pair.Step();
    ASSERT_EQ(pair.Manifold().getNumContacts(), expected.Manifold().getNumContacts()) << n;
  }
  EXPECT_GT(n, 3) << "what is kept of triangles needs memory";
}

// Once a body has been on a mesh for some steps, in which a hull gets its facets, it needs no more memory.
TEST(SteadyScene, BodiesOnAMesh_AllocateNothing) {
  btTriangleMesh triangles;
  AddGrid(triangles, 10, 0.3, [](double x, double y) { return 0.05 * std::sin(3 * x + 2 * y); });
  btBvhTriangleMeshShape mesh(&triangles, true);
  for (const ZooShape& shape : MakeShapeZoo(0.9)) {
    SCOPED_TRACE(shape.name);
    Dispatching dispatching(Route::kConfiguration);
    BarePair pair(dispatching.dispatcher(), *shape.shape, mesh);
    for (int step = 0; step < 60; ++step) pair.Step();
    const long before = allocations_made;
    for (int step = 0; step < 20; ++step) pair.Step();
    EXPECT_EQ(allocations_made, before);
  }
}

}  // namespace
}  // namespace dgd_test
