// What the algorithm objects of two convex shapes and of a convex shape on a plane have in common: the pair's manifold,
// recycled contacts of bodies at rest, and failures, which are counted and left to Bullet's own algorithm where that
// can do better.
//
// The contract (read from Bullet 3.24, btConvexConvexAlgorithm): a manifold is taken from the construction info if
// there is one and not owned then, else made at first need, also without contact, and released with the pair.
#pragma once

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include <memory>
#include <optional>

#include "algorithms/fallback.h"
#include "algorithms/narrowphase.h"
#include "algorithms/pair_manifold.h"
#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairMotion;
class RestingPair;
struct Footing;

class PairAlgorithm : public btCollisionAlgorithm {
 public:
  ~PairAlgorithm() override;
  PairAlgorithm(const PairAlgorithm&) = delete;
  PairAlgorithm& operator=(const PairAlgorithm&) = delete;

  void getAllContactManifolds(btManifoldArray& manifolds) override;

 protected:
  /// The manifold's two bodies, in its order.
  struct Bodies {
    const btCollisionObjectWrapper &first, &second;
  };

  /// @param info         If it brings a manifold, that is shared: filled, and not refreshed.
  /// @param is_for_step  Whether its contacts are a step's, and may be ahead of the bodies' motion in it.
  PairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase, bool is_for_step);

  /// processCollision(): the manifold's contacts of this step, in whichever way.
  void Process(const Bodies& bodies, const btDispatcherInfo& info, btManifoldResult& output);

  /// Finds the pair's contacts and writes them, and notes in `had_contact_` whether there are any. If that failed: why;
  /// nothing was written then.
  virtual std::optional<Fallback> FindContacts(const Bodies& bodies, const btDispatcherInfo& info,
                                               btManifoldResult& output) = 0;

  /// KeepContacts() of the pair, whose contacts have been found while it was at rest.
  virtual bool UpdateRecycledContacts(const Bodies& bodies, double anchor_time_step, btManifoldResult& output) = 0;

  /// Takes a manifold from the dispatcher if there is none, and makes it the output's. False if none is left.
  bool EnsureManifold(const Bodies& bodies, btManifoldResult& output);

  /// Notes what the contacts have been found for, if the pair will be nearly as it is after the step and the options
  /// say that they are kept.
  void RememberRest(const Bodies& bodies, const Footing& footing, const PairMotion& motion);
  /// Whether there are contacts, which the options let be recycled.
  bool MayRecycle() const;

  void Count(Fallback fallback, const Bodies& bodies);

  // What a pair that rests or stays apart needs comes first.
  Narrowphase& narrowphase_;
  [[no_unique_address]] PairManifold manifold_;  // What follows takes its padding.
  bool is_resting_ = false;                      // That is what the manifold's contacts have been found for.
  bool had_contact_ = false;                     // In the last step.
  const bool is_for_step_;
  std::unique_ptr<RestingPair> resting_;  // Once the pair has rested.

 private:
  /// Whether a pair that is not new can be without a manifold in this call, as long as it has no contacts.
  bool CanDoWithoutManifold(const Bodies& bodies, const btManifoldResult& output) const;

  /// The contacts of this step, recycled or found, or those of Bullet's own algorithm.
  void FindOrRecycleContacts(const Bodies& bodies, const btDispatcherInfo& info, btManifoldResult& output);

  /// If neither body has moved since the contacts were found, or both have together, and nothing else that they come
  /// from has changed: brings them up to date, and true.
  bool TryRecycleContacts(const Bodies& bodies, const btDispatcherInfo& info, btManifoldResult& output);
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
