// Contacts that stick are held where they first stuck.
//
// Bullet's solver knows friction as a wish for no speed. What speed its iterations leave in a step is never taken back:
// piles creep by millimetres a minute. Its friction anchors (btCollisionObject::CF_HAS_FRICTION_ANCHOR) make the solver
// take back the way as well, but keep a contact point with its old normal and place for as long as it sticks, so that a
// wheel is held by where it stood. Here each step's patch counts, and an anchor is only what two points that once met
// have slipped since: a rolling body slips by nothing.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btVector3.h>

#include <array>

namespace dgd_bullet {

/// The contact points of a manifold that this pair owns, from before a patch is handed over until after. For whole
/// patches only: the world positions of points that no patch has written in this step are the last step's.
class FrictionAnchors {
 public:
  explicit FrictionAnchors(const btPersistentManifold& manifold);

  /// Where faces lie on each other: of the points that the patch continued, those that stuck in the last step (lateral
  /// impulses within the friction cone) get the way that their surfaces have slipped by, up to a small part of the
  /// breaking threshold, and the flag that makes the solver take it back. Leaves alone what Bullet anchors itself, and
  /// surfaces with a motion of their own, such as belts.
  void Restore(btPersistentManifold& manifold) const;

  /// For a manifold whose points have been kept, not found anew: those that stuck in the last step are held where they
  /// were found.
  static void HoldKept(btPersistentManifold& manifold);

 private:
  struct Anchor {
    btVector3 on_a, on_b;  // In the bodies' frames, metres.
    int life_time;
    bool sticks;
  };

  std::array<Anchor, MANIFOLD_CACHE_SIZE> anchors_;
  int size_;
};

}  // namespace dgd_bullet
