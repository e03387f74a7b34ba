#include "mesh/triangle_pairs.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <algorithm>
#include <new>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

void Destroy(btDispatcher& dispatcher, btCollisionAlgorithm* algorithm) {
  algorithm->~btCollisionAlgorithm();
  dispatcher.freeCollisionAlgorithm(algorithm);
}

TrianglePairs::~TrianglePairs() {
  for (const Pair& pair : pairs_) Destroy(dispatcher_, pair.algorithm);
}

btCollisionAlgorithm* TrianglePairs::Find(int part, int index) {
  // Triangles that were near in the last step and are not any more. A body that leaves more at once is moved by an app.
  constexpr std::size_t kMaxLeft = 32;
  DGD_ASSERT(next_ <= pairs_.size());
  const std::size_t end = std::min(next_ + kMaxLeft, pairs_.size());
  for (std::size_t i = next_; i < end; ++i) {
    Pair& pair = pairs_[i];
    if (pair.index != index || pair.part != part) continue;
    pair.is_near = true;
    next_ = i + 1;
    return pair.algorithm;
  }
  return nullptr;
}

bool TrianglePairs::Insert(int part, int index, btCollisionAlgorithm* algorithm) try {
  DGD_ASSERT(algorithm != nullptr && next_ <= pairs_.size());
  pairs_.insert(pairs_.begin() + static_cast<std::ptrdiff_t>(next_), {part, index, algorithm, true});
  ++next_;
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

void TrianglePairs::EndStep() {
  next_ = 0;
  std::size_t kept = 0;
  for (Pair& pair : pairs_) {
    if (pair.is_near) {
      pair.is_near = false;
      pairs_[kept++] = pair;
    } else {
      Destroy(dispatcher_, pair.algorithm);
    }
  }
  pairs_.resize(kept);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
