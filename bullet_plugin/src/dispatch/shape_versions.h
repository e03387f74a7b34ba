// Numbers for the content of shapes, by which a dispatcher sees that a shape has changed.
#pragma once

#include <LinearMath/btVector3.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "dgd_bullet/linkage.h"
#include "shapes/shape_identity.h"

class btCollisionShape;
class btConvexHullShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A shape as it is.
struct ShapeVersion {
  /// Two shapes of the same number have the same content; 0 for shapes that cannot be compared, and those for which the
  /// cached axis is not tried (pipeline/separating_axis.h).
  std::uint32_t number = 0;
  btScalar core_radius = 0;  ///< No point of the core, without its margin, is farther from its origin; metres.
};

/// The shapes of a dispatch. Bullet reports to nobody when a shape changes: each is compared once a dispatch with what
/// it was in the last one, not once a pair.
class ShapeVersions {
 public:
  void BeginDispatch() { ++dispatch_; }
  /// Drops shapes that have not been met in this dispatch, once they are most of all.
  void EndDispatch();

  ShapeVersion Find(const btCollisionShape& shape);

 private:
  struct Content {
    /// Nothing if the shape cannot be compared.
    static std::optional<Content> Of(const btCollisionShape& shape);
    bool Matches(const btCollisionShape& shape) const;

    ShapeIdentity identity;
    std::vector<btVector3> points;  // Of a hull, unscaled.
    btVector3 scaling;
  };
  struct Known {
    std::optional<Content> content;
    ShapeVersion version;
    std::uint32_t dispatch = 0;  // In which it was compared.
  };

  std::unordered_map<const btCollisionShape*, Known> shapes_;
  std::uint32_t dispatch_ = 0, last_number_ = 0;
  std::size_t met_ = 0;  // In this dispatch.
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
