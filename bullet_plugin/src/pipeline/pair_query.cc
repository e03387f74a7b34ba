#include "pipeline/pair_query.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <utility>

#include "dgd/assert.h"
#include "pipeline/pair_distance.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Relative tolerance of a user's own query, as by contactTest() and contactPairTest(); and how many times the
/// evaluations of a step its least translation may take: 64 are an expanding polytope, which may start from scratch.
constexpr double kExact = 1e-12;
constexpr int kPatience = 5;

Pose PoseOfSet(const btCollisionObjectWrapper& body) {
  return FromBullet(body.getWorldTransform(), UpAxis(ConvexShapeOf(body)));
}

/// The cache in the order of a query.
PairCache& InOrder(PairCache& cache, const PairBodies& solved, bool is_swapped) {
  if (is_swapped != cache.IsSwapped()) cache.SwapOrder(PoseOfSet(solved.first), PoseOfSet(solved.second));
  for (const auto& hull : {&cache.hull_a(), &cache.hull_b()}) {
    if (*hull != nullptr) (*hull)->Prefetch();
  }
  return cache;
}

}  // namespace

PosedShape AdaptBody(Narrowphase& narrowphase, const btCollisionObjectWrapper& body, PairCache::Hull& hull,
                     bool for_user) {
  return AdaptShape(ConvexShapeOf(body), body.getWorldTransform(), narrowphase.options().geometry_mode,
                    narrowphase.hulls(), hull, narrowphase.HullUseFor(for_user));
}

PairQuery::PairQuery(Narrowphase& narrowphase, const PairBodies& solved, bool is_swapped, bool for_user,
                     double breaking_threshold, const PairMotion& motion_of_pair, PairCache& cache_of_pair)
    : options(narrowphase.options()),
      cache(InOrder(cache_of_pair, solved, is_swapped)),
      motion(motion_of_pair),
      shape_a(AdaptBody(narrowphase, solved.first, cache.hull_a(), for_user)),
      shape_b(AdaptBody(narrowphase, solved.second, cache.hull_b(), for_user)),
      is_user_query(for_user),
      wants_least_translation(options.normal_mode == NormalMode::kLeastTranslation),
      flush(NegligibleDistance(breaking_threshold)) {
  if (!options.warm_start) cache.Clear();
}

void PairQuery::SetLimits(const ContactRange& contact_range, const dgd::PatchSettings<double>& settings_of_patch) {
  DGD_ASSERT(settings_of_patch.max_points >= 1 &&
             settings_of_patch.max_points <= dgd::ContactPatch<double>::kMaxPoints);
  DGD_ASSERT(!(contact_range.limit < contact_range.touching) && !(settings_of_patch.spacing < 0));
  range = contact_range;
  patch_settings = settings_of_patch;
  settings.relative_tolerance =
      is_user_query ? std::min(kExact, options.relative_tolerance) : options.relative_tolerance;
  settings.max_iterations = options.max_iterations;
  settings.separation_limit = SeparationLimit(range, motion);
}

void PairQuery::TurnNormal(Contact& contact) {
  if (!wants_least_translation || stage != PairOutcome::Stage::kSolved || std::exchange(is_turned, true)) return;
  DGD_ASSERT(!has_facing);
  if (is_user_query) settings.max_iterations *= kPatience;
  const bool can_update = TurnToLeastTranslation(shape_a, shape_b, settings, cache.warm_start(), contact);
  cache.Set(can_update ? PairCache::Kind::kSeparatingAxis : PairCache::Kind::kPortal);
}

void PairQuery::FindFacing(const Contact& contact) {
  if (std::exchange(has_facing, true)) return;
  DGD_ASSERT(IsUnit(contact.normal));
  dgd::FindFacingFaces(shape_a.set, shape_a.pose, shape_b.set, shape_b.pose, contact, options.angular_tolerance,
                       facing);
  // A reference face can be followed while the cores are apart.
  const bool are_apart = contact.separation + shape_a.set.Radius() + shape_b.set.Radius() > 0;
  if (!wants_least_translation || !cache.CanUpdateDistance() || !are_apart) return;
  const bool had_face = cache.kind() == PairCache::Kind::kReferenceFace;
  cache.SetReferenceFace(dgd::ReferenceSideOf(facing), had_face ? PairCache::Kind::kSeparatingAxis : cache.kind());
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
