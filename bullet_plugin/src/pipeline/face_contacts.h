// The contacts of a convex body with a triangle of a mesh along the triangle's own normal.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/pair_contacts.h"
#include "pipeline/pair_motion.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What a mesh wants to know of each of its triangles.
struct TriangleQuery {
  const PairMotion &motion, &reverse_motion;  ///< Of the convex body and the mesh, and of the mesh and the body.
  ContactRange range;
  dgd::PatchSettings<double> patch_settings;
  double angular_tolerance;  ///< Radians: Options::angular_tolerance.
  double flush;              ///< Metres: NegligibleDistance().
  bool is_asked;             ///< By an app, for the contacts themselves.
};

/// Along a normal.
struct FaceContacts {
  dgd::ContactPatch<double> patch;
  Vector3 normal = Vector3::Zero();  ///< From the body to the triangle; unit, world.
  Vector3 way = Vector3::Zero();     ///< Of the points across the normal until they touch; metres.
};

/// Contacts where the body is over the triangle now, or when its motion brings it to the triangle's plane; none
/// otherwise. Throws nothing of its own.
/// @param normal  Of the triangle, from the body's side of it to the other; unit, world.
FaceContacts FindFaceContacts(PosedShape shape, const PosedShape& triangle, const Vector3& normal,
                              const TriangleQuery& query);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
