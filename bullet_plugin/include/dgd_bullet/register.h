// The growth distance on a dispatcher that already lives, or whose configuration is not yours to change.
#pragma once

#include <LinearMath/btScalar.h>

#include <memory>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "dgd_bullet/statistics.h"

class btCollisionDispatcher;
struct btCollisionAlgorithmCreateFunc;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What the pairs of one dispatcher share: options, hulls, counters.
class Narrowphase;

/// Registers the growth distance for every pair of convex types, both orders, in the contact table and in the
/// closest-points table of `dispatcher`, and for convex types on planes and meshes as CollisionConfigurationOf does.
/// Pairs that already have an algorithm keep it until their bounding boxes part.
/// @param bullet_version  Bullet's version in the headers that the app is compiled with: leave it out.
/// @return the narrowphase now in use. It lives until the process ends, as Bullet demands of what it does not own.
/// Throws as MakeNarrowphase().
DGD_BULLET_EXPORT const Narrowphase& Register(btCollisionDispatcher* dispatcher, const Options& options = {},
                                              int bullet_version = BT_BULLET_VERSION);
inline const Narrowphase& Register(btCollisionDispatcher& dispatcher, const Options& options = {}) {
  return Register(&dispatcher, options);
}

/// Counters of a narrowphase.
DGD_BULLET_EXPORT Statistics StatisticsOf(const Narrowphase& narrowphase);

/// These serve configurations and dispatchers that CollisionConfigurationOf and Register() do not fit: a narrowphase,
/// which must outlive the dispatcher and all its pairs, and what makes the algorithms of a pair of shape types in the
/// two tables, null where the types are left to Bullet. Throws std::invalid_argument naming an option that is out of
/// range; and std::runtime_error, in one sentence, if the app's version of Bullet, or the precision of the Bullet
/// library in this process, is not what this library is compiled for.
DGD_BULLET_EXPORT std::shared_ptr<Narrowphase> MakeNarrowphase(const Options& options,
                                                               int bullet_version = BT_BULLET_VERSION);
DGD_BULLET_EXPORT btCollisionAlgorithmCreateFunc* ContactCreateFunc(Narrowphase& narrowphase, int type_0, int type_1);
DGD_BULLET_EXPORT btCollisionAlgorithmCreateFunc* ClosestPointsCreateFunc(Narrowphase& narrowphase, int type_0,
                                                                          int type_1);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
