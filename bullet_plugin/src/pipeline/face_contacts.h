// The contacts of a convex body with a triangle of a mesh along the triangle's own normal.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/contact_range.h"
#include "pipeline/pair_cache.h"
#include "pipeline/pair_motion.h"
#include "pipeline/pair_state.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A mesh's query of each of its triangles.
struct TriangleQuery {
  const PairMotion &motion, &reverse_motion;  ///< Motion of the convex body and the mesh, and in the other order.
  ContactRange range;
  dgd::PatchSettings<double> patch_settings;
  double angular_tolerance;  ///< Radians: Options::angular_tolerance.
  double flush;              ///< Metres: NegligibleDistance().
  bool is_user_query;        ///< Whether a user queries the contacts themselves.
};

/// The contacts along a normal.
struct FaceContacts {
  dgd::ContactPatch<double> patch;
  Vector3 normal = Vector3::Zero();  ///< From the body to the triangle; unit, world.
  Vector3 way = Vector3::Zero();     ///< Displacement of the points across the normal until they touch; metres.
};

/// Contacts where the body is over the triangle now, or when its motion brings it to the triangle's plane; none
/// otherwise.
/// @param normal  The triangle's normal, from the body's side of it to the other; unit, world.
FaceContacts FindFaceContacts(PosedShape shape, const PosedShape& triangle, const Vector3& normal,
                              const TriangleQuery& query);

/// FindFaceContacts() of a body and a triangle whose pair has been solved in this step. Does not throw.
/// @param normal  The triangle's unit normal, on either side; world.
FaceContacts FindTriangleFaceContacts(Narrowphase& narrowphase, PairCache& cache, const PairBodies& convex_and_triangle,
                                      const Vector3& normal, const TriangleQuery& query);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
