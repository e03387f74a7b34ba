// The contact manifold of a pair: its own, or one that it shares with the other triangles of a mesh.
//
// Without contacts a pair can be without a manifold of its own (Options::keep_empty_manifolds): Bullet visits each of a
// heap's many empty ones to build islands, to sort them, and to make constraints, although there are none.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"

class btCollisionObject;
class btDispatcher;
class btManifoldResult;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether any point carried something in the last step.
inline bool IsLoaded(const btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    if (manifold.getContactPoint(i).m_appliedImpulse > 0) return true;
  }
  return false;
}

class PairManifold {
 public:
  /// @param shared  A manifold that outlives the pair; or null for one of the pair's own, which is not there yet.
  explicit PairManifold(btPersistentManifold* shared) : manifold_(shared), is_own_(shared == nullptr) {}

  bool IsOwn() const { return is_own_; }
  explicit operator bool() const { return manifold_ != nullptr; }
  btPersistentManifold* Get() const { return manifold_; }
  btPersistentManifold& operator*() const {
    DGD_ASSERT(manifold_ != nullptr);
    return *manifold_;
  }
  btPersistentManifold* operator->() const {
    DGD_ASSERT(manifold_ != nullptr);
    return manifold_;
  }

  /// Whether there has never been one.
  bool IsNew() const { return manifold_ == nullptr && breaking_threshold_ < 0; }
  /// Whether there are no contacts, with a manifold or without.
  bool IsEmpty() const { return manifold_ == nullptr || manifold_->getNumContacts() == 0; }
  /// Breaking threshold of the manifold, now or when it was released; metres.
  double BreakingThreshold() const {
    DGD_ASSERT(manifold_ != nullptr || !(breaking_threshold_ < 0));  // NaN for shapes that are none.
    return double(manifold_ != nullptr ? manifold_->getContactBreakingThreshold() : breaking_threshold_);
  }

  /// Makes one if there is none. False if the dispatcher has none left.
  bool Acquire(btDispatcher& dispatcher, const btCollisionObject& body_0, const btCollisionObject& body_1);
  /// Gives back a manifold of the pair's own, if there is one.
  void Release(btDispatcher& dispatcher);

  /// Makes it the output's; where there is none, an empty one that is the thread's until the next call. Bullet's own
  /// results always have one, and apps read it without a check.
  void BindTo(btManifoldResult& output) const;

 private:
  btPersistentManifold* manifold_;
  btScalar breaking_threshold_ = -1;  // Threshold of the manifold that was released; < 0 if none was.
  bool is_own_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
