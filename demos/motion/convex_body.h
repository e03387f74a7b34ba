// A convex collision shape as the growth distance takes it, with its support function in closed form.
#pragma once

#include <dgd/any_set.h>
#include <dgd/types.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "scene/pose.h"
#include "scene/shape.h"

namespace dgd_demos {

inline dgd::Pose<double> ToDgd(const Pose& pose) { return {pose.rotation, pose.position}; }

class ConvexBody {
 public:
  /// @param name  For messages: "forearm", "left_post".
  ConvexBody(std::string name, const Shape& shape);

  const std::string& name() const { return name_; }
  const Shape& shape() const { return shape_; }
  const dgd::AnySet& set() const { return set_; }

  /// The largest <normal, x> over the body in this pose. Without a visit of dgd::AnySet, which would take longer than
  /// the sums themselves.
  /// @param normal  Unit length, world.
  double SupportValue(const dgd::Pose<double>& pose, const Eigen::Vector3d& normal) const {
    const double origin = normal.dot(pose.translation);
    switch (kind_) {
      case Kind::kAxial: {
        // A disc swept along z, and a ball around it: capsules, spheres and cylinders.
        const double along = normal.dot(pose.rotation.col(2));
        const double across = std::sqrt(std::max(0.0, 1 - along * along));
        return origin + half_extents_.z() * std::abs(along) + half_extents_.x() * across + radius_;
      }
      case Kind::kBox:
        return origin + half_extents_.dot((pose.rotation.transpose() * normal).cwiseAbs());
      case Kind::kOther:
        break;
    }
    const Eigen::Vector3d local = pose.rotation.transpose() * normal;
    return origin + local.dot(set_.CoreSupport(local)) + radius_;
  }

 private:
  enum class Kind { kAxial, kBox, kOther };

  std::string name_;
  Shape shape_;
  std::unique_ptr<dgd::Polytope<double>> polytope_;  // What set_ refers to, for hulls.
  dgd::AnySet set_;
  Kind kind_ = Kind::kOther;
  Eigen::Vector3d half_extents_ = Eigen::Vector3d::Zero();  // Of the box; x and z: disc radius and half length.
  double radius_ = 0;                                       // Of the ball.
};

}  // namespace dgd_demos
