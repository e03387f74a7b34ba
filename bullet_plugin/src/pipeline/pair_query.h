// A query of two convex shapes in one step.
#pragma once

#include "dgd/any_set.h"
#include "dgd/assert.h"
#include "dgd/contact/facing_faces.h"
#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"
#include "pipeline/contact_range.h"
#include "pipeline/pair_cache.h"
#include "pipeline/pair_motion.h"
#include "pipeline/pair_outcome.h"
#include "pipeline/pair_state.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The set of a body's convex shape in its pose. Throws what AdaptShape() does.
/// @param hull      In and out: the hull of a hull of points.
/// @param for_user  Whether this is for a user's own query.
PosedShape AdaptBody(Narrowphase& narrowphase, const btCollisionObjectWrapper& body, PairCache::Hull& hull,
                     bool for_user);

/// The shapes A and B, in the order that they are solved in, what is wanted of them, and what the stages have found.
struct PairQuery {
  /// Reads the shapes, and brings the cache into their order. Throws what AdaptShape() does.
  /// @param solved         The bodies in that order.
  /// @param for_user       Whether this is a user's own query, for the contacts themselves (user_query.h).
  /// @param motion_of_pair  Of A and B in the step; may be set up to SetLimits().
  PairQuery(Narrowphase& narrowphase, const PairBodies& solved, bool is_swapped, bool for_user,
            double breaking_threshold, const PairMotion& motion_of_pair, PairCache& cache_of_pair);

  void SetLimits(const ContactRange& contact_range, const dgd::PatchSettings<double>& settings_of_patch);

  /// Turns the normal to that of least translation, if that is wanted and the stage that found the contact has not.
  void TurnNormal(Contact& contact);

  /// Finds the faces that the shapes show each other along the contact's normal, if no stage has.
  void FindFacing(const Contact& contact);

  /// Leaves no reference face to the next query, for a contact that is not on it.
  void DropReferenceFace() {
    DGD_ASSERT(found_by != PairCache::Kind::kReferenceFace);
    if (cache.kind() == PairCache::Kind::kReferenceFace) cache.Set(found_by);
  }

  const Options& options;
  PairCache& cache;
  const PairMotion& motion;
  PosedShape shape_a, shape_b;
  const bool is_user_query;
  bool is_triangle = false;            ///< Whether B or A is one of many triangles of a mesh.
  const bool wants_least_translation;  ///< Whether contacts have the normal of least translation.
  const double flush;                  ///< NegligibleDistance(), metres.
  ContactRange range;
  dgd::PatchSettings<double> patch_settings;
  dgd::Settings<double> settings;

  // What the stages have found.
  PairOutcome::Stage stage = PairOutcome::Stage::kSolved;
  PairCache::Kind found_by = PairCache::Kind::kSeparatingAxis;  ///< The kind without the reference face.
  bool is_turned = false;           ///< Whether TurnNormal() has been called on the growth distance's normal.
  bool has_facing = false;          ///< Whether `facing` is set; the proof of a signed distance brings it along.
  dgd::FacingFaces<double> facing;  ///< The faces along the contact's normal.
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
