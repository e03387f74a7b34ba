// The algorithm object of a compound and any other shape: its children that the other body is near, or those of both,
// are solved pair by pair, each by what the dispatcher has for its types.
//
// As with Bullet, each pair of children has a manifold of its own. It is by its manifold that an app identifies the
// children in contact and is called back when they begin and cease to touch; and a body that hangs on to another one
// from two sides has contacts on both, where four points in all would have to do.
//
// The contract (read from Bullet 3.24, btCompoundCollisionAlgorithm and btCompoundCompoundCollisionAlgorithm): the
// compound's child is the first of its pair in either order of the call; each child is a shape of its own in a wrapper
// that the result has in the compound's place, with its index; callbacks may exclude pairs of children; if children
// are added or removed, all pairs are begun from scratch. In contrast, children are near as long as they may be in
// contact within the step, and not only while their bounding boxes overlap.
#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include "compound/child_pairs.h"
#include "dgd_bullet/linkage.h"
#include "visiting_order.h"

class btCompoundShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class Narrowphase;

class CompoundAlgorithm final : public btCollisionAlgorithm {
 public:
  CompoundAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const Narrowphase& narrowphase)
      : btCollisionAlgorithm(info),
        narrowphase_(narrowphase),
        shared_manifold_(info.m_manifold),
        pairs_(*info.m_dispatcher1) {}
  CompoundAlgorithm(const CompoundAlgorithm&) = delete;
  CompoundAlgorithm& operator=(const CompoundAlgorithm&) = delete;

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override;
  /// 1, never: Bullet does not give the places of children.
  btScalar calculateTimeOfImpact(btCollisionObject* body_0, btCollisionObject* body_1, const btDispatcherInfo& info,
                                 btManifoldResult* output) override;
  void getAllContactManifolds(btManifoldArray& manifolds) override;

 private:
  /// What the pairs' algorithms are made for: a compound's children as they are numbered now, or a type of shapes.
  struct Content {
    Content() = default;
    explicit Content(const btCollisionShape& shape);
    bool operator==(const Content&) const = default;

    const btCompoundShape* compound = nullptr;
    int version = -1;  // Bullet's count of the compound's changes, or the type.
  };

  const Narrowphase& narrowphase_;
  btPersistentManifold* const shared_manifold_;  // Null unless all children are to share one.
  ChildPairs pairs_;
  Content content_0_, content_1_;   // Contents of the last call.
  VisitingOrder::Place place_ = 0;  // The last call's place in the thread's order of visits.
};

static_assert(sizeof(CompoundAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(CompoundAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
