#include "algorithms/concurrent_pairs.h"

#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <typeinfo>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

bool IsConcurrent(const CreateFuncs& create_funcs, const btCollisionShape& shape_0, const btCollisionShape& shape_1) {
  const btCollisionAlgorithmCreateFunc& create_func = *create_funcs[shape_0.getShapeType()][shape_1.getShapeType()];
  if (dynamic_cast<const ConcurrentCreateFunc*>(&create_func) != nullptr) return true;
  if (typeid(create_func) != typeid(btCompoundCollisionAlgorithm::CreateFunc) &&
      typeid(create_func) != typeid(btCompoundCollisionAlgorithm::SwappedCreateFunc)) {
    return false;
  }
  // Bullet's algorithm of two compounds counts its searches in global variables. Where a compound meets another type,
  // it has one algorithm for each child.
  const bool is_first = shape_0.isCompound();
  if (is_first && shape_1.isCompound()) return false;
  const auto& compound = static_cast<const btCompoundShape&>(is_first ? shape_0 : shape_1);
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    const btCollisionShape& child = *compound.getChildShape(i);
    if (!(is_first ? IsConcurrent(create_funcs, child, shape_1) : IsConcurrent(create_funcs, shape_0, child))) {
      return false;
    }
  }
  return true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
