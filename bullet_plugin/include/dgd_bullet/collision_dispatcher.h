// A dispatcher for worlds of thousands of bodies, which decides pairs that stay apart without their algorithms, and
// shares the others among threads. Bullet's own btCollisionDispatcher gives the same world to the last bit.
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
/// same to the last bit, for any number of threads.
///
/// Pairs of convex shapes that stay apart along the axis that has separated them are decided from compact arrays: in a
/// heap they are most pairs, and their algorithms would wait for memory. They are boxes, spheres, capsules, cylinders,
/// cones and hulls of up to 64 points; left to their algorithms are pairs of kinematic bodies, of multibodies' links,
/// and all if they are observed or counted (Options::pair_observer, count_pairs). Each body and shape is read once,
/// when a dispatch begins; what a callback changes of others counts from the next one on.
///
/// Any Bullet will do for several threads: its pools and the list of manifolds are locked while pairs are shared.
/// Shared are pairs of convex shapes, and of a convex shape and a plane, that this library solves, and those of
/// compounds of such shapes. All others come before them, on the calling thread: those of meshes, for which Bullet
/// writes global counters without a lock, those of heightfields, and those of other algorithms (soft bodies, GImpact,
/// an app's own).
///
/// Bullet's way, one pair after the other, is taken with a near callback of the app's; while the debug drawer draws;
/// with DISPATCH_CONTINUOUS; with CD_DISABLE_CONTACTPOOL_DYNAMIC_ALLOCATION, where the order decides which pairs get
/// the last manifolds; and for a pair cache that has fewer pairs than the world's, such as a ghost's.
///
/// Bullet's contact callbacks (gContactAddedCallback and its like), users' shapes, checkCollideWith() and allocators
/// may be called by several threads at once, as with btCollisionDispatcherMt, and must not throw then: with more than
/// one thread, an exception ends the program. Callbacks that end a contact because its manifold is released come after
/// all pairs.
class DGD_BULLET_EXPORT CollisionDispatcher : public btCollisionDispatcher {
 public:
  /// Starts the threads, which wait until there are pairs.
  /// @param configuration   Outlives this and all pairs, as with btCollisionDispatcher.
  /// @param bullet_version  Bullet's version in the headers that the app is compiled with: leave it out.
  /// Throws std::invalid_argument naming an option that is out of range, std::runtime_error as MakeNarrowphase()
  /// (dgd_bullet/register.h), and std::system_error if a thread cannot be started.
  explicit CollisionDispatcher(btCollisionConfiguration* configuration, const DispatcherOptions& options = {},
                               int bullet_version = BT_BULLET_VERSION);
  /// Ends the threads. The world must be gone, as with btCollisionDispatcher.
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
