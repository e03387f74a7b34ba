// What a pair of convex shapes goes through in a step, stage by stage: pair_pipeline.cc lists the stages.
#pragma once

#include "dgd_bullet/linkage.h"
#include "pipeline/face_contacts.h"
#include "pipeline/pair_cache.h"
#include "pipeline/pair_outcome.h"
#include "pipeline/pair_patch.h"
#include "pipeline/pair_state.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Finds the pair's contacts, and makes its manifold's points theirs.
PairOutcome RunPipeline(PairState& pair, PairCache& cache, const PairCall& call);

/// Finds the contacts of a convex body with a triangle of a mesh, and writes them nowhere: the mesh chooses among those
/// of all triangles.
PairOutcome FindTriangleContacts(PairState& pair, PairCache& cache, const PairBodies& bodies,
                                 const TriangleQuery& triangle_query, PairContacts& contacts);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
