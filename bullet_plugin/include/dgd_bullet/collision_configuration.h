// The one line that changes in a Bullet app:
//
//     dgd_bullet::CollisionConfiguration configuration;  // was: btDefaultCollisionConfiguration
//
// Link dgd::bullet with Debian's `bullet` (float), or dgd::bullet_float64 with `bullet-float64`.
#pragma once

#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <memory>
#include <utility>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "dgd_bullet/register.h"
#include "dgd_bullet/statistics.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

namespace configuration_internal {

/// A base that is made before Bullet's, so that a Bullet that does not match is found before it is used.
struct NarrowphaseOwner {
  std::shared_ptr<Narrowphase> narrowphase_;
};

}  // namespace configuration_internal

/// A configuration of Bullet's, or an app's own, with the growth distance for every pair of convex types and for convex
/// types on static planes, in the contact table and in the closest-points table; and in the contact table, for convex
/// types on triangle meshes and heightfields, one that gathers the contacts of all triangles, and for compounds, one
/// that finds the children that may be in contact within the step. Everything else (soft bodies, the two-dimensional
/// types) is left to the base, and its setting for contacts on planes (setPlaneConvexMultipointIterations()) has no
/// effect. As with any Bullet configuration, this object must outlive the
/// dispatcher, which copies the tables when it is made, and all its pairs.
///
///     dgd_bullet::CollisionConfigurationOf<btSoftBodyRigidBodyCollisionConfiguration> configuration;
template <class Base>
class CollisionConfigurationOf : private configuration_internal::NarrowphaseOwner, public Base {
 public:
  /// @param of_base  What the base is constructed with.
  /// Throws as MakeNarrowphase() (dgd_bullet/register.h), before the base is constructed.
  template <class... Arguments>
  explicit CollisionConfigurationOf(const Options& options = {}, Arguments&&... of_base)
      : configuration_internal::NarrowphaseOwner{MakeNarrowphase(options)}, Base(std::forward<Arguments>(of_base)...) {}

  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type0, int type1) override {
    btCollisionAlgorithmCreateFunc* ours = ContactCreateFunc(*narrowphase_, type0, type1);
    return ours != nullptr ? ours : Base::getCollisionAlgorithmCreateFunc(type0, type1);
  }
  btCollisionAlgorithmCreateFunc* getClosestPointsAlgorithmCreateFunc(int type0, int type1) override {
    btCollisionAlgorithmCreateFunc* ours = ClosestPointsCreateFunc(*narrowphase_, type0, type1);
    return ours != nullptr ? ours : Base::getClosestPointsAlgorithmCreateFunc(type0, type1);
  }

  Statistics statistics() const { return StatisticsOf(*narrowphase_); }
};

/// Takes the place of btDefaultCollisionConfiguration.
using CollisionConfiguration = CollisionConfigurationOf<btDefaultCollisionConfiguration>;

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
