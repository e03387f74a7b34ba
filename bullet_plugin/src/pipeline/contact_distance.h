// Up to which distance bodies have contacts.
#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Distance or overlap that does not count when bodies pass or touch each other: metres, for a manifold with this
/// breaking threshold. Bodies at rest tremble by less.
constexpr double NegligibleDistance(double breaking_threshold) { return 1e-3 * breaking_threshold; }

/// Metres, by the options or the manifold's breaking threshold, and what an app that asks adds.
inline double ContactDistance(const Options& options, double breaking_threshold, const btManifoldResult& output) {
  return (options.contact_distance > 0 ? options.contact_distance : breaking_threshold) +
         double(output.m_closestPointDistanceThreshold);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
