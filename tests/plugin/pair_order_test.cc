// That the order in which pairs are solved is the one that the solver is compiled for. In the other order it would
// answer as well, but several times as slowly.
#include "pair_order.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <gtest/gtest.h>

#include <memory>
#include <variant>
#include <vector>

#include "hull_cache.h"
#include "plugin/shape_zoo.h"
#include "shape_adapter.h"

namespace {

using dgd_bullet::PosedShape;

class Body {
 public:
  Body(btConvexShape& shape, dgd_bullet::HullCache& cache)
      : wrapper_(nullptr, &shape, &object_, object_.getWorldTransform(), -1, -1) {
    object_.setCollisionShape(&shape);
    std::shared_ptr<const dgd_bullet::CachedHull> hull;
    adapted_ = std::make_unique<PosedShape>(dgd_bullet::AdaptShape(shape, object_.getWorldTransform(),
                                                                   dgd_bullet::GeometryMode::kBullet, cache, hull,
                                                                   dgd_bullet::HullUse::kStep));
  }
  const btCollisionObjectWrapper& Wrapper() const { return wrapper_; }
  const PosedShape& Adapted() const { return *adapted_; }

 private:
  btCollisionObject object_;
  btCollisionObjectWrapper wrapper_;
  std::unique_ptr<PosedShape> adapted_;
};

TEST(PairOrder, EveryPairOfTypes_IsSolvedInTheCompiledOrder) {
  dgd_bullet::HullCache cache;
  const std::vector<dgd_test::ZooShape> zoo = dgd_test::MakeShapeZoo(1);
  for (const dgd_test::ZooShape& zoo_a : zoo) {
    const Body a(*zoo_a.shape, cache);
    for (const dgd_test::ZooShape& zoo_b : zoo) {
      const Body b(*zoo_b.shape, cache);
      const bool is_a_first = dgd_bullet::ComesBefore(a.Wrapper(), b.Wrapper());
      const PosedShape &first = (is_a_first ? a : b).Adapted(), &second = (is_a_first ? b : a).Adapted();
      // What only Bullet can evaluate is last of all, and needs no order.
      const bool is_erased = std::holds_alternative<dgd::RoundedSet<dgd_bullet::SupportCore>>(first.set);
      EXPECT_TRUE(is_erased || IsInOrder(first, second)) << zoo_a.name << ", " << zoo_b.name;
    }
  }
}

}  // namespace
