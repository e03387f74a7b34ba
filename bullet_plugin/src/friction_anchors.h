// Contacts that stick are held where they first stuck.
//
// Bullet's solver knows friction as a wish for no speed. What speed its iterations leave in a step is never taken back:
// piles creep by millimetres a minute. Its friction anchors (btCollisionObject::CF_HAS_FRICTION_ANCHOR) make the solver
// take back the way as well, but keep a contact point with its old normal and place for as long as it sticks, so that a
// wheel is held by where it stood. Here each step's patch counts, and an anchor is only what two points that once met
// have slipped since: a rolling body slips by nothing.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <LinearMath/btTransform.h>

namespace dgd_bullet {

/// On fewer points bodies rock, and would be given back what they slipped: fifty polytopes come to rest a tenth later.
constexpr int kFewestAnchors = 3;

/// Whether a point that has been in its manifold for a step stuck there: lateral impulses within the friction cone.
bool IsStuck(const btManifoldPoint& point);

/// The way that the surfaces have slipped by, since the point's two places met, across a normal: B to A, world, metres;
/// up to a small part of the breaking threshold.
btVector3 SlipOf(const btManifoldPoint& point, const btTransform& pose_a, const btTransform& pose_b,
                 const btVector3& normal, btScalar breaking_threshold);

/// Has the solver take back the slip of a point that has just been found anew: moves its two places. Leaves alone what
/// Bullet anchors itself, and surfaces with a motion of their own, such as belts.
void Hold(btManifoldPoint& point, const btVector3& slip, const btTransform& pose_a, const btTransform& pose_b);

/// For a manifold whose points have been kept, not found anew: those that stuck in the last step are held where they
/// were found.
void HoldKept(btPersistentManifold& manifold);

}  // namespace dgd_bullet
