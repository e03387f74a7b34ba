// Boolean collision checks of the pairs of a CollisionModel by other libraries, for comparison.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "motion/collision_model.h"

namespace dgd_demos {

class PairChecker {
 public:
  virtual ~PairChecker() = default;
  virtual std::string Name() const = 0;
  /// @param poses  Of CollisionModel::ComputePoses().
  virtual void SetPoses(const CollisionModel::Poses& poses) = 0;
  /// Whether the two bodies overlap, in the poses that were set last.
  /// @param pair  Index in CollisionModel::pairs().
  virtual bool Collides(std::size_t pair) = 0;
};

/// fcl::collide() with FCL's default solver, in double, without contacts. The model must outlive it.
std::unique_ptr<PairChecker> MakeFclChecker(const CollisionModel& model);
/// btCollisionWorld::contactPairTest() on Bullet's own narrowphase, in the precision of the library that is linked.
std::unique_ptr<PairChecker> MakeBulletChecker(const CollisionModel& model);

}  // namespace dgd_demos
