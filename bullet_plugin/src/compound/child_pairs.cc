#include "compound/child_pairs.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <new>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

void Destroy(btDispatcher& dispatcher, btCollisionAlgorithm* algorithm) {
  algorithm->~btCollisionAlgorithm();
  dispatcher.freeCollisionAlgorithm(algorithm);
}

btCollisionAlgorithm* ChildPairs::Find(int child, int other_child) {
  DGD_ASSERT(next_ <= pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const std::size_t place = (next_ + i) % pairs_.size();
    Pair& pair = pairs_[place];
    if (pair.child != child || pair.other_child != other_child) continue;
    if (pair.step != step_) ++near_;
    pair.step = step_;
    next_ = place + 1;
    return pair.algorithm;
  }
  return nullptr;
}

bool ChildPairs::Insert(int child, int other_child, btCollisionAlgorithm* algorithm) try {
  DGD_ASSERT(algorithm != nullptr && next_ <= pairs_.size());
  pairs_.insert(pairs_.begin() + static_cast<std::ptrdiff_t>(next_), {child, other_child, algorithm, step_});
  ++next_;
  ++near_;
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

void ChildPairs::EndStep() {
  DGD_ASSERT(near_ <= pairs_.size());
  if (near_ < pairs_.size()) {
    std::erase_if(pairs_, [&](const Pair& pair) {
      if (pair.step == step_) return false;
      Destroy(dispatcher_, pair.algorithm);
      return true;
    });
  }
  ++step_;
  next_ = near_ = 0;
}

void ChildPairs::Clear() {
  for (const Pair& pair : pairs_) Destroy(dispatcher_, pair.algorithm);
  pairs_.clear();
  next_ = near_ = 0;
}

void ChildPairs::AppendManifolds(btAlignedObjectArray<btPersistentManifold*>& manifolds) const {
  for (const Pair& pair : pairs_) pair.algorithm->getAllContactManifolds(manifolds);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
