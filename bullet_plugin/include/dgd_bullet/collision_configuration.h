// The one line that changes in a Bullet app:
//
//     btDefaultCollisionConfiguration   configuration;   // before
//     dgd_bullet::CollisionConfiguration configuration;  // after
//     btCollisionDispatcher dispatcher(&configuration);
//
// Link dgd::bullet with Debian's `bullet` (float), or dgd::bullet_float64 with `bullet-float64`; the header is the
// same.
#pragma once

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <memory>

#include "dgd_bullet/options.h"
#include "dgd_bullet/statistics.h"

namespace dgd_bullet {

class Narrowphase;

/// Bullet's default configuration with the growth distance for every pair of convex types, in the contact table and in
/// the closest-points table. Everything else (compounds, meshes, planes, the two-dimensional types) stays Bullet's.
/// The dispatcher copies the tables when it is made. As with any Bullet configuration, this object must outlive the
/// dispatcher and all its pairs.
class CollisionConfiguration : public btDefaultCollisionConfiguration {
 public:
  explicit CollisionConfiguration(const Options& options = {}, const btDefaultCollisionConstructionInfo& info =
                                                                   btDefaultCollisionConstructionInfo());
  ~CollisionConfiguration() override;

  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type0, int type1) override;
  btCollisionAlgorithmCreateFunc* getClosestPointsAlgorithmCreateFunc(int type0, int type1) override;

  Statistics statistics() const;

 private:
  std::unique_ptr<Narrowphase> narrowphase_;
};

}  // namespace dgd_bullet
