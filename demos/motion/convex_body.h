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
      case Kind::kSegment:
        return origin + half_extents_.z() * std::abs(normal.dot(pose.rotation.col(2))) + radius_;
      case Kind::kCylinder: {
        const double along = normal.dot(pose.rotation.col(2));
        const double across = std::sqrt(std::max(0.0, 1 - along * along));
        return origin + half_extents_.z() * std::abs(along) + half_extents_.x() * across;
      }
      case Kind::kBox:
        return origin + half_extents_.dot((pose.rotation.transpose() * normal).cwiseAbs());
      case Kind::kHull: {
        const Eigen::Vector3d local = pose.rotation.transpose() * normal;
        return origin + local.dot(polytope_->Support(local).point);
      }
      case Kind::kOther:
        break;
    }
    const Eigen::Vector3d local = pose.rotation.transpose() * normal;
    return origin + local.dot(set_.CoreSupport(local)) + radius_;
  }

  /// The point of the body's axis, or of the box, that is nearest to a point; the origin of other shapes.
  /// @param point  World, as is the result; m.
  Eigen::Vector3d NearestInside(const dgd::Pose<double>& pose, const Eigen::Vector3d& point) const {
    if (kind_ == Kind::kSegment || kind_ == Kind::kCylinder) {
      const double along = pose.rotation.col(2).dot(point - pose.translation);
      return pose.translation + std::clamp(along, -half_extents_.z(), half_extents_.z()) * pose.rotation.col(2);
    }
    if (kind_ != Kind::kBox) return pose.translation;
    const Eigen::Vector3d local = pose.rotation.transpose() * (point - pose.translation);
    return pose * Eigen::Vector3d(local.cwiseMax(-half_extents_).cwiseMin(half_extents_));
  }

 private:
  enum class Kind { kSegment, kCylinder, kBox, kHull, kOther };

  std::string name_;
  Shape shape_;
  std::unique_ptr<dgd::Polytope<double>> polytope_;  // What set_ refers to, for hulls.
  dgd::AnySet set_;
  Kind kind_ = Kind::kOther;
  Eigen::Vector3d half_extents_ = Eigen::Vector3d::Zero();  // Of the box; x and z of a cylinder: radius, half height.
  double radius_ = 0;                                       // Of the ball.
};

}  // namespace dgd_demos
