// The classes of random pairs that `speed` and `solution_times` draw from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/pairs/set_numbers.h"
#include "support/random.h"

namespace dgd_bench {

/// Point sets whose hulls are the meshes of a class; metres.
using Meshes = std::vector<std::vector<Eigen::Vector3d>>;

/// Points on an ellipsoid ten times longer than thick, from 241 to 4516 of them.
Meshes EllipsoidMeshes(dgd_test::Random& random);

/// The hulls' vertices of all .obj files in the folder and below, in the order of their names; files in metres.
/// Throws std::runtime_error, naming the file, if one cannot be read, or there is none.
Meshes ReadMeshes(const std::filesystem::path& folder);

struct PairClass {
  const char* name;   ///< On the command line.
  const char* title;  ///< In the table.
  int dimension;
  /// Pairs are expensive to make: so many fewer of them, each in so many more poses.
  int poses_factor;
  /// The sets; the poses are not theirs to draw.
  dgd_test::PairNumbers (*draw_sets)(dgd_test::Random& random, const Meshes& meshes);
  int vertices = 0;  ///< Of each set, in the classes that differ in nothing else; 0 for the others.
};

const std::vector<PairClass>& AllPairClasses();

/// Where a pair stands, and where it stood at the query before: 1 % of the extent and 0.01 rad from there.
struct PairPoses {
  dgd_test::PoseNumbers pose_1, last_pose_2, pose_2;
};
/// Random orientations, both centres in a cube of 1.4 times the extent: overlaps and gaps are both frequent.
/// @param extent  Of both sets together, metres.
PairPoses DrawPoses(dgd_test::Random& random, int dimension, double extent);

}  // namespace dgd_bench
