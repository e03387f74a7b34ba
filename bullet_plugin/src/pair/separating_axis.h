// The second stage of a pair: whether bodies that were apart still are. It is the result for most pairs of a
// broadphase, and reads as little as it can.
//
// Bullet's own support functions, evaluated for one direction, are exact but for the roundoff of its precision, for
// which there is room between bodies that are apart. Nothing else of the shapes is read, and nothing cached of them has
// to be compared with what they are now: in a heap of thousands, memory is what pairs wait for.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <exception>
#include <optional>

#include "dgd_bullet/linkage.h"
#include "pair/pair_cache.h"
#include "pair/pair_state.h"
#include "pair_motion.h"
#include "pair_outcome.h"
#include "separation_report.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// A convex shape where it is now, as part of a body or as all of it.
struct PlacedShape {
  const btCollisionObjectWrapper& wrapper;
  const BoundedBody& body;
};

/// A lower bound of the distance of two convex shapes, with their margins, along a direction; metres, with allowance
/// for roundoff. Minus infinity where that would take longer than the solver, for large hulls and convex meshes; and
/// for what is no shape or no pose.
/// @param normal  From A to B, of unit length within roundoff, world.
double SeparationAlong(const PlacedShape& shape_a, const PlacedShape& shape_b, const btVector3& normal);

/// Larger hulls are left to the solver, which climbs them. A point takes up to 12 instructions here, on either side;
/// the solver takes 2000 in all (callgrind, hulls of 8 to 20 points).
constexpr int kMaxScannedPoints = 64;

/// The result of a pair that the cached axis separates.
constexpr PairOutcome kApart{.iterations = 1, .stage = PairOutcome::Stage::kSeparated};

/// Tries the last query's normal as a separating axis of a pair that had no contact.
/// @param contact_distance  Bodies that are nearer than this may have contacts; metres.
/// @param get_motion  PairMotion(const BoundedBody& a, const BoundedBody& b), in the order that the shapes are solved
///                    in.
template <class GetMotion>
std::optional<PairOutcome> TryCachedAxis(const PairState& pair, const PairCache& cache, const PairBodies& bodies,
                                         double contact_distance, const GetMotion& get_motion) try {
  const Options& options = pair.options();
  if (pair.had_contact || !cache.HasNormal() || !options.warm_start || options.geometry_mode != GeometryMode::kBullet) {
    return std::nullopt;
  }
  const bool is_swapped = ComesBefore(bodies.second, bodies.first);
  if (is_swapped != cache.IsSwapped()) return std::nullopt;
  const PairBodies solved = bodies.InOrder(is_swapped);
  const BoundedBody bounded_a(*solved.first.getCollisionObject()), bounded_b(*solved.second.getCollisionObject());
  const btVector3 normal_in_a = InBulletAxes(cache.NormalInA(), UpAxis(ConvexShapeOf(solved.first)));
  const btVector3 normal = solved.first.getWorldTransform().getBasis() * normal_in_a;
  const double separation = SeparationAlong({solved.first, bounded_a}, {solved.second, bounded_b}, normal);
  // What memory is slow to bring is read last.
  if (!(separation > contact_distance)) return std::nullopt;
  if (get_motion(bounded_a, bounded_b).MayApproachBy(separation, FromBullet(normal))) return std::nullopt;
  // The manifold may have contacts of Bullet's own algorithm.
  if (pair.manifold.IsOwn() && !pair.manifold.IsEmpty()) return std::nullopt;
  if (separation_report != nullptr) {
    separation_report->is_swapped = is_swapped;
    separation_report->separation = separation;
    separation_report->contact_distance = contact_distance;
    separation_report->normal_in_a = normal_in_a;
    separation_report->normal_w = normal;
  }
  return kApart;
} catch (const std::exception&) {
  return std::nullopt;  // A user's shape has thrown: the next stage reports it.
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
