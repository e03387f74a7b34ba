#include "pair/pair_pipeline.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "contact_range.h"
#include "dgd/assert.h"
#include "pair/pair_patch.h"
#include "pair/pair_query.h"
#include "pair/separating_axis.h"
#include "pair/shared_stages.h"
#include "user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Exchanges the roles of the two shapes.
void Swap(PairContacts& contacts) {
  for (int i = 0; i < contacts.patch.size; ++i) {
    dgd::ContactPoint<double>& point = contacts.patch.points[static_cast<std::size_t>(i)];
    std::swap(point.on_1, point.on_2);
  }
  contacts.normal = -contacts.normal;
}

/// The second stage: a pair that had no contact is still farther apart along the last normal than it may approach in
/// the step.
std::optional<PairOutcome> TryCachedAxis(const PairState& pair, const PairCache& cache, const PairCall& call) {
  const Options& options = pair.options();
  const double contact_distance = ContactDistance(options, pair.manifold.BreakingThreshold(), call.output);
  return TryCachedAxis(pair, cache, call.bodies, contact_distance, [&](const BoundedBody& a, const BoundedBody& b) {
    const bool counts = pair.is_for_step && options.speculative_contacts;
    return counts ? MotionOfStep(pair.manifold, a, b, call.info) : PairMotion();
  });
}

/// The third stage, and the writing of what it has found.
PairOutcome SolveContacts(PairState& pair, PairCache& cache, const PairCall& call) {
  const Options& options = pair.options();
  const bool is_swapped = ComesBefore(call.bodies.second, call.bodies.first);
  const PairBodies solved = call.bodies.InOrder(is_swapped);
  const bool is_user_query = IsUserQuery(call.output);
  PairContacts contacts;
  if (pair.is_for_step) {
    const BoundedBody bounded_a(*solved.first.getCollisionObject()), bounded_b(*solved.second.getCollisionObject());
    contacts.motion = MotionOfStep(pair.manifold, bounded_a, bounded_b, call.info);
  }
  const PairOutcome outcome = CatchFailures([&] {
    const ContactRange range = RangeOfContacts(options, pair.manifold, contacts.motion, call.info, call.output);
    const QueryLimits limits{range, PatchSettingsOf(options, pair.manifold, range, is_user_query), is_user_query};
    PairQuery query(pair.narrowphase, solved, is_swapped, limits, pair.manifold.BreakingThreshold(), contacts.motion,
                    cache);
    return query.FindContacts(contacts);
  });
  if (outcome.fallback) return outcome;
  DGD_ASSERT(cache.IsSwapped() == is_swapped);
  if (is_swapped) Swap(contacts);
  return WriteContacts(pair, call, contacts, is_swapped, outcome);
}

}  // namespace

PairOutcome RunPipeline(PairState& pair, PairCache& cache, const PairCall& call) {
  const auto [a, b] = call.bodies.InOrder(cache.IsSwapped());
  if (const auto outcome = TryRecycledContacts(pair, {a, cache.hull_a()}, {b, cache.hull_b()}, call)) return *outcome;
  if (const auto outcome = TryCachedAxis(pair, cache, call)) return *outcome;
  const PairOutcome outcome = SolveContacts(pair, cache, call);
  return outcome.fallback ? SolveByBullet(pair, call, *outcome.fallback) : outcome;
}

PairOutcome FindTriangleContacts(PairState& pair, PairCache& cache, const PairBodies& convex_and_triangle,
                                 const Vector3& normal, const TriangleQuery& triangle_query, PairContacts& contacts) {
  contacts.patch.size = 0;
  contacts.moment = {};
  const bool is_swapped = ComesBefore(convex_and_triangle.second, convex_and_triangle.first);
  DGD_ASSERT(!pair.manifold.IsOwn());
  const PairMotion& motion = is_swapped ? triangle_query.reverse_motion : triangle_query.motion;
  const double contact_distance = std::max(triangle_query.limits.range.touching, 0.0);
  const auto get_motion = [&](const BoundedBody&, const BoundedBody&) -> const PairMotion& { return motion; };
  if (const auto outcome = TryCachedAxis(pair, cache, convex_and_triangle, contact_distance, get_motion))
    return *outcome;
  const PairOutcome outcome = CatchFailures([&] {
    QueryLimits limits = triangle_query.limits;
    limits.triangle_normal = normal;
    PairQuery query(pair.narrowphase, convex_and_triangle.InOrder(is_swapped), is_swapped, limits,
                    pair.manifold.BreakingThreshold(), motion, cache);
    return query.FindContacts(contacts);
  });
  if (outcome.fallback) {
    contacts.patch.size = 0;
    return outcome;
  }
  pair.had_contact = contacts.patch.size > 0;
  if (is_swapped) Swap(contacts);
  return outcome;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
