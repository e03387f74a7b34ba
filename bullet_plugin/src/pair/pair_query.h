// A query of two convex shapes in one step.
#pragma once

#include "contact_range.h"
#include "dgd/contact/facing_faces.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "pair/pair_cache.h"
#include "pair/pair_patch.h"
#include "pair/pair_state.h"
#include "pair_motion.h"
#include "pair_outcome.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The set of a body's convex shape in its pose. Throws what AdaptShape() does.
/// @param hull      In and out: the hull of a hull of points.
/// @param for_user  Whether this is for a user's own query.
PosedShape AdaptBody(SharedState& narrowphase, const btCollisionObjectWrapper& body, PairCache::Hull& hull,
                     bool for_user);

/// What is wanted of a pair.
struct QueryLimits {
  ContactRange range;
  dgd::PatchSettings<double> patch_settings;
  bool is_user_query;            ///< Whether a user queries the contacts themselves (user_query.h).
  bool is_nearest_only = false;  ///< Whether that gets the nearest point alone.
  /// If B is a triangle of a mesh, its unit normal on either side, world; else zero.
  Vector3 triangle_normal = Vector3::Zero();
};

/// The shapes A and B, in the order that they are solved in, and what is wanted of them.
class PairQuery {
 public:
  /// @param limits      Outlives this.
  /// @param flush       Metres: NegligibleDistance().
  /// @param motion      The motion of A and B in the step; outlives this.
  /// @param warm_start  In and out: that of the pair in this order.
  PairQuery(const Options& options, const PosedShape& shape_a, const PosedShape& shape_b, const QueryLimits& limits,
            double flush, const PairMotion& motion, dgd::WarmStart<double>& warm_start);

  /// Finds the contact and from it the patch.
  /// @param contacts  Out: all but the motion, the normal from A to B.
  /// @return the reason, if the contact is not certified.
  PairOutcome FindContacts(PairContacts& contacts);

 private:
  /// The growth distance from where it left off; an app's own query, and bodies deep in each other, get the least
  /// translation.
  Contact FindContact();
  /// The least translation by the last normal, without a growth distance: the fewest evaluations of support points.
  Contact FindDistance();
  /// Turns the contact of shapes that overlap to the triangle's own normal, if they overlap by less along that.
  void TurnToTriangle(Contact& contact) const;
  /// The patch of a certified contact.
  /// @param contact  In and out: for bodies that meet within the step, the one of where they do.
  void FindPatch(Contact& contact, PairContacts& contacts);
  PairOutcome OutcomeOf(const Contact& contact, int patch_size) const;

  const Options& options_;
  dgd::WarmStart<double>& warm_start_;
  PosedShape shape_a_, shape_b_;
  const QueryLimits& limits_;
  const PatchRules rules_;
  dgd::Settings<double> settings_;
  const bool is_along_centers_;  // See TouchAlongCenters().
  PairOutcome::Stage stage_ = PairOutcome::Stage::kSolved;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
