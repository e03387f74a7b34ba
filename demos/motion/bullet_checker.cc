#include <btBulletCollisionCommon.h>

#include <vector>

#include "motion/pair_checker.h"
#include "simulation/bullet_math.h"
#include "simulation/bullet_shape.h"

namespace dgd_demos {
namespace {

// Whether any contact point is one of an overlap: Bullet also reports points at a distance.
struct OverlapCallback : btCollisionWorld::ContactResultCallback {
  bool overlaps = false;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    overlaps |= point.getDistance() <= 0;
    return 0;
  }
};

class BulletChecker : public PairChecker {
 public:
  explicit BulletChecker(const CollisionModel& model)
      : model_(model), dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &configuration_) {
    for (const CollisionModel::Part& part : model.parts()) {
      shapes_.push_back(MakeBulletShape(part.body.shape(), /*margin=*/0));
      objects_.push_back(std::make_unique<btCollisionObject>());
      objects_.back()->setCollisionShape(shapes_.back().get());
    }
  }

  std::string Name() const override { return "Bullet contactPairTest"; }

  void SetPoses(const CollisionModel::Poses& poses) override {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      objects_[i]->setWorldTransform(ToBullet(Pose{poses[i].rotation, poses[i].translation}));
    }
  }

  bool Collides(std::size_t pair) override {
    const auto [first, second] = model_.pairs()[pair];
    OverlapCallback callback;
    world_.contactPairTest(objects_[first].get(), objects_[second].get(), callback);
    return callback.overlaps;
  }

 private:
  const CollisionModel& model_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

std::unique_ptr<PairChecker> MakeBulletChecker(const CollisionModel& model) {
  return std::make_unique<BulletChecker>(model);
}

}  // namespace dgd_demos
