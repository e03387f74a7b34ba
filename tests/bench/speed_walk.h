// Questions about pairs whose types the solver knows, all asked of the same pairs in turns: time beside error.
#pragma once

#include <span>
#include <vector>

#include "bench/class_options.h"
#include "bench/method_figures.h"
#include "bench/speed_pair.h"

namespace dgd_bench {

/// What an answer is worth; its time is not known here.
MethodSample SampleOf(const SpeedAnswer& answer);

/// Every question's figures over a class.
/// @param exact  In how many poses, the first ones, answers are held against the exact one, where there is one
///               (exact_growth_distance.h), which takes longer to find than all that is measured.
std::vector<MethodSummary> MeasureClass(const PairClass& each, const Meshes& meshes,
                                        std::span<const SpeedQuestion> questions, const TimedClassOptions& options,
                                        int exact = 0);

}  // namespace dgd_bench
