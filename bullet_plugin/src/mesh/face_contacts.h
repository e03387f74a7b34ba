// The contacts of a convex body with a triangle of a mesh along the triangle's own normal.
#pragma once

#include "ahead/meeting.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pair/pair_cache.h"
#include "pair/pair_pipeline.h"
#include "pair/pair_state.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The contacts along a normal.
struct FaceContacts {
  dgd::ContactPatch<double> patch;
  Vector3 normal = Vector3::Zero();  ///< Normal from the body to the triangle; unit, world.
};

/// The contacts of a body and a triangle along the triangle's normal, after their pair has been solved in this step:
/// where they are, or where they meet. None if the body is not over the triangle there. Does not throw.
/// @param normal  The triangle's unit normal, on either side; world.
/// @param moment  PairContacts::moment of the pair.
FaceContacts FindTriangleFaceContacts(SharedState& narrowphase, PairCache& cache, const PairBodies& convex_and_triangle,
                                      const Vector3& normal, const Moment& moment, const TriangleQuery& query);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
