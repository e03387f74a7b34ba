#include "pair_manifold.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

bool PairManifold::Acquire(btDispatcher& dispatcher, const btCollisionObject& body_0, const btCollisionObject& body_1) {
  DGD_ASSERT(is_own_ || manifold_ != nullptr);
  if (manifold_ == nullptr) manifold_ = dispatcher.getNewManifold(&body_0, &body_1);
  return manifold_ != nullptr;
}

void PairManifold::Release(btDispatcher& dispatcher) {
  if (manifold_ == nullptr) return;
  DGD_ASSERT(is_own_);
  DGD_ASSERT(manifold_->getNumContacts() <= MANIFOLD_CACHE_SIZE);
  breaking_threshold_ = manifold_->getContactBreakingThreshold();
  dispatcher.releaseManifold(manifold_);
  manifold_ = nullptr;
}

void PairManifold::BindTo(btManifoldResult& output) const {
  if (manifold_ != nullptr) return output.setPersistentManifold(manifold_);
  static thread_local btPersistentManifold empty;
  // An app may have added points to it.
  if (empty.getNumContacts() > 0) empty.clearManifold();
  DGD_ASSERT(is_own_ && !(breaking_threshold_ < 0));
  empty.setBodies(output.getBody0Internal(), output.getBody1Internal());
  empty.setContactBreakingThreshold(breaking_threshold_);
  output.setPersistentManifold(&empty);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
