// What a pair of convex shapes goes through in a step, stage by stage: pair_pipeline.cc lists the stages.
#pragma once

#include "dgd_bullet/linkage.h"
#include "pair/pair_cache.h"
#include "pair/pair_patch.h"
#include "pair/pair_query.h"
#include "pair/pair_state.h"
#include "pair_outcome.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Finds the pair's contacts, and makes its manifold's points theirs.
PairOutcome RunPipeline(PairState& pair, PairCache& cache, const PairCall& call);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
