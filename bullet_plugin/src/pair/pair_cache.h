// What one query of two convex shapes leaves for the next one.
#pragma once

#include <memory>
#include <utility>

#include "dgd/assert.h"
#include "dgd/query_types.h"
#include "dgd_bullet/linkage.h"
#include "shapes/hull_cache.h"
#include "solver_types.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The warm start of the pair's growth distance and the shapes' hulls, in the order that the shapes are solved in
/// (ComesBefore()). A cache that does not fit the shapes any more costs time, and no result is wrong.
class PairCache {
 public:
  using Hull = std::shared_ptr<const CachedHull>;

  bool HasNormal() const { return dgd::HasNormal(warm_start_); }
  /// The last normal in shape A's frame; unit, if HasNormal().
  const Vector3& NormalInA() const {
    DGD_ASSERT(HasNormal());
    return warm_start_.normal_1;
  }
  dgd::WarmStart<double>& warm_start() { return warm_start_; }

  /// Forgets everything but the hulls.
  void Clear() { warm_start_ = {}; }

  /// Whether the shapes are solved in the other order than Bullet's.
  bool IsSwapped() const { return is_swapped_; }
  /// Exchanges the roles of A and B.
  /// @param pose_a, pose_b  Poses of the sets, in the new order.
  void SwapOrder(const Pose& pose_a, const Pose& pose_b) {
    is_swapped_ = !is_swapped_;
    std::swap(hull_a_, hull_b_);
    std::swap(warm_start_.features_1, warm_start_.features_2);
    warm_start_.normal_1 = (-pose_a.rotation.transpose() * (pose_b.rotation * warm_start_.normal_1)).normalized();
  }

  Hull& hull_a() { return hull_a_; }
  Hull& hull_b() { return hull_b_; }

 private:
  bool is_swapped_ = false;
  Hull hull_a_, hull_b_;
  dgd::WarmStart<double> warm_start_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
