// The growth distance of two polytopes as a linear program, solved by GLPK: an answer that shares nothing with
// dgd_core.
#pragma once

#include <Eigen/Core>
#include <span>

namespace dgd_test {

/// Smallest scale at which the hulls of the two point sets meet, each scaled about its own centre (the paper's Def. 3).
/// World coordinates, metres; the centres lie in the hulls. Throws std::runtime_error if there is no solution (two flat
/// hulls) or GLPK fails. GLPK finds the optimal basis; the basis is solved for again in long double and checked to be
/// primal and dual feasible, which makes the answer correct to about 1e-13 relative.
double GrowthDistanceByLp(std::span<const Eigen::Vector3d> vertices_1, const Eigen::Vector3d& center_1,
                          std::span<const Eigen::Vector3d> vertices_2, const Eigen::Vector3d& center_2);

}  // namespace dgd_test
