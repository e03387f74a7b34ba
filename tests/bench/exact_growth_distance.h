// Growth distances by other means than the solver's, where there are such: to hold answers against, beside their
// certificates.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "support/pairs/set_numbers.h"

namespace dgd_bench {

/// Of sharp polytopes in space a linear program, its optimal basis solved for in extended precision (correct to about
/// 1e-13, support/lp_oracle.h); of two balls the closed form. Nothing for other sets, or where the linear program
/// fails.
/// @param center_1, center_2  Of the sets, world, metres.
std::optional<double> ExactGrowthDistance(const dgd_test::PairNumbers& pair, const Eigen::Vector3d& center_1,
                                          const Eigen::Vector3d& center_2);

}  // namespace dgd_bench
