// The last separating plane of each pair of bodies: most pairs that were apart in one state are so in the next, and a
// plane proves it by a single evaluation of a support function.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "motion/collision_model.h"

namespace dgd_demos {

/// A plane touches the second body of its pair from the side of the first one. It is stored in the second body's frame,
/// or in the world if that body is fixed, so that only the first body's support function has to be evaluated.
class PlaneCache {
 public:
  /// A plane proves bodies apart if it separates them by more than this, which is some epsilons of 1e3 m; m.
  static constexpr double kRoundoff = 1e-12;

  /// @param model  Must outlive the cache.
  explicit PlaneCache(const CollisionModel& model) : model_(model), planes_(model.pairs().size()) {}

  /// Whether the pair's plane keeps the bodies farther apart than `margin`, in m. False if it has none.
  bool Separates(std::size_t pair, const CollisionModel::Poses& poses, double margin) const {
    const Plane& plane = planes_[pair];
    if (!plane.is_set) return false;
    const auto [first, second] = model_.pairs()[pair];
    const ConvexBody& body = model_.parts()[first].body;
    const double limit = plane.offset - margin - kRoundoff;
    if (!model_.parts()[second].link) return body.SupportValue(poses[first], plane.normal) < limit;
    const Eigen::Vector3d normal = poses[second].rotation * plane.normal;
    return body.SupportValue(poses[first], normal) - normal.dot(poses[second].translation) < limit;
  }

  /// Stores the plane across a normal that separates the pair in these poses.
  /// @param normal  From the first body to the second; world, unit length.
  void Store(std::size_t pair, const CollisionModel::Poses& poses, const Eigen::Vector3d& normal) {
    Plane& plane = planes_[pair];
    const std::size_t second = model_.pairs()[pair].second;
    const CollisionModel::Part& part = model_.parts()[second];
    plane.is_set = true;
    plane.normal = normal;
    plane.offset = -part.body.SupportValue(poses[second], -normal);
    if (!part.link) return;
    plane.normal = poses[second].rotation.transpose() * normal;
    plane.offset -= normal.dot(poses[second].translation);
  }

 private:
  struct Plane {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double offset = 0;  ///< Of the second body's side: <normal, x> >= offset there, m.
    bool is_set = false;
  };
  const CollisionModel& model_;
  std::vector<Plane> planes_;  ///< Of each pair.
};

}  // namespace dgd_demos
