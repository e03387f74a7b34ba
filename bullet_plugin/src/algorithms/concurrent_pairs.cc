#include "algorithms/concurrent_pairs.h"

#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <cstddef>
#include <typeinfo>

#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

ConcurrentPairs::Kind ConcurrentPairs::KindOf(int type_0, int type_1) {
  Kind& kind = kinds_[static_cast<std::size_t>(type_0)][static_cast<std::size_t>(type_1)];
  if (kind != Kind::kUnknown) return kind;
  const btCollisionAlgorithmCreateFunc* create_func = create_funcs_[type_0][type_1];
  DGD_ASSERT(create_func != nullptr);
  const std::type_info& type = typeid(*create_func);
  if (dynamic_cast<const ConcurrentCreateFunc*>(create_func) != nullptr) {
    kind = Kind::kConcurrent;
  } else if (type == typeid(btCompoundCollisionAlgorithm::CreateFunc) ||
             type == typeid(btCompoundCollisionAlgorithm::SwappedCreateFunc)) {
    kind = Kind::kCompound;
  } else {
    kind = Kind::kOther;
  }
  return kind;
}

bool ConcurrentPairs::Contain(const btCollisionShape& shape_0, const btCollisionShape& shape_1) {
  const Kind kind = KindOf(shape_0.getShapeType(), shape_1.getShapeType());
  if (kind != Kind::kCompound) return kind == Kind::kConcurrent;
  // Bullet's algorithm of two compounds counts its searches in global variables. Where a compound meets another type,
  // it has one algorithm for each child.
  const bool is_first = shape_0.isCompound();
  if (is_first && shape_1.isCompound()) return false;
  const auto& compound = static_cast<const btCompoundShape&>(is_first ? shape_0 : shape_1);
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    const btCollisionShape& child = *compound.getChildShape(i);
    if (!(is_first ? Contain(child, shape_1) : Contain(shape_0, child))) return false;
  }
  return true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
