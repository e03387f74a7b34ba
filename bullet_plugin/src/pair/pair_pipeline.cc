#include "pair/pair_pipeline.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <exception>
#include <optional>
#include <utility>

#include "bullet_conversions.h"
#include "contact_range.h"
#include "dgd/assert.h"
#include "lengths.h"
#include "pair/pair_patch.h"
#include "pair/pair_query.h"
#include "pair/separating_axis.h"
#include "pair/shared_stages.h"
#include "separation_report.h"
#include "shapes/shape_adapter.h"
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

Pose PoseOfSet(const btCollisionObjectWrapper& body) {
  return FromBullet(body.getWorldTransform(), UpAxis(ConvexShapeOf(body)));
}

/// Brings the cache into the order of a query.
void BringIntoOrder(PairCache& cache, const PairBodies& solved, bool is_swapped) {
  if (is_swapped != cache.IsSwapped()) cache.SwapOrder(PoseOfSet(solved.first), PoseOfSet(solved.second));
  for (const auto& hull : {&cache.hull_a(), &cache.hull_b()}) {
    if (*hull != nullptr) (*hull)->Prefetch();
  }
}

/// The second stage: a pair that had no contact is still farther apart along the last normal than it may approach in
/// the step.
std::optional<PairOutcome> TryCachedAxis(const PairState& pair, const PairCache& cache, const PairCall& call) try {
  const Options& options = pair.options();
  if (pair.had_contact || !cache.HasNormal() || !options.warm_start || options.geometry_mode != GeometryMode::kBullet) {
    return std::nullopt;
  }
  const bool is_swapped = ComesBefore(call.bodies.second, call.bodies.first);
  if (is_swapped != cache.IsSwapped()) return std::nullopt;
  const PairBodies solved = call.bodies.InOrder(is_swapped);
  const BoundedBody bounded_a(*solved.first.getCollisionObject()), bounded_b(*solved.second.getCollisionObject());
  const btVector3 normal_in_a = InBulletAxes(cache.NormalInA(), UpAxis(ConvexShapeOf(solved.first)));
  const btVector3 normal = solved.first.getWorldTransform().getBasis() * normal_in_a;
  const double contact_distance = ContactDistance(options, pair.manifold.BreakingThreshold(), call.output);
  const double separation = SeparationAlong({solved.first, bounded_a}, {solved.second, bounded_b}, normal);
  // What memory is slow to bring is read last.
  if (!(separation > contact_distance)) return std::nullopt;
  const bool counts_motion = pair.is_for_step && options.speculative_contacts;
  const PairMotion motion = counts_motion ? MotionOfStep(pair.manifold, bounded_a, bounded_b, call.info) : PairMotion();
  if (motion.MayApproachBy(separation, FromBullet(normal))) return std::nullopt;
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
    const QueryLimits limits{range, PatchSettingsOf(options, pair.manifold, range, is_user_query), is_user_query,
                             GetsNearestOnly(call, pair.is_for_step)};
    BringIntoOrder(cache, solved, is_swapped);
    const PosedShape a = AdaptBody(pair.narrowphase, solved.first, cache.hull_a(), is_user_query);
    const PosedShape b = AdaptBody(pair.narrowphase, solved.second, cache.hull_b(), is_user_query);
    PairQuery query(options, a, b, limits, NegligibleDistance(pair.manifold.BreakingThreshold()), contacts.motion,
                    cache.warm_start());
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

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
