// No query allocates: counts what goes through operator new and, by the linker's --wrap, through malloc and its kin,
// which Eigen calls directly.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <variant>

#include "dgd/gradient.h"
#include "support/random_sets.h"
#include "support/solver_pair.h"

namespace {
std::atomic<long> allocations{0};
}

// NOLINTBEGIN(bugprone-reserved-identifier): what the linker's --wrap calls them.
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* old, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** result, std::size_t alignment, std::size_t size);

void* __wrap_malloc(std::size_t size) { return ++allocations, __real_malloc(size); }
void* __wrap_calloc(std::size_t count, std::size_t size) { return ++allocations, __real_calloc(count, size); }
void* __wrap_realloc(void* old, std::size_t size) { return ++allocations, __real_realloc(old, size); }
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  return ++allocations, __real_aligned_alloc(alignment, size);
}
int __wrap_posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  return ++allocations, __real_posix_memalign(result, alignment, size);
}
}
// NOLINTEND(bugprone-reserved-identifier)

void* operator new(std::size_t size) {
  ++allocations;
  void* memory = __real_malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
// Not inlined: g++ would see memory of operator new go to free(), and warn of that.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace dgd_test {
namespace {

TEST(Allocation, Counter_SeesNewAndMalloc) {
  long before = allocations;
  int* volatile number = new int(1);
  delete number;
  EXPECT_GT(allocations, before);
  before = allocations;
  void* volatile memory = std::malloc(8);
  std::free(memory);
  EXPECT_GT(allocations, before);
  before = allocations;
  const Eigen::VectorXd dynamic = Eigen::VectorXd::Zero(7);
  const double* volatile data = dynamic.data();
  EXPECT_GT(allocations, before);
  EXPECT_NE(data, nullptr);
}

template <class S>
void CountInQueries() {
  Random random(TestSeed());
  for (const CoreType type_1 : kCoreTypes) {
    for (const CoreType type_2 : kCoreTypes) {
      for (int rounded = 0; rounded < 4; ++rounded) {
        const ReferencePair reference = RandomPair(random, type_1, (rounded & 1) != 0, type_2, (rounded & 2) != 0);
        const SolverPair<S> pair(reference);
        dgd::WarmStart<S> warm_start;
        const long before = allocations;
        const dgd::Result<S> cold = pair.GrowthDistance();
        (void)pair.GrowthDistance({}, &warm_start);
        (void)pair.GrowthDistance({}, &warm_start);
        (void)pair.DetectCollision();
        (void)pair.DetectCollision({}, &warm_start);
        (void)pair.GrowthDistance({.max_iterations = 1});
        (void)pair.GrowthDistance({.separation_limit = S(1e-3)});
        (void)pair.Certify(cold);
        std::visit([&](const auto& a,
                       const auto& b) { (void)dgd::GrowthDistanceGradient(a, pair.pose_1, b, pair.pose_2, cold); },
                   pair.set_1, pair.set_2);
        EXPECT_EQ(allocations, before) << Name(type_1) << " " << Name(type_2) << " " << rounded;
      }
    }
  }
}

TEST(Allocation, Queries_AllocateNothingInDouble) { CountInQueries<double>(); }
TEST(Allocation, Queries_AllocateNothingInFloat) { CountInQueries<float>(); }

}  // namespace
}  // namespace dgd_test
