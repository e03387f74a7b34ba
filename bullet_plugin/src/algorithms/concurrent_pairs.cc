#include "algorithms/concurrent_pairs.h"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>

#include <bit>
#include <cstdint>

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// One bit for each type.
using Types = std::uint64_t;
static_assert(MAX_BROADPHASE_COLLISION_TYPES <= 64);

/// The types of a shape, or of all that a compound is made of.
Types TypesOf(const btCollisionShape& shape) {
  if (!shape.isCompound()) return Types{1} << shape.getShapeType();
  const auto& compound = static_cast<const btCompoundShape&>(shape);
  Types types = 0;
  for (int i = 0; i < compound.getNumChildShapes(); ++i) types |= TypesOf(*compound.getChildShape(i));
  return types;
}

/// Calls predicate(int type) for each type until one is false.
template <class Predicate>
bool AllOf(Types types, const Predicate& predicate) {
  for (; types != 0; types &= types - 1) {
    if (!predicate(std::countr_zero(types))) return false;
  }
  return true;
}

}  // namespace

bool IsConcurrent(const CreateFuncs& create_funcs, const btCollisionShape& shape_0, const btCollisionShape& shape_1) {
  const btCollisionAlgorithmCreateFunc& create_func = *create_funcs[shape_0.getShapeType()][shape_1.getShapeType()];
  if (dynamic_cast<const ConcurrentCreateFunc*>(&create_func) != nullptr) return true;
  if (dynamic_cast<const CompoundCreateFunc*>(&create_func) == nullptr) return false;
  const Types types_0 = TypesOf(shape_0), types_1 = TypesOf(shape_1);
  // Where only the second body is a compound, its child is the first of their pair.
  const auto is_concurrent = [&](int type_0, int type_1) {
    const btCollisionAlgorithmCreateFunc* of_pair =
        shape_0.isCompound() ? create_funcs[type_0][type_1] : create_funcs[type_1][type_0];
    return dynamic_cast<const ConcurrentCreateFunc*>(of_pair) != nullptr;
  };
  return AllOf(types_0,
               [&](int type_0) { return AllOf(types_1, [&](int type_1) { return is_concurrent(type_0, type_1); }); });
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
