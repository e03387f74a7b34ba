// What may collide while an arm moves: its links' shapes, the fixed bodies around it, and the pairs that are checked.
#pragma once

#include <dgd/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "motion/arm.h"
#include "motion/convex_body.h"
#include "motion/motion_scene.h"

namespace dgd_demos {

/// Indices of two bodies. The first is a link's; the second is another link's, or fixed.
struct CheckedPair {
  std::size_t first, second;
};

class CollisionModel {
 public:
  struct Part {
    ConvexBody body;
    std::optional<std::size_t> link;  ///< Index of the planned arm's link; nothing for fixed bodies.
    Pose pose;                        ///< In the link's frame; of fixed bodies in the world.
  };
  using Poses = std::vector<dgd::Pose<double>>;

  /// The shapes of all arms but the planned one are fixed, at their configuration of rest; so are the obstacles.
  explicit CollisionModel(const MotionScene& scene);

  const Arm& arm() const { return arm_; }
  const std::vector<Part>& parts() const { return parts_; }
  /// Outer links first, which collide most often: what is found to collide needs no further check.
  const std::vector<CheckedPair>& pairs() const { return pairs_; }
  std::string NameOf(const CheckedPair& pair) const;  ///< "forearm and left_post"

  /// Poses of all parts in the world.
  /// @param poses  In and out: what the last call left, or empty. Fixed parts are set only once.
  void ComputePoses(const Configuration& configuration, Poses& poses) const;

 private:
  Arm arm_;
  std::vector<Part> parts_;  ///< Links first, then fixed ones.
  std::vector<CheckedPair> pairs_;
};

}  // namespace dgd_demos
