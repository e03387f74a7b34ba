#include "compound/child_pairs.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>

#include <new>

#include "dgd/assert.h"
#include "mesh/triangle_pairs.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

btCollisionAlgorithm* ChildPairs::Find(int child, int other_child) {
  DGD_ASSERT(next_ <= pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const std::size_t place = (next_ + i) % pairs_.size();
    Pair& pair = pairs_[place];
    if (pair.child != child || pair.other_child != other_child) continue;
    pair.is_near = true;
    next_ = place + 1;
    return pair.algorithm;
  }
  return nullptr;
}

bool ChildPairs::Insert(int child, int other_child, btCollisionAlgorithm* algorithm) try {
  DGD_ASSERT(algorithm != nullptr && next_ <= pairs_.size());
  pairs_.insert(pairs_.begin() + static_cast<std::ptrdiff_t>(next_), {child, other_child, algorithm, true});
  ++next_;
  return true;
} catch (const std::bad_alloc&) {
  return false;
}

void ChildPairs::EndStep() {
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

void ChildPairs::Clear() {
  for (const Pair& pair : pairs_) Destroy(dispatcher_, pair.algorithm);
  pairs_.clear();
  next_ = 0;
}

void ChildPairs::AppendManifolds(btAlignedObjectArray<btPersistentManifold*>& manifolds) const {
  for (const Pair& pair : pairs_) pair.algorithm->getAllContactManifolds(manifolds);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
