// The algorithms of a convex body and the triangles of a mesh that it is near, kept from step to step.
//
// Bullet makes each anew in every step, so that a triangle's answer never starts from the last one. Kept, two in three
// triangles that a body's bounding box reaches are told to be still apart along the last normal, and the others'
// contacts are followed.
#pragma once

#include <cstddef>
#include <vector>

#include "dgd_bullet/linkage.h"

class btCollisionAlgorithm;
class btDispatcher;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A mesh visits its triangles in the same order in each step, so each is looked for behind the one before, and not
/// far. One that is missed, or taken for another, costs its algorithm time and no more: what that remembers are hints.
class TrianglePairs {
 public:
  /// @param dispatcher  Of the algorithms, to which they are given back.
  explicit TrianglePairs(btDispatcher& dispatcher) : dispatcher_(dispatcher) {}
  ~TrianglePairs();
  TrianglePairs(const TrianglePairs&) = delete;
  TrianglePairs& operator=(const TrianglePairs&) = delete;

  /// The algorithm of a triangle that was near in the last step, or nullptr.
  /// @param part, index  Bullet's names of the triangle; two may share them, as the halves of a heightfield's squares.
  btCollisionAlgorithm* Find(int part, int index);

  /// Keeps the algorithm of the triangle that was looked for last.
  /// @return false if there is no memory: the algorithm stays the caller's.
  bool Keep(int part, int index, btCollisionAlgorithm* algorithm);

  /// Gives back the algorithms of all triangles that were neither found nor kept in this step.
  void EndStep();

 private:
  struct Pair {
    int part, index;
    btCollisionAlgorithm* algorithm;
    bool is_near;  // In this step.
  };

  btDispatcher& dispatcher_;
  std::vector<Pair> pairs_;  // As the mesh visits them.
  std::size_t next_ = 0;     // Behind the last one that was found or kept.
};

/// Ends an algorithm that came from a dispatcher.
void GiveBack(btDispatcher& dispatcher, btCollisionAlgorithm* algorithm);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
