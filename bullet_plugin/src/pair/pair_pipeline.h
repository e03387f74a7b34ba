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

/// A mesh's query of each of its triangles.
struct TriangleQuery {
  const PairMotion &motion, &reverse_motion;  ///< Motion of the convex body and the mesh, and in the other order.
  QueryLimits limits;
  double flush;  ///< Metres: NegligibleDistance().
};

/// Finds the pair's contacts, and makes its manifold's points theirs.
PairOutcome RunPipeline(PairState& pair, PairCache& cache, const PairCall& call);

/// Finds the contacts of a convex body with a triangle of a mesh, and writes them nowhere: the mesh chooses among those
/// of all triangles.
/// @param normal  The triangle's unit normal, on either side; world; zero if it has no area.
PairOutcome FindTriangleContacts(PairState& pair, PairCache& cache, const PairBodies& convex_and_triangle,
                                 const Vector3& normal, const TriangleQuery& triangle_query, PairContacts& contacts);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
