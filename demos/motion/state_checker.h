// Whether an arm collides in a configuration, as fast as a sampling planner wants it: yes or no, and no distances.
//
// Of each pair the plane that separated it last is tried first. Where it does not, dgd::DetectCollision decides, and
// its plane is the next one to be tried.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/collision_model.h"
#include "motion/plane_cache.h"

namespace dgd_demos {

struct CheckCounts {
  std::int64_t states = 0;
  std::int64_t pairs = 0;           ///< Pair checks of these states; a state's first collision ends it.
  std::int64_t pairs_by_plane = 0;  ///< Of these, decided by the pair's last separating plane.
};

/// Not for use by several threads at once.
class StateChecker {
 public:
  /// What is tried before dgd::DetectCollision; each value includes those before it. All but the last are there to be
  /// compared with: plan_motion --compare times them.
  enum class Shortcuts {
    kNone,
    kNearestPoints,  ///< A plane between nearly nearest points: a cold check.
    kCachedPlanes,   ///< Before that, the plane that separated the pair last.
  };

  /// @param model  Must outlive the checker.
  explicit StateChecker(const CollisionModel& model, Shortcuts shortcuts = Shortcuts::kCachedPlanes)
      : model_(model), shortcuts_(shortcuts), planes_(model) {}

  /// The first pair that collides, as its index in model.pairs(); nothing if the state is valid. Touching counts as
  /// colliding, and so does what cannot be decided.
  std::optional<std::size_t> FindCollision(const Configuration& configuration);
  /// The same for poses that are known: of CollisionModel::ComputePoses().
  std::optional<std::size_t> FindCollision(const CollisionModel::Poses& poses);

  const CheckCounts& counts() const { return counts_; }

 private:
  bool IsApart(std::size_t pair, const CollisionModel::Poses& poses);
  /// The normal of a plane that separates the pair, if one is found at once: across the line from a point of the first
  /// body's axis to one of the second's, or of a box, after one round of alternating projections from the first's
  /// origin.
  std::optional<Eigen::Vector3d> NormalBetweenNearestPoints(std::size_t pair, const CollisionModel::Poses& poses) const;

  const CollisionModel& model_;
  const Shortcuts shortcuts_;
  PlaneCache planes_;
  CollisionModel::Poses poses_;
  CheckCounts counts_;
};

}  // namespace dgd_demos
