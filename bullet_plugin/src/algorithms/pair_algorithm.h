// The common base of the algorithm objects of two convex shapes and of a convex shape on a plane: Bullet's contract on
// the pair's manifold. What happens in between is the pair's pipeline.
//
// The contract (read from Bullet 3.24, btConvexConvexAlgorithm): a manifold is taken from the construction info if
// there is one and not owned then, else made at first need, also without contact, and released with the pair.
#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include "dgd_bullet/linkage.h"
#include "pair/pair_state.h"
#include "pair_outcome.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairAlgorithm : public btCollisionAlgorithm {
 public:
  /// @param info         If it brings a manifold, that is shared: filled, and not refreshed.
  /// @param is_for_step  Whether the contacts are a step's, and may be ahead of the bodies' motion in it.
  PairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, SharedState& narrowphase, bool is_for_step)
      : btCollisionAlgorithm(info), pair_(narrowphase, info.m_manifold, is_for_step) {}
  ~PairAlgorithm() override;
  PairAlgorithm(const PairAlgorithm&) = delete;
  PairAlgorithm& operator=(const PairAlgorithm&) = delete;

  void getAllContactManifolds(btManifoldArray& manifolds) override;

 protected:
  /// processCollision() of bodies in the manifold's order.
  void Process(const PairBodies& bodies, const btDispatcherInfo& info, btManifoldResult& output);

  /// Makes the manifold's contacts those of this step.
  virtual PairOutcome RunPipeline(const PairCall& call) = 0;

  void Count(const PairBodies& bodies, const PairOutcome& outcome) {
    pair_.narrowphase.Count(bodies.first.getCollisionShape()->getShapeType(),
                            bodies.second.getCollisionShape()->getShapeType(), outcome);
  }

  PairState pair_;

  /// Whether a call like this one, which finds no contacts either, changes nothing, neither in the pair nor outside.
  bool IsUnchangedBy(const PairCall& call) const {
    return pair_.options().pair_observer == nullptr && !pair_.options().count_pairs && !pair_.had_contact &&
           pair_.manifold.IsOwn() && pair_.manifold.IsEmpty() && CanDoWithoutManifold(call) == !pair_.manifold;
  }

 private:
  /// Whether a pair that is not new can be without a manifold in this call, as long as it has no contacts.
  bool CanDoWithoutManifold(const PairCall& call) const;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
