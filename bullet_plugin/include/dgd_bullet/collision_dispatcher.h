// A dispatcher for worlds of thousands of bodies, which decides pairs that stay apart without their algorithms, and
// shares the others among threads. It is an option: Bullet's own btCollisionDispatcher gives the same world to the last
// bit.
//
//     dgd_bullet::CollisionConfiguration configuration;
//     dgd_bullet::CollisionDispatcher dispatcher(&configuration, {.threads = 4});  // was: btCollisionDispatcher
//
// (In C++17: set the member of a DispatcherOptions first.)
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <LinearMath/btScalar.h>

#include <memory>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct DispatcherOptions {
  /// Threads that solve pairs, that of the step among them: 1 to 64. More than the machine has cost time, and change
  /// nothing else.
  int threads = 1;
};

/// Takes the place of btCollisionDispatcher. The world, the list of manifolds and the narrowphase's statistics are the
/// same to the last bit as with that, for any number of threads.
///
/// Pairs of two convex shapes that this library solves, and that stay apart along the axis that has separated them, are
/// decided from compact arrays: in a heap they are most pairs, and their algorithms would wait for memory. They are
/// boxes, spheres, capsules, cylinders, cones and hulls of up to 64 points; pairs of kinematic bodies and of
/// multibodies' links, and those that are observed (Options::pair_observer), are left to their algorithms. For this
/// each body and shape is read once, when a dispatch begins; what a callback changes of others in a dispatch counts
/// from the next one on.
///
/// Threads: any Bullet will do. Debian's, which is built without BT_THREADSAFE, has locks neither for its pools nor for
/// its list of manifolds: here these are locked while pairs are shared, and the list is updated afterwards, in the
/// order of the pairs. Shared are pairs of convex shapes, and of a convex shape and a plane, that this library solves;
/// and those of such a shape and a compound of such shapes. Before them, on the calling thread, come all others: those
/// of two compounds and of meshes, for which Bullet writes global counters without a lock, those of heightfields, and
/// those of algorithms that are not known here (soft bodies, GImpact, an app's own).
///
/// btCollisionDispatcher solves all pairs, one after the other: with a near callback of the app's; while the debug
/// drawer draws anything; with DISPATCH_CONTINUOUS; with CD_DISABLE_CONTACTPOOL_DYNAMIC_ALLOCATION, where which pairs
/// get the last manifolds depends on the order; and those of a pair cache that has fewer pairs than the world's, a
/// ghost's say.
///
/// As with btCollisionDispatcherMt, Bullet's contact callbacks (gContactAddedCallback and its like), users' shapes,
/// checkCollideWith() and allocators may be called by several threads at once, and must not throw then: with more than
/// one thread, an exception ends the program. Callbacks that end a contact because its manifold is released come after
/// all pairs.
class DGD_BULLET_EXPORT CollisionDispatcher : public btCollisionDispatcher {
 public:
  /// Starts the threads, which wait until there are pairs.
  /// @param configuration   Outlives this and all pairs, as with btCollisionDispatcher.
  /// @param bullet_version  Of the headers that the app is compiled with: leave it out.
  /// Throws std::invalid_argument naming an option that is out of range, std::runtime_error as MakeNarrowphase()
  /// (dgd_bullet/register.h), and std::system_error if a thread cannot be started.
  explicit CollisionDispatcher(btCollisionConfiguration* configuration, const DispatcherOptions& options = {},
                               int bullet_version = BT_BULLET_VERSION);
  /// Ends the threads. As with btCollisionDispatcher, after the world.
  ~CollisionDispatcher() override;
  CollisionDispatcher(const CollisionDispatcher&) = delete;
  CollisionDispatcher& operator=(const CollisionDispatcher&) = delete;

  void dispatchAllCollisionPairs(btOverlappingPairCache* pair_cache, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

  btPersistentManifold* getNewManifold(const btCollisionObject* body_0, const btCollisionObject* body_1) override;
  void releaseManifold(btPersistentManifold* manifold) override;
  void* allocateCollisionAlgorithm(int size) override;
  void freeCollisionAlgorithm(void* algorithm) override;

 private:
  class Pairs;

  /// Whether btCollisionDispatcher dispatches.
  bool IsPlainDispatch(const btDispatcherInfo& info) const;

  btNearCallback default_near_callback_;
  std::unique_ptr<Pairs> pairs_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
