// The ways to a growth distance that are compared, by name.
#pragma once

#include <array>

#include "bench/growth_pair.h"

namespace dgd_bench {

struct GrowthMethod {
  const char* key;    ///< On the command line and in files.
  const char* title;  ///< In tables.
  GrowthQuery query;
};

/// Ours; the paper's own; and the four that the paper compares with (Sec. VI).
inline constexpr std::array kGrowthMethods = {
    GrowthMethod{"growth", "ours", {}},
    GrowthMethod{"growth_warm", "ours, warm", {.is_warm = true}},
    GrowthMethod{"plain", "paper's algorithm, plain", {.algorithm = GrowthAlgorithm::kPlain}},
    GrowthMethod{
        "plain_warm", "paper's algorithm, plain, warm", {.algorithm = GrowthAlgorithm::kPlain, .is_warm = true}},
    GrowthMethod{"ie", "IE", {.algorithm = GrowthAlgorithm::kInternalExpanding}},
    GrowthMethod{"inc", "Inc", {.algorithm = GrowthAlgorithm::kIncremental}},
    GrowthMethod{"inc_warm", "Inc, warm", {.algorithm = GrowthAlgorithm::kIncremental, .is_warm = true}},
    GrowthMethod{"dcf", "DCF", {.algorithm = GrowthAlgorithm::kContactFeatures}},
    GrowthMethod{"dcol", "DCol", {.algorithm = GrowthAlgorithm::kConic}},
};

/// Of the methods that have one, the tolerances that time is shown against; each method's own is 1.5e-8 in double.
inline constexpr std::array kTolerances = {1e-3, 1e-4, 1e-6, 1e-10, 1e-12};

/// Whether the tolerance makes a difference to the query.
constexpr bool HasTolerance(const GrowthQuery& query) {
  return query.algorithm != GrowthAlgorithm::kIncremental && !query.is_warm;
}

}  // namespace dgd_bench
