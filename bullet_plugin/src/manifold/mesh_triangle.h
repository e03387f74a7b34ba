// A triangle of a mesh.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <array>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct MeshTriangle {
  std::array<btVector3, 3> corners;  ///< Corners in the mesh's frame, scaled; metres.
  int part, index;                   ///< Bullet's numbers of it. The halves of a heightfield's squares share them.
};

/// A triangle as a shape of its own, with the mesh's margin, where the mesh is.
class TriangleBody {
 public:
  TriangleBody(const MeshTriangle& triangle, const btCollisionObjectWrapper& mesh)
      : shape_(triangle.corners[0], triangle.corners[1], triangle.corners[2]),
        wrapper_(&mesh, &shape_, mesh.getCollisionObject(), mesh.getWorldTransform(), triangle.part, triangle.index) {
    shape_.setMargin(mesh.getCollisionShape()->getMargin());
  }
  TriangleBody(const TriangleBody&) = delete;
  TriangleBody& operator=(const TriangleBody&) = delete;

  const btTriangleShape& shape() const { return shape_; }
  const btCollisionObjectWrapper& wrapper() const { return wrapper_; }

 private:
  btTriangleShape shape_;
  btCollisionObjectWrapper wrapper_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
