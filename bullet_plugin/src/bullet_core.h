// Any convex Bullet shape through its own virtual support function: multi-spheres, scaled shapes, users' shapes.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <array>

#include "bullet_conversions.h"
#include "dgd/convex_hull.h"
#include "dgd/convex_set.h"
#include "dgd/supporting_face.h"

namespace dgd_bullet {

/// Keeps nothing of the shape from one query to the next, so that it cannot be out of date.
class BulletCore {
 public:
  using Scalar = double;

  /// The centre is the mean of the support points along the axes. An inradius is only computed for shapes without a
  /// margin, from the hull of those points: with one, the solver needs none.
  explicit BulletCore(const btConvexShape& shape) : shape_(&shape) {
    std::array<Vector3, 6> extremes;
    for (std::size_t i = 0; i < extremes.size(); ++i) {
      Vector3 direction = Vector3::Zero();
      direction[static_cast<Eigen::Index>(i / 2)] = i % 2 == 0 ? 1 : -1;
      extremes[i] = Support(direction).point;
      center_ += extremes[i] / double(extremes.size());
    }
    if (!(shape.getMargin() > 0)) {
      const dgd::ConvexHull hull = dgd::BuildConvexHull(extremes);
      center_ = hull.center;
      inradius_ = hull.inradius;
    }
  }

  dgd::SupportPoint<double> Support(const Vector3& direction) const {
    return {FromBullet(shape_->localGetSupportingVertexWithoutMargin(ToBullet(direction)))};
  }
  const Vector3& Center() const { return center_; }
  double Inradius() const { return inradius_; }

  /// Nothing is known of its faces.
  void SupportFace(const Vector3& direction, dgd::SupportingFace<double>& face) const {
    face.Add(Support(direction).point);
  }

 private:
  const btConvexShape* shape_;
  Vector3 center_ = Vector3::Zero();
  double inradius_ = 0;
};

}  // namespace dgd_bullet
