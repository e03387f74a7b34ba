// The algorithm object of a convex shape and a static plane: a closed form for the distance, and all corners of the
// face that the shape shows the plane in one step, where Bullet's own adds one a step.
//
// The contract (read from Bullet 3.24, btConvexPlaneCollisionAlgorithm): the manifold has the convex body first
// whatever the order of the call, so contacts' normals are the plane's; the plane's margin and scaling are not looked
// at; boxes have sharp edges, other shapes are what Bullet's GJK sees.
#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include <memory>
#include <optional>

#include "dgd_bullet/linkage.h"
#include "fallback.h"
#include "hull_cache.h"
#include "narrowphase.h"
#include "pair_manifold.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairMotion;
class RestingPair;

class ConvexPlaneAlgorithm final : public btCollisionAlgorithm {
 public:
  /// @param info         If it brings a manifold, that is shared: filled, and not refreshed.
  /// @param is_for_step  Whether its contacts are a step's, and may be ahead of the bodies' motion in it.
  ConvexPlaneAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase, bool is_for_step);
  ~ConvexPlaneAlgorithm() override;
  ConvexPlaneAlgorithm(const ConvexPlaneAlgorithm&) = delete;
  ConvexPlaneAlgorithm& operator=(const ConvexPlaneAlgorithm&) = delete;

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override;

  /// 1, as Bullet's: its worlds sweep shapes against planes themselves.
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }

  void getAllContactManifolds(btManifoldArray& manifolds) override;

 private:
  /// Writes the pair's contacts. If that failed: why; nothing was written then.
  std::optional<Fallback> FindContacts(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& plane,
                                       const btDispatcherInfo& info, btManifoldResult& output);

  /// If neither has moved since the contacts were found, or both have together: brings them up to date, and true.
  bool StaysAtRest(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& plane,
                   const btDispatcherInfo& info, btManifoldResult& output);

  /// Notes what the contacts have been found for, if the pair will be nearly as it is after the step.
  void RememberRest(const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& plane,
                    const PairMotion& motion);

  void Count(const PairOutcome& outcome, const btCollisionObjectWrapper& convex);

  Narrowphase& narrowphase_;
  [[no_unique_address]] PairManifold manifold_;  // What follows takes its padding.
  bool is_resting_ = false;                      // That is what the manifold's contacts have been found for.
  const bool is_for_step_;
  std::unique_ptr<RestingPair> resting_;  // Once the pair has rested.
  std::shared_ptr<const CachedHull> hull_;
};

// As convex_convex_algorithm.h says of its own.
static_assert(sizeof(ConvexPlaneAlgorithm) <= 184, "must fit Bullet's smallest pool element");
static_assert(alignof(ConvexPlaneAlgorithm) <= 8, "some of Bullet's pools align to 8 bytes only");

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
