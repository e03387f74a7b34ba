#include "dgd_bullet/register.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <memory>
#include <mutex>
#include <vector>

#include "narrowphase.h"

namespace dgd_bullet {

const Narrowphase& Register(btCollisionDispatcher* dispatcher, const Options& options) {
  // Never destroyed: a dispatcher with static storage may outlive any object of ours.
  static std::mutex mutex;
  static auto& registered = *new std::vector<std::unique_ptr<Narrowphase>>();

  auto owned = std::make_unique<Narrowphase>(options);
  Narrowphase& narrowphase = *owned;
  {
    const std::lock_guard lock(mutex);
    registered.push_back(std::move(owned));
  }
  for (int type_0 = 0; type_0 < MAX_BROADPHASE_COLLISION_TYPES; ++type_0) {
    for (int type_1 = 0; type_1 < MAX_BROADPHASE_COLLISION_TYPES; ++type_1) {
      if (!Narrowphase::Handles(type_0, type_1)) continue;
      dispatcher->registerCollisionCreateFunc(type_0, type_1, narrowphase.ContactCreateFunc());
      dispatcher->registerClosestPointsCreateFunc(type_0, type_1, narrowphase.ClosestPointsCreateFunc());
    }
  }
  return narrowphase;
}

Statistics StatisticsOf(const Narrowphase& narrowphase) { return narrowphase.statistics(); }

}  // namespace dgd_bullet
