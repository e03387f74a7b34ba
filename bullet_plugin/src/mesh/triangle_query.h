// A convex body's queries of the triangles of a mesh, one after the other: what they share is read once a step.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "manifold/mesh_triangle.h"
#include "mesh/triangle_states.h"
#include "pair/pair_cache.h"
#include "pair/pair_query.h"
#include "pair_motion.h"
#include "pair_outcome.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What a step wants of the contacts with each triangle.
struct MeshQuery {
  const PairMotion& motion;  ///< Motion of the convex body and the mesh.
  QueryLimits limits;
  double flush;  ///< Metres: NegligibleDistance().
};

class TriangleQuery {
 public:
  /// Reads the convex body's shape. Throws what AdaptShape() does.
  /// @param hull   In and out: see AdaptShape().
  /// @param query  Outlives this, as the mesh does.
  TriangleQuery(SharedState& narrowphase, const PairBodies& convex_and_mesh, const MeshQuery& query,
                PairCache::Hull& hull);

  /// Whether the body is on one side of a triangle's plane and does not come near it in the step.
  /// @param normal  The triangle's unit normal, on either side; world; zero if it has no area.
  bool IsOutOfPlane(const MeshTriangle& triangle, const Vector3& normal) const;

  /// Whether the body is a ball, whose nearest point is its only one: all that it meets next has a contact already.
  bool IsOfBall() const { return TouchAlongCenters(convex_, triangle_); }

  /// Turns to a triangle, which the other members are about. Throws std::invalid_argument if it is not finite.
  void Place(const MeshTriangle& triangle, const Vector3& normal);

  /// Finds the contacts with the triangle.
  /// @param contacts  Out; an empty patch if there are none.
  /// @return why it is not solved, if it is not.
  PairOutcome FindContacts(TriangleState& state, PairContacts& contacts);

  /// The contacts along the triangle's own normal, after FindContacts() in the same step: where the body is, or where
  /// it meets the triangle. None if the body is not over the triangle there.
  /// @param contacts  Out: patch and normal.
  void FindFaceContacts(const TriangleState& state, PairContacts& contacts) const;

 private:
  bool IsApartAlong(const Vector3& normal, const Vector3& on_triangle, double distance) const;
  bool IsTowards(const TriangleState& state) const;

  const Options& options_;
  const MeshQuery& query_;
  QueryLimits limits_;  // With the triangle's normal.
  const Pose mesh_;
  const double margin_;  // The triangles' radius, metres.
  const PosedShape convex_;
  const Vector3 center_;   // The convex body's, world.
  const double inradius_;  // Of a ball about it inside of the body, metres.
  PosedShape triangle_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
