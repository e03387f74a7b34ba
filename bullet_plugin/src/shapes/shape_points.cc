#include "shapes/shape_points.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btStridingMeshInterface.h>
#include <BulletCollision/CollisionShapes/btTetrahedronShape.h>
#include <BulletCollision/CollisionShapes/btTriangleCallback.h>

#include <array>
#include <cstring>

#include "dgd/assert.h"
#include "shapes/multi_sphere.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

const btVector3 kUnscaled(1, 1, 1);

/// Collects the corners of a mesh's triangles, which Bullet hands over scaled.
class CornerCollector : public btInternalTriangleIndexCallback {
 public:
  void internalProcessTriangleIndex(btVector3* triangle, int, int) override {
    for (int corner = 0; corner < 3; ++corner) points.push_back(FromBullet(triangle[corner]));
  }
  std::vector<Vector3> points;
};

/// An app's vertices may lie at any address.
template <class Number>
Vector3 ReadPoint(const unsigned char* bytes) {
  std::array<Number, 3> coordinates;
  std::memcpy(coordinates.data(), bytes, sizeof(coordinates));
  return {double(coordinates[0]), double(coordinates[1]), double(coordinates[2])};
}

}  // namespace

bool IsHullOfPoints(const btConvexShape& shape) {
  switch (shape.getShapeType()) {
    case CONVEX_HULL_SHAPE_PROXYTYPE:
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE:
    case TETRAHEDRAL_SHAPE_PROXYTYPE:
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE:
      return true;
    case MULTI_SPHERE_SHAPE_PROXYTYPE: {
      const auto& spheres = static_cast<const btMultiSphereShape&>(shape);
      return AreSpheres(spheres) && HaveOneRadius(spheres);
    }
    default:
      return false;
  }
}

ShapePoints::ShapePoints(const btConvexShape& shape) : scaling_(&kUnscaled) {
  const auto set_array = [this](const btVector3* points, int count, const btVector3& scaling) {
    layout_.count = count;
    if (count > 0) base_ = reinterpret_cast<const unsigned char*>(points);
    scaling_ = &scaling;
  };
  switch (shape.getShapeType()) {
    case CONVEX_HULL_SHAPE_PROXYTYPE: {
      const auto& hull = static_cast<const btConvexHullShape&>(shape);
      set_array(hull.getNumPoints() > 0 ? hull.getUnscaledPoints() : nullptr, hull.getNumPoints(),
                hull.getLocalScalingNV());
      break;
    }
    case CONVEX_POINT_CLOUD_SHAPE_PROXYTYPE: {
      const auto& cloud = static_cast<const btConvexPointCloudShape&>(shape);
      set_array(cloud.getUnscaledPoints(), cloud.getNumPoints(), cloud.getLocalScalingNV());
      break;
    }
    case MULTI_SPHERE_SHAPE_PROXYTYPE: {
      const auto& spheres = static_cast<const btMultiSphereShape&>(shape);
      set_array(&spheres.getSpherePosition(0), spheres.getSphereCount(), spheres.getLocalScalingNV());
      break;
    }
    case TETRAHEDRAL_SHAPE_PROXYTYPE: {
      const auto& simplex = static_cast<const btBU_Simplex1to4&>(shape);
      const int count = simplex.getNumVertices();
      for (int i = 0; i < count; ++i) simplex.getVertex(i, corners_[static_cast<std::size_t>(i)]);
      set_array(corners_.data(), count, kUnscaled);
      break;
    }
    case CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE: {
      const btStridingMeshInterface* mesh = static_cast<const btConvexTriangleMeshShape&>(shape).getMeshInterface();
      if (mesh->getNumSubParts() < 1) break;
      const unsigned char* vertices = nullptr;
      const unsigned char* indices = nullptr;
      int index_stride = 0, faces = 0;
      PHY_ScalarType vertex_type{}, index_type{};
      mesh->getLockedReadOnlyVertexIndexBase(&vertices, layout_.count, vertex_type, layout_.stride, &indices,
                                             index_stride, faces, index_type, 0);
      mesh->unLockReadOnlyVertexBase(0);
      base_ = vertices;
      layout_.is_double = vertex_type == PHY_DOUBLE;
      scaling_ = &mesh->getScaling();
      break;
    }
    default:
      break;
  }
}

Vector3 ShapePoints::operator[](int i) const {
  DGD_ASSERT(i >= 0 && i < Count());
  const auto* bytes = base_ + static_cast<std::ptrdiff_t>(i) * layout_.stride;
  const Vector3 point = layout_.is_double ? ReadPoint<double>(bytes) : ReadPoint<float>(bytes);
  return point.cwiseProduct(FromBullet(*scaling_));
}

std::span<const unsigned char> ShapePoints::Bytes() const {
  if (layout_.count < 1) return {};
  const std::size_t point_size = 3 * (layout_.is_double ? sizeof(double) : sizeof(float));
  return {base_, static_cast<std::size_t>(layout_.count - 1) * static_cast<std::size_t>(layout_.stride) + point_size};
}

std::vector<Vector3> AllPoints(const btConvexShape& shape) {
  if (shape.getShapeType() == CONVEX_TRIANGLEMESH_SHAPE_PROXYTYPE) {
    // A mesh may have vertices that no triangle uses; Bullet's support function looks at the triangles.
    const btScalar limit = btScalar(BT_LARGE_FLOAT);
    CornerCollector collector;
    static_cast<const btConvexTriangleMeshShape&>(shape).getMeshInterface()->InternalProcessAllTriangles(
        &collector, btVector3(-limit, -limit, -limit), btVector3(limit, limit, limit));
    return std::move(collector.points);
  }
  DGD_ASSERT(IsHullOfPoints(shape));
  const ShapePoints source(shape);
  std::vector<Vector3> points;
  points.reserve(static_cast<std::size_t>(source.Count()));
  for (int i = 0; i < source.Count(); ++i) points.push_back(source[i]);
  return points;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
