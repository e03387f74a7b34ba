// The pairs of a class, in all of their poses: the same ones, in the same order, for every program that measures.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bench/class_options.h"
#include "bench/growth_pair.h"
#include "bench/method_figures.h"

namespace dgd_bench {

/// A progress bar meanwhile.
/// @param visit  Called with the pair in each of its poses, and the index of both together.
void ForEachPose(const PairClass& each, const Meshes& meshes, const ClassOptions& options, MakePair make,
                 const std::function<void(const GrowthPair& pair, std::int64_t index)>& visit);

/// Each query's figures over a class, all queries of a pose in turns.
/// @param exact_poses  In how many poses, the first ones, answers are compared with the exact one, which takes longer
///                     to find than all that is measured.
std::vector<MethodSummary> MeasureClass(const PairClass& each, const Meshes& meshes,
                                        std::span<const GrowthQuery> queries, const ClassOptions& options,
                                        MakePair make, int exact_poses = 0);

}  // namespace dgd_bench
