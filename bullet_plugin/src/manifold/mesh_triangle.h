// A triangle of a mesh, and how it takes the mesh's place in a result of Bullet: by that an app's callbacks identify
// the triangle of a contact, as btAdjustInternalEdgeContacts() needs it.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
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

/// Puts a triangle in the place of its mesh in a result, as long as this lives.
class BoundTriangle {
 public:
  BoundTriangle(btManifoldResult& output, const btCollisionObjectWrapper& triangle)
      : output_(output), is_first_(output.getBody0Internal() == triangle.getCollisionObject()) {
    mesh_ = is_first_ ? output.getBody0Wrap() : output.getBody1Wrap();
    Bind(&triangle);
    if (is_first_) {
      output.setShapeIdentifiersA(triangle.m_partId, triangle.m_index);
    } else {
      output.setShapeIdentifiersB(triangle.m_partId, triangle.m_index);
    }
  }
  ~BoundTriangle() { Bind(mesh_); }
  BoundTriangle(const BoundTriangle&) = delete;
  BoundTriangle& operator=(const BoundTriangle&) = delete;

 private:
  void Bind(const btCollisionObjectWrapper* wrapper) {
    if (is_first_) {
      output_.setBody0Wrap(wrapper);
    } else {
      output_.setBody1Wrap(wrapper);
    }
  }

  btManifoldResult& output_;
  const bool is_first_;
  const btCollisionObjectWrapper* mesh_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
