// Growth distances by other means than the solver's, where there are such: to hold answers against, beside their
// certificates.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "support/pairs/set_numbers.h"

namespace dgd_bench {

/// Relative: what such an answer may be off by itself (support/lp_oracle.h).
inline constexpr double kExactToWithin = 1e-13;

/// Of sharp polytopes in space a linear program, its optimal basis solved for in extended precision; of two balls the
/// closed form. Nothing for other sets, or where the linear program fails.
/// @param center_1, center_2  Of the sets, world, metres.
std::optional<double> ExactGrowthDistance(const dgd_test::PairNumbers& pair, const Eigen::Vector3d& center_1,
                                          const Eigen::Vector3d& center_2);

}  // namespace dgd_bench
