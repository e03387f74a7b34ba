// One pair of random hulls at a chosen signed distance, and the error of a solver's normal for it.
#pragma once

#include <Eigen/Core>

#include "scene/polyhedron.h"
#include "scene/pose.h"
#include "scene/random.h"

namespace dgd_test {

/// Two hulls, each core + ball(margin), in the world.
struct HullPair {
  dgd_demos::Polyhedron core_1, core_2;
  dgd_demos::Pose pose_1, pose_2;
  double margin;           ///< m, of each.
  double signed_distance;  ///< m, of the sets with their margins; exact up to roundoff (dgd_demos's oracle).
};

/// A random pair: hulls of 8 to 20 vertices, 1 m across, in random orientations, the second one moved along a random
/// direction until the oracle's signed distance is one drawn from `least` to `greatest`, m.
HullPair DrawHullPair(dgd_demos::Random& random, double least, double greatest, double margin);

/// How much a solver's normal misses: the signed distance less the separation along it, m, never below 0 but for
/// roundoff. Parting the two along that normal takes this much longer a way than the least translation, or, if they
/// are apart, this much of their distance goes unseen.
/// @param normal  From set 1 to set 2, world; any length but 0.
double NormalError(const HullPair& pair, const Eigen::Vector3d& normal);

}  // namespace dgd_test
