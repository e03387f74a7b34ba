// Which pairs may be solved at the same time, by a Bullet that is built without BT_THREADSAFE.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

#include <array>
#include <cstdint>

#include "dgd_bullet/linkage.h"

class btCollisionShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Makes algorithms that may run at the same time as others, and may be made then: what they share is safe, except what
/// they get from the dispatcher.
struct ConcurrentCreateFunc : btCollisionAlgorithmCreateFunc {};

/// Classifies pairs by their shapes, and by what makes their algorithms.
class ConcurrentPairs {
 public:
  using CreateFuncs = btCollisionAlgorithmCreateFunc* [MAX_BROADPHASE_COLLISION_TYPES][MAX_BROADPHASE_COLLISION_TYPES];

  /// @param create_funcs  A dispatcher's table, which is read as long as this is used.
  explicit ConcurrentPairs(const CreateFuncs& create_funcs) : create_funcs_(create_funcs) {}

  bool Contain(const btCollisionShape& shape_0, const btCollisionShape& shape_1);

 private:
  enum class Kind : std::uint8_t { kUnknown, kConcurrent, kCompound, kOther };

  Kind KindOf(int type_0, int type_1);

  const CreateFuncs& create_funcs_;
  std::array<std::array<Kind, MAX_BROADPHASE_COLLISION_TYPES>, MAX_BROADPHASE_COLLISION_TYPES> kinds_{};
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
