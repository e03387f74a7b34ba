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
std::vector<MethodSummary> MeasureClass(const PairClass& each, const Meshes& meshes,
                                        std::span<const SpeedQuestion> questions, const TimedClassOptions& options);

}  // namespace dgd_bench
