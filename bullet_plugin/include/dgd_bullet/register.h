// The growth distance on a dispatcher that already lives, or whose configuration is not yours to change.
#pragma once

#include "dgd_bullet/options.h"
#include "dgd_bullet/statistics.h"

class btCollisionDispatcher;

namespace dgd_bullet {

class Narrowphase;

/// Registers the growth distance for every pair of convex types, both orders, in the contact table and in the
/// closest-points table of `dispatcher`. Pairs that already have an algorithm keep it until their bounding boxes part.
/// @return the narrowphase now in use. It lives until the process ends, as Bullet demands of what it does not own.
const Narrowphase& Register(btCollisionDispatcher* dispatcher, const Options& options = {});
inline const Narrowphase& Register(btCollisionDispatcher& dispatcher, const Options& options = {}) {
  return Register(&dispatcher, options);
}

/// Counters of a registered narrowphase.
Statistics StatisticsOf(const Narrowphase& narrowphase);

}  // namespace dgd_bullet
