// Hulls of Bullet's point shapes: built once per shape, shared between its pairs, found again by address and content.
//
// Bullet tells nobody when a shape changes or dies, and a new one may take its address. A hull is therefore only used
// after its shape has been compared with what the hull was made from: number of points, scaling, and every point, which
// costs less than one evaluation of the support function that looks at all of them.
#pragma once

#include <cstddef>
#include <memory>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

#include "bullet_conversions.h"
#include "dgd/shapes/polytope.h"
#include "dgd_bullet/linkage.h"
#include "shape_points.h"

class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class CachedHull {
 public:
  /// Throws std::invalid_argument if the shape has no points or one is not finite.
  explicit CachedHull(const btConvexShape& shape);

  /// Whether this was made from the shape as it is now.
  bool Matches(const btConvexShape& shape) const;

  const dgd::Polytope<double>& Core() const { return core_; }

  /// Has memory bring what a query of a small hull reads: which facet is under a contact takes six reads that each tell
  /// where the next is. A tenth of the narrowphase's time in a heap of 2000 hulls.
  void Prefetch() const;

 private:
  const btConvexShape* shape_;
  int count_;
  btVector3 scaling_;
  std::vector<unsigned char> bytes_;  // The points as they lie in memory, where they are an array ...
  std::vector<Vector3> points_;       // ... else each of them, scaled.
  dgd::Polytope<double> core_;
};

class HullCache {
 public:
  /// The hull of the shape as it is now. Thread-safe, and without a lock if this thread has found it before: pairs that
  /// live for a step, of children of meshes and compounds, ask anew each time. Throws as CachedHull.
  std::shared_ptr<const CachedHull> Find(const btConvexShape& shape);

 private:
  std::shared_ptr<const CachedHull> FindShared(const btConvexShape& shape);

  /// Drops hulls that no pair holds once there are twice as many as after the last time: shapes that are gone cost
  /// memory for a while, never a wrong answer.
  void Prune();

  std::shared_mutex mutex_;
  std::unordered_map<const btConvexShape*, std::shared_ptr<const CachedHull>> hulls_;
  std::size_t prune_at_ = 64;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
