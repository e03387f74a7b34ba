#include "dgd_bullet/collision_configuration.h"

#include "narrowphase.h"

namespace dgd_bullet {

CollisionConfiguration::CollisionConfiguration(const Options& options, const btDefaultCollisionConstructionInfo& info)
    : btDefaultCollisionConfiguration(info), narrowphase_(std::make_unique<Narrowphase>(options)) {}

CollisionConfiguration::~CollisionConfiguration() = default;

btCollisionAlgorithmCreateFunc* CollisionConfiguration::getCollisionAlgorithmCreateFunc(int type0, int type1) {
  if (Narrowphase::Handles(type0, type1)) return narrowphase_->ContactCreateFunc();
  return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(type0, type1);
}

btCollisionAlgorithmCreateFunc* CollisionConfiguration::getClosestPointsAlgorithmCreateFunc(int type0, int type1) {
  if (Narrowphase::Handles(type0, type1)) return narrowphase_->ClosestPointsCreateFunc();
  return btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(type0, type1);
}

Statistics CollisionConfiguration::statistics() const { return narrowphase_->statistics(); }

}  // namespace dgd_bullet
