#include "convex_mesh_algorithm.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <LinearMath/btAabbUtil2.h>

#include <new>

#include "contact_distance.h"
#include "convex_convex_algorithm.h"
#include "mesh_triangle.h"
#include "pair_apart.h"
#include "pair_motion.h"

namespace dgd_bullet {
namespace {

/// Asks about each triangle that the convex body's bounding box reaches.
class TriangleVisit final : public btTriangleCallback {
 public:
  TriangleVisit(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& mesh,
                const btDispatcherInfo& info, double contact_distance, btDispatcher& dispatcher, TrianglePairs& pairs,
                btManifoldResult& output)
      : convex_(convex),
        mesh_(mesh),
        convex_reach_(*convex.getCollisionObject()),
        mesh_reach_(*mesh.getCollisionObject()),
        info_(info),
        contact_distance_(contact_distance),
        dispatcher_(dispatcher),
        pairs_(pairs),
        output_(output) {}

  void VisitAll() {
    const auto& shape = static_cast<const btConcaveShape&>(*mesh_.getCollisionShape());
    margin_ = shape.getMargin();
    const btTransform in_mesh = mesh_.getWorldTransform().inverseTimes(convex_.getWorldTransform());
    convex_.getCollisionShape()->getAabb(in_mesh, low_, high_);
    const btVector3 margins(margin_, margin_, margin_);
    low_ -= margins;
    high_ += margins;
    shape.processAllTriangles(this, low_, high_);
  }

  void processTriangle(btVector3* corners, int part, int index) override {
    if (!TestTriangleAgainstAabb2(corners, low_, high_)) return;
    btTriangleShape shape(corners[0], corners[1], corners[2]);
    shape.setMargin(margin_);
    const btCollisionObjectWrapper triangle(&mesh_, &shape, mesh_.getCollisionObject(), mesh_.getWorldTransform(), part,
                                            index);
    btCollisionAlgorithm* algorithm = pairs_.Find(part, index);
    bool is_kept = algorithm != nullptr;
    if (!is_kept) {
      if (IsBesideItsPlane(triangle, shape)) return;
      // By the dispatcher's table: an app may have an algorithm of its own for triangles.
      algorithm =
          dispatcher_.findAlgorithm(&convex_, &triangle, output_.getPersistentManifold(), BT_CONTACT_POINT_ALGORITHMS);
      if (algorithm == nullptr) return;
      // Other algorithms may rely on being new.
      is_kept = dynamic_cast<ConvexConvexAlgorithm*>(algorithm) != nullptr && pairs_.Keep(part, index, algorithm);
    }
    {
      const ShownTriangle shown(output_, triangle);
      algorithm->processCollision(&convex_, &triangle, info_, &output_);
    }
    if (!is_kept) GiveBack(dispatcher_, algorithm);
  }

 private:
  /// Whether the convex body is on one side of the triangle's plane, beyond the contact distance.
  bool IsBesideItsPlane(const btCollisionObjectWrapper& triangle, const btTriangleShape& shape) const {
    const btVector3 area =
        (shape.m_vertices1[1] - shape.m_vertices1[0]).cross(shape.m_vertices1[2] - shape.m_vertices1[0]);
    const btScalar length = area.length();
    if (!(length > 0)) return false;
    const btVector3 normal = mesh_.getWorldTransform().getBasis() * (area / length);
    const auto is_apart = [&](const btVector3& direction) {
      return SeparationAlong({convex_, convex_reach_}, {triangle, mesh_reach_}, direction) > contact_distance_;
    };
    return is_apart(normal) || is_apart(-normal);
  }

  const btCollisionObjectWrapper &convex_, &mesh_;
  const BodyReach convex_reach_, mesh_reach_;
  const btDispatcherInfo& info_;
  const double contact_distance_;  // Metres.
  btDispatcher& dispatcher_;
  TrianglePairs& pairs_;
  btManifoldResult& output_;
  btScalar margin_ = 0;   // Of the mesh.
  btVector3 low_, high_;  // Of the convex body's bounding box, in the mesh's frame.
};

}  // namespace

ConvexMeshAlgorithm::ConvexMeshAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                         const Narrowphase& narrowphase, const btCollisionObjectWrapper* body_0,
                                         const btCollisionObjectWrapper* body_1, bool is_swapped)
    : btConvexConcaveCollisionAlgorithm(info, body_0, body_1, is_swapped),
      options_(narrowphase.options()),
      pairs_(new (std::nothrow) TrianglePairs(*m_dispatcher)) {
  btManifoldArray manifolds;
  getAllContactManifolds(manifolds);
  if (manifolds.size() > 0) manifold_ = manifolds[0];
}

void ConvexMeshAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                           const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                           btManifoldResult* output) {
  const bool is_swapped = body_0->getCollisionShape()->isConcave();
  const btCollisionObjectWrapper &convex = is_swapped ? *body_1 : *body_0, &mesh = is_swapped ? *body_0 : *body_1;
  // A body's shape may have been exchanged for one of another type.
  const bool are_ours =
      Narrowphase::HandlesMesh(convex.getCollisionShape()->getShapeType(), mesh.getCollisionShape()->getShapeType());
  // Where an app asks how far apart bodies are, the triangles have manifolds of their own.
  if (!are_ours || pairs_ == nullptr || manifold_ == nullptr || output->m_closestPointDistanceThreshold > 0) {
    return btConvexConcaveCollisionAlgorithm::processCollision(body_0, body_1, info, output);
  }
  output->setPersistentManifold(manifold_);
  manifold_->setBodies(convex.getCollisionObject(), mesh.getCollisionObject());
  const double contact_distance = ContactDistance(options_, double(manifold_->getContactBreakingThreshold()), *output);
  TriangleVisit(convex, mesh, info, contact_distance, *m_dispatcher, *pairs_, *output).VisitAll();
  pairs_->EndStep();
  output->refreshContactPoints();
}

}  // namespace dgd_bullet
