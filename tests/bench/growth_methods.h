// The ways to a growth distance that are compared, by name.
#pragma once

#include <array>

#include "bench/speed_pair.h"

namespace dgd_bench {

struct GrowthMethod {
  const char* key;    ///< On the command line and in files.
  const char* title;  ///< In tables.
  SpeedQuestion question;
};

inline constexpr auto kWarmStart = SpeedQuestion::Start::kWarm;

/// Ours; the paper's own; and the four that the paper compares with (Sec. VI).
inline constexpr std::array kGrowthMethods = {
    GrowthMethod{"growth", "ours", {}},
    GrowthMethod{"growth_warm", "ours, warm", {.start = kWarmStart}},
    GrowthMethod{"growth_float", "ours, float", {.method = SpeedMethod::kOursFloat}},
    GrowthMethod{"growth_float_warm", "ours, float, warm", {.method = SpeedMethod::kOursFloat, .start = kWarmStart}},
    GrowthMethod{"growth_no_rounding", "ours, radii in the support", {.rounding = false}},
    GrowthMethod{"growth_no_second_order", "ours, no second-order steps", {.second_order = false}},
    GrowthMethod{"plain", "paper's algorithm, plain", {.method = SpeedMethod::kPlain}},
    GrowthMethod{"plain_warm", "paper's algorithm, plain, warm", {.method = SpeedMethod::kPlain, .start = kWarmStart}},
    GrowthMethod{"ie", "IE", {.method = SpeedMethod::kInternalExpanding}},
    GrowthMethod{"inc", "Inc", {.method = SpeedMethod::kIncremental}},
    GrowthMethod{"inc_warm", "Inc, warm", {.method = SpeedMethod::kIncremental, .start = kWarmStart}},
    GrowthMethod{"dcf", "DCF", {.method = SpeedMethod::kContactFeatures}},
    GrowthMethod{"dcol", "DCol", {.method = SpeedMethod::kConic}},
};

/// Of the methods that have one, the tolerances that time is shown against; each method's own is 1.5e-8 in double.
inline constexpr std::array kTolerances = {1e-3, 1e-4, 1e-6, 1e-10, 1e-12};

/// Whether asking for less or more makes a difference to the method.
constexpr bool HasTolerance(const SpeedQuestion& question) {
  return question.method != SpeedMethod::kIncremental && question.start == SpeedQuestion::Start::kCold &&
         question.second_order && question.rounding;
}

}  // namespace dgd_bench
