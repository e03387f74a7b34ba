// One pair of random hulls at a chosen signed distance, and the judge of what a solver says about it.
#pragma once

#include <Eigen/Core>

#include "bench/distance_class.h"
#include "scene/polyhedron.h"
#include "scene/pose.h"
#include "scene/random.h"

namespace dgd_bench {

inline constexpr int kLeastVertices = 8;
inline constexpr int kMostVertices = 20;
/// Greatest distance of two vertices, m: half a metre from the centre.
inline constexpr double kHullDiameter = 1.0;
/// Of the second hull from the query before, as a share of the diameter, and in radians.
inline constexpr double kMotion = 0.01;

/// Of what the signed distance of a class is meant: the cores with their margins, which is what both solvers are asked;
/// or the bare cores, which is where Bullet changes from GJK to EPA.
enum class DistanceOf { kSets, kCores };

/// Two hulls, each core + ball(margin), in the world.
struct HullPair {
  dgd_demos::Polyhedron core_1, core_2;
  dgd_demos::Pose pose_1, pose_2;
  dgd_demos::Pose last_pose_2;  ///< A little motion ago: where a warm start comes from.
  double margin;                ///< m, of each.
  double signed_distance;       ///< m, of the sets with their margins; exact up to rounding (dgd_demos's oracle).
};

/// A random pair in `distance_class`: hulls of kLeastVertices to kMostVertices in random orientations, the second one
/// moved from deep inside along a random direction until the oracle says the drawn distance.
HullPair DrawHullPair(dgd_demos::Random& random, const DistanceClass& distance_class, DistanceOf distance_of,
                      double margin);

/// How much a solver's normal misses: the signed distance less the separation along it, m, never below 0 but for
/// rounding. Parting the two along that normal takes this much longer a way than the least translation, or, if they
/// are apart, this much of their distance goes unseen.
/// @param normal  From set 1 to set 2, world; any length but 0.
double NormalError(const HullPair& pair, const Eigen::Vector3d& normal);

}  // namespace dgd_bench
