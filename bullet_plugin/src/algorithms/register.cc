#include "dgd_bullet/register.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>

#include <mutex>
#include <vector>

#include "algorithms/bullet_check.h"
#include "algorithms/narrowphase.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

std::shared_ptr<Narrowphase> MakeNarrowphase(const Options& options, int bullet_version) {
  RequireMatchingBullet(bullet_version);
  return std::make_shared<Narrowphase>(options);
}

btCollisionAlgorithmCreateFunc* ContactCreateFunc(Narrowphase& narrowphase, int type_0, int type_1) {
  return narrowphase.ContactCreateFunc(type_0, type_1);
}

btCollisionAlgorithmCreateFunc* ClosestPointsCreateFunc(Narrowphase& narrowphase, int type_0, int type_1) {
  return narrowphase.ClosestPointsCreateFunc(type_0, type_1);
}

const Narrowphase& Register(btCollisionDispatcher* dispatcher, const Options& options, int bullet_version) {
  // The list is never destroyed: a dispatcher with static storage may outlive any object of ours.
  static std::mutex mutex;
  static auto& registered = *new std::vector<std::shared_ptr<Narrowphase>>();

  const std::shared_ptr<Narrowphase> narrowphase = MakeNarrowphase(options, bullet_version);
  {
    const std::lock_guard lock(mutex);
    registered.push_back(narrowphase);
  }
  for (int type_0 = 0; type_0 < MAX_BROADPHASE_COLLISION_TYPES; ++type_0) {
    for (int type_1 = 0; type_1 < MAX_BROADPHASE_COLLISION_TYPES; ++type_1) {
      if (auto* contact = narrowphase->ContactCreateFunc(type_0, type_1)) {
        dispatcher->registerCollisionCreateFunc(type_0, type_1, contact);
      }
      if (auto* closest_points = narrowphase->ClosestPointsCreateFunc(type_0, type_1)) {
        dispatcher->registerClosestPointsCreateFunc(type_0, type_1, closest_points);
      }
    }
  }
  return *narrowphase;
}

Statistics StatisticsOf(const Narrowphase& narrowphase) { return narrowphase.statistics(); }

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
