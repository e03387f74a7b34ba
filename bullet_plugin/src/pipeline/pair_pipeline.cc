#include "pipeline/pair_pipeline.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "dgd/assert.h"
#include "pipeline/contact_range.h"
#include "pipeline/pair_distance.h"
#include "pipeline/pair_patch.h"
#include "pipeline/pair_query.h"
#include "pipeline/separating_axis.h"
#include "pipeline/shared_stages.h"
#include "pipeline/user_query.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Bounds that roundoff leaves farther apart than the tolerance still prove a result if they agree to this: 5
/// micrometres in half a metre, a thousandth of what Bullet's float pairs are off by. Beyond it, the pair is Bullet's.
constexpr double kCertifiedGap = 1e-5;

bool IsCertified(const Contact& contact) {
  switch (contact.status) {
    case dgd::Status::kOptimal:
    case dgd::Status::kSeparated:
    case dgd::Status::kCoincidentCenters:
      return true;
    case dgd::Status::kStalled:
    case dgd::Status::kIterationLimit:
      return contact.RelativeGap() <= kCertifiedGap;
    default:
      return false;
  }
}

/// The reference face of the last contact.
std::optional<Contact> TryReferenceFace(PairQuery& query) {
  PairCache& cache = query.cache;
  if (!query.wants_least_translation || cache.kind() != PairCache::Kind::kReferenceFace) return std::nullopt;
  std::optional<Contact> contact =
      UpdateOnReferenceFace(query.shape_a, query.shape_b, query.settings, query.options.angular_tolerance,
                            cache.ReferenceSide(), cache.warm_start(), query.facing);
  if (!contact) return std::nullopt;
  query.stage = PairOutcome::Stage::kUpdated;
  query.has_facing = query.facing.overlap.size > 0;
  return contact;
}

/// The distance of the cores, updated from the points that the last query ended at.
std::optional<Contact> TryDistancePoints(PairQuery& query) {
  PairCache& cache = query.cache;
  if (!query.wants_least_translation || !cache.CanUpdateDistance()) return std::nullopt;
  std::optional<Contact> contact = UpdateDistance(query.shape_a, query.shape_b, query.settings, cache.warm_start());
  if (!contact) return std::nullopt;
  cache.Set(PairCache::Kind::kDistancePoints);
  query.found_by = PairCache::Kind::kDistancePoints;
  query.stage = PairOutcome::Stage::kUpdated;
  return contact;
}

/// The growth distance. TurnNormal() turns its normal to that of least translation where there is a contact.
Contact SolveGrowthDistance(PairQuery& query) {
  PairCache& cache = query.cache;
  MoveCentersTogether(query.shape_a, query.shape_b);
  const Contact contact = dgd::GrowthDistance(query.shape_a.set, query.shape_a.pose, query.shape_b.set,
                                              query.shape_b.pose, query.settings, &cache.warm_start());
  const bool is_apart = contact.status == dgd::Status::kSeparated || contact.separation > 0;
  cache.Set(is_apart ? PairCache::Kind::kSeparatingAxis : PairCache::Kind::kPortal);
  query.stage = PairOutcome::Stage::kSolved;
  return contact;
}

/// The stages that search the contact of two shapes, each from where the last query left off.
Contact FindContact(PairQuery& query) {
  if (const auto contact = TryReferenceFace(query)) return *contact;
  if (const auto contact = TryDistancePoints(query)) return *contact;
  return SolveGrowthDistance(query);
}

PairOutcome OutcomeOf(const PairQuery& query, const Contact& contact, int patch_size) {
  PairOutcome outcome{
      .iterations = contact.iterations, .patch_size = static_cast<std::uint8_t>(patch_size), .stage = query.stage};
  if (contact.status == dgd::Status::kSeparated) {
    outcome.stage = PairOutcome::Stage::kSeparated;
  } else if (query.stage == PairOutcome::Stage::kSolved && contact.status != dgd::Status::kCoincidentCenters) {
    outcome.gap = contact.RelativeGap();
  }
  return outcome;
}

/// Exchanges the roles of the two shapes.
void Swap(PairContacts& contacts) {
  for (int i = 0; i < contacts.patch.size; ++i) {
    dgd::ContactPoint<double>& point = contacts.patch.points[static_cast<std::size_t>(i)];
    std::swap(point.on_1, point.on_2);
  }
  contacts.normal = -contacts.normal;
}

/// The contact, and from it the patch.
PairOutcome FindContacts(PairQuery& query, PairContacts& contacts) {
  Contact contact = FindContact(query);
  DGD_ASSERT(contact.iterations >= 0);
  if (!IsCertified(contact)) return {.fallback = FallbackOf(contact.status)};
  contacts.patch = FindContactPatch(query, contact, contacts.is_passing);
  contacts.normal = contact.normal;
  DGD_ASSERT(contacts.patch.size == 0 || IsUnit(contacts.normal));
  return OutcomeOf(query, contact, contacts.patch.size);
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

/// The third to fifth stages, and the writing of what they have found.
PairOutcome SolveContacts(PairState& pair, PairCache& cache, const PairCall& call) {
  const Options& options = pair.options();
  const bool is_swapped = ComesBefore(call.bodies.second, call.bodies.first);
  const PairBodies solved = call.bodies.InOrder(is_swapped);
  const bool is_user_query = IsUserQuery(call.output);
  PairContacts contacts;
  const PairOutcome outcome = CatchFailures([&] {
    PairQuery query(pair.narrowphase, solved, is_swapped, is_user_query, pair.manifold.BreakingThreshold(),
                    contacts.motion, cache);
    if (pair.is_for_step) {
      const BoundedBody bounded_a(*solved.first.getCollisionObject()), bounded_b(*solved.second.getCollisionObject());
      contacts.motion = MotionOfStep(pair.manifold, bounded_a, bounded_b, call.info);
    }
    const ContactRange range = RangeOfContacts(options, pair.manifold, contacts.motion, call.output);
    query.SetLimits(range, PatchSettingsOf(options, pair.manifold, range, is_user_query));
    return FindContacts(query, contacts);
  });
  if (outcome.fallback) return outcome;
  DGD_ASSERT(cache.IsSwapped() == is_swapped);
  if (is_swapped) Swap(contacts);
  return WriteContacts(pair, call, contacts, is_swapped, cache.ReferenceSide(), outcome);
}

}  // namespace

PairOutcome RunPipeline(PairState& pair, PairCache& cache, const PairCall& call) {
  const auto [a, b] = call.bodies.InOrder(cache.IsSwapped());
  if (const auto outcome = TryRecycledContacts(pair, {a, cache.hull_a()}, {b, cache.hull_b()}, call)) return *outcome;
  if (const auto outcome = TryCachedAxis(pair, cache, call)) return *outcome;
  const PairOutcome outcome = SolveContacts(pair, cache, call);
  return outcome.fallback ? SolveByBullet(pair, call, *outcome.fallback) : outcome;
}

PairOutcome FindTriangleContacts(PairState& pair, PairCache& cache, const PairBodies& bodies,
                                 const TriangleQuery& triangle_query, PairContacts& contacts) {
  contacts.patch.size = 0;
  contacts.is_passing = false;
  const bool is_swapped = ComesBefore(bodies.second, bodies.first);
  DGD_ASSERT(!pair.manifold.IsOwn() && !(triangle_query.flush < 0));
  const PairMotion& motion = is_swapped ? triangle_query.reverse_motion : triangle_query.motion;
  const double contact_distance = std::max(triangle_query.range.touching, 0.0);
  const auto get_motion = [&](const BoundedBody&, const BoundedBody&) -> const PairMotion& { return motion; };
  if (const auto outcome = TryCachedAxis(pair, cache, bodies, contact_distance, get_motion)) return *outcome;
  const PairOutcome outcome = CatchFailures([&] {
    PairQuery query(pair.narrowphase, bodies.InOrder(is_swapped), is_swapped, triangle_query.is_user_query,
                    pair.manifold.BreakingThreshold(), motion, cache);
    query.is_triangle = true;
    query.SetLimits(triangle_query.range, triangle_query.patch_settings);
    return FindContacts(query, contacts);
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
