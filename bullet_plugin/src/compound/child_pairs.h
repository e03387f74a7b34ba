// The algorithms of the pairs of children of two bodies that are near each other, cached from step to step.
#pragma once

#include <LinearMath/btAlignedObjectArray.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dgd_bullet/linkage.h"

class btCollisionAlgorithm;
class btDispatcher;
class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Destroys an algorithm that came from a dispatcher.
void Destroy(btDispatcher& dispatcher, btCollisionAlgorithm* algorithm);

/// Children are visited in nearly the same order in each step, so each pair is searched from behind the one before.
class ChildPairs {
 public:
  /// @param dispatcher  The algorithms' own, which frees them.
  explicit ChildPairs(btDispatcher& dispatcher) : dispatcher_(dispatcher) {}
  ~ChildPairs() { Clear(); }
  ChildPairs(const ChildPairs&) = delete;
  ChildPairs& operator=(const ChildPairs&) = delete;

  /// The algorithm of a pair that was near in the last step, or nullptr.
  btCollisionAlgorithm* Find(int child, int other_child);

  /// Caches the algorithm of the pair that was searched last.
  /// @return false if there is no memory: the algorithm stays the caller's.
  bool Insert(int child, int other_child, btCollisionAlgorithm* algorithm);

  /// Destroys the algorithms of all pairs that were neither found nor inserted in this step.
  void EndStep();
  /// Destroys all.
  void Clear();

  void AppendManifolds(btAlignedObjectArray<btPersistentManifold*>& manifolds) const;

 private:
  struct Pair {
    int child, other_child;
    btCollisionAlgorithm* algorithm;
    std::uint32_t step;  // The last one in which it was found or inserted.
  };

  btDispatcher& dispatcher_;
  std::vector<Pair> pairs_;  // Pairs in the order in which they are visited.
  std::size_t next_ = 0;     // The place behind the last one that was found or inserted.
  std::size_t near_ = 0;     // How many have been in this step.
  std::uint32_t step_ = 0;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
