// The algorithms of a convex body and the triangles of a mesh that it is near, cached from step to step.
//
// Bullet makes each from scratch in every step, so that a triangle's query never starts from the last one. Cached, two
// in three triangles that a body's bounding box reaches are found to be still apart along the last normal, and the
// others' contacts are updated.
#pragma once

#include <cstddef>
#include <vector>

#include "dgd_bullet/linkage.h"

class btCollisionAlgorithm;
class btDispatcher;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A mesh visits its triangles in the same order in each step, so each is searched behind the one before, and not far.
/// One that is missed, or taken for another, costs its algorithm time and no more: what that caches are hints.
class TrianglePairs {
 public:
  /// @param dispatcher  The algorithms' own, which frees them.
  explicit TrianglePairs(btDispatcher& dispatcher) : dispatcher_(dispatcher) {}
  ~TrianglePairs();
  TrianglePairs(const TrianglePairs&) = delete;
  TrianglePairs& operator=(const TrianglePairs&) = delete;

  /// The algorithm of a triangle that was near in the last step, or nullptr.
  /// @param part, index  Bullet's names of the triangle; two may share them, as the halves of a heightfield's squares.
  btCollisionAlgorithm* Find(int part, int index);

  /// Caches the algorithm of the triangle that was searched last.
  /// @return false if there is no memory: the algorithm stays the caller's.
  bool Insert(int part, int index, btCollisionAlgorithm* algorithm);

  /// Destroys the algorithms of all triangles that were neither found nor inserted in this step.
  void EndStep();

 private:
  struct Pair {
    int part, index;
    btCollisionAlgorithm* algorithm;
    bool is_near;  // Whether it was found or inserted in this step.
  };

  btDispatcher& dispatcher_;
  std::vector<Pair> pairs_;  // Pairs in the order in which the mesh visits them.
  std::size_t next_ = 0;     // The place behind the last one that was found or inserted.
};

/// Destroys an algorithm that came from a dispatcher.
void Destroy(btDispatcher& dispatcher, btCollisionAlgorithm* algorithm);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
