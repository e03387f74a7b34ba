#include "dispatch/shape_versions.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <cstddef>
#include <cstring>

#include "pair/separating_axis.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

bool IsHull(const btCollisionShape& shape) { return shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE; }

/// Half the diagonal of a box about the origin that contains the core.
btScalar CoreRadius(const btConvexShape& shape) {
  btVector3 corner(0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    btVector3 direction(0, 0, 0);
    for (const btScalar sign : {btScalar(-1), btScalar(1)}) {
      direction[axis] = sign;
      corner[axis] = btMax(corner[axis], btFabs(shape.localGetSupportVertexWithoutMarginNonVirtual(direction)[axis]));
    }
  }
  // The axis is tried on the whole of a box.
  const btScalar margin = shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? btFabs(shape.getMargin()) : 0;
  return (corner + btVector3(margin, margin, margin)).length();
}

}  // namespace

std::optional<ShapeVersions::Content> ShapeVersions::Content::Of(const btCollisionShape& shape) {
  switch (shape.getShapeType()) {
    case CONVEX_HULL_SHAPE_PROXYTYPE: {
      const auto& hull = static_cast<const btConvexHullShape&>(shape);
      const int count = hull.getNumPoints();
      if (count < 1 || count > kMaxScannedPoints) return std::nullopt;
      const btVector3* points = hull.getUnscaledPoints();
      return Content{ShapeIdentity(shape), {points, points + count}, hull.getLocalScalingNV()};
    }
    case BOX_SHAPE_PROXYTYPE:
    case SPHERE_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE:
    case CONE_SHAPE_PROXYTYPE:
      return Content{ShapeIdentity(shape), {}, btVector3(0, 0, 0)};
    default:
      return std::nullopt;
  }
}

bool ShapeVersions::Content::Matches(const btCollisionShape& shape) const {
  if (!IsHull(shape)) return points.empty() && identity.Matches(shape, nullptr);
  const auto& hull = static_cast<const btConvexHullShape&>(shape);
  const auto count = static_cast<std::size_t>(hull.getNumPoints());
  return count == points.size() && hull.getLocalScalingNV() == scaling && identity.HasMarginOf(shape) &&
         std::memcmp(points.data(), hull.getUnscaledPoints(), count * sizeof(btVector3)) == 0;
}

ShapeVersion ShapeVersions::Find(const btCollisionShape& shape) {
  Known& known = shapes_[&shape];
  if (known.dispatch == dispatch_) return known.version;
  known.dispatch = dispatch_;
  ++met_;
  if (known.content && known.content->Matches(shape)) return known.version;
  known.content = Content::Of(shape);
  known.version = {};
  if (known.content) known.version = {++last_number_, CoreRadius(static_cast<const btConvexShape&>(shape))};
  return known.version;
}

void ShapeVersions::EndDispatch() {
  constexpr std::size_t kFew = 64;
  if (shapes_.size() > 2 * met_ + kFew) {
    std::erase_if(shapes_, [this](const auto& entry) { return entry.second.dispatch != dispatch_; });
  }
  met_ = 0;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
