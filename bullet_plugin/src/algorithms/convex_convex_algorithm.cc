#include "algorithms/convex_convex_algorithm.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "algorithms/prefetch.h"
#include "algorithms/shape_sweep.h"
#include "conditioning/contact_recycling.h"
#include "conditioning/speculative_contacts.h"
#include "dgd_bullet/recorder.h"
#include "pipeline/contact_distance.h"
#include "pipeline/pair_contacts.h"
#include "pipeline/pair_distance.h"
#include "pipeline/pair_motion.h"
#include "pipeline/pair_order.h"
#include "pipeline/pair_patch.h"
#include "pipeline/separating_axis.h"
#include "pipeline/user_query.h"
#include "shapes/shape_adapter.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Bounds that rounding keeps farther apart than the tolerance still prove a result if they agree to this: 5
/// micrometres in half a metre, a thousandth of what Bullet's float pairs are off by. Beyond it, Bullet answers.
constexpr double kCertifiedGap = 1e-5;

/// Relative tolerance of the answer to an app that asks, as contactTest() and contactPairTest() do; and how many times
/// the evaluations of a step its least translation may take: 64 are an expanding polytope, which may be begun anew.
constexpr double kExact = 1e-12;
constexpr int kPatience = 5;

/// Cosine of the last normal to a triangle's own above which the last one shows on which side of the triangle a body
/// is: within 6 degrees of the triangle's plane, the side would be chance.
constexpr double kLeastFacing = 0.1;

bool IsCertified(const dgd::Result<double>& result) {
  switch (result.status) {
    case dgd::Status::kOptimal:
    case dgd::Status::kCoincidentCenters:
      return true;
    case dgd::Status::kStalled:
    case dgd::Status::kIterationLimit:
      return result.RelativeGap() <= kCertifiedGap;
    default:
      return false;
  }
}

const btConvexShape& ShapeOf(const btCollisionObjectWrapper* body) {
  return *static_cast<const btConvexShape*>(body->getCollisionShape());
}

PairOutcome OutcomeOf(const dgd::Result<double>& result, bool has_followed, int patch_size) {
  PairOutcome outcome{.iterations = result.iterations, .patch_size = patch_size};
  if (result.status == dgd::Status::kSeparated) {
    outcome.way = PairOutcome::Way::kSeparated;
  } else if (has_followed) {
    outcome.way = PairOutcome::Way::kFollowed;
  } else if (result.status != dgd::Status::kCoincidentCenters) {
    outcome.gap = result.RelativeGap();
  }
  return outcome;
}

/// As if the shapes had been solved in the other order.
void Swap(dgd::ContactPatch<double>& patch, dgd::Result<double>& result) {
  for (int i = 0; i < patch.size; ++i) {
    dgd::ContactPoint<double>& point = patch.points[static_cast<std::size_t>(i)];
    std::swap(point.on_1, point.on_2);
  }
  result.normal = -result.normal;
}

/// The app's own word on which bodies are worth a sweep.
bool IsSlow(const btCollisionObject& body) {
  const btVector3 way = body.getInterpolationWorldTransform().getOrigin() - body.getWorldTransform().getOrigin();
  return way.length2() < body.getCcdSquareMotionThreshold();
}

}  // namespace

ConvexConvexAlgorithm::ConvexConvexAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase,
                                             bool is_for_step)
    : PairAlgorithm(info, narrowphase, is_for_step) {}

void ConvexConvexAlgorithm::processCollision(const btCollisionObjectWrapper* body_0,
                                             const btCollisionObjectWrapper* body_1, const btDispatcherInfo& info,
                                             btManifoldResult* output) {
  PrefetchNext(*body_0, *body_1);
  if (Recorder* recorder = narrowphase_.options().recorder) recorder->Add(*body_0, *body_1);
  Process({*body_0, *body_1}, info, *output);
}

void ConvexConvexAlgorithm::PrefetchNext(const btCollisionObjectWrapper& body_0,
                                         const btCollisionObjectWrapper& body_1) {
  VisitingOrder::Visited now{.pair = this, .bodies = {body_0.getCollisionObject(), body_1.getCollisionObject()}};
  if (is_resting_) now.resting = resting_.get();
  if (had_contact_) now.contacts = manifold_.Get();
  if (manifold_) now.manifold_state = &manifold_->m_companionIdA;
  const VisitingOrder::Visited next = VisitingOrder::OfThisThread().Visit(now, place_);
  if (next.pair == nullptr) return;
  PrefetchToWrite(next.pair, sizeof(ConvexConvexAlgorithm));
  if (next.resting != nullptr) PrefetchToWrite(next.resting, sizeof(RestingPair));
  if (next.contacts != nullptr) PrefetchToWrite(next.contacts, MANIFOLD_CACHE_SIZE * sizeof(btManifoldPoint));
  PrefetchToWrite(next.manifold_state, 1);
  // Other threads read them, too.
  for (const void* body : next.bodies) PrefetchToRead(body, sizeof(btCollisionObject));
}

struct ConvexConvexAlgorithm::Query {
  /// @param hull_a, hull_b  The shapes' hulls where they have one, which may be known already.
  /// @param by_app          Whether an app asks, for the contacts themselves.
  /// @param contacts        Where the motion and the result go.
  Query(Narrowphase& narrowphase, const btCollisionObjectWrapper& body_a, std::shared_ptr<const CachedHull>& hull_a,
        const btCollisionObjectWrapper& body_b, std::shared_ptr<const CachedHull>& hull_b, bool by_app,
        PairContacts& contacts)
      : shape_a(Adapt(narrowphase, body_a, hull_a, by_app)),
        shape_b(Adapt(narrowphase, body_b, hull_b, by_app)),
        is_asked(by_app),
        motion(contacts.motion),
        result(contacts.result),
        lets_pass(contacts.lets_pass) {}

  static PosedShape Adapt(Narrowphase& narrowphase, const btCollisionObjectWrapper& body,
                          std::shared_ptr<const CachedHull>& hull, bool by_app) {
    return AdaptShape(ShapeOf(&body), body.getWorldTransform(), narrowphase.options().geometry_mode,
                      narrowphase.hulls(), hull, narrowphase.HullUseFor(by_app));
  }

  PosedShape shape_a, shape_b;
  bool is_asked;  // By an app, for the contacts themselves.
  PairMotion& motion;
  ContactRange range;
  dgd::PatchSettings<double> patch_settings;
  bool is_of_mesh = false;   // One of many triangles.
  bool wants_least = false;  // The normal of least translation.
  dgd::Settings<double> settings;

  // The answer.
  dgd::Result<double>& result;
  bool& lets_pass;
  bool has_growth_distance = false;  // Else the signed distance, or a plane between the shapes.
  bool is_turned = false;            // The growth distance's normal, to that of least translation.
  bool has_facing = false;           // As what proved the signed distance.
  dgd::FacingFaces<double> facing;   // Along the result's normal.
};

template <class Prepare>
std::optional<Fallback> ConvexConvexAlgorithm::SolveContacts(const btCollisionObjectWrapper& body_0,
                                                             const btCollisionObjectWrapper& body_1, bool is_asked,
                                                             const Prepare& prepare, PairContacts& contacts) try {
  const Options& options = narrowphase_.options();
  const bool is_swapped = ComesBefore(body_1, body_0);
  const btCollisionObjectWrapper &body_a = is_swapped ? body_1 : body_0, &body_b = is_swapped ? body_0 : body_1;
  const bool is_other_order = std::exchange(was_swapped_, is_swapped) != is_swapped;
  if (is_other_order) std::swap(hull_0_, hull_1_);
  for (const auto& hull : {&hull_0_, &hull_1_}) {
    if (*hull != nullptr) (*hull)->Prefetch();
  }
  contacts.result = {};
  contacts.motion = {};
  contacts.lets_pass = false;
  Query query(narrowphase_, body_a, hull_0_, body_b, hull_1_, is_asked, contacts);
  Recall(is_other_order, query.shape_a.pose, query.shape_b.pose);
  prepare(query, is_swapped);
  query.wants_least = options.normal_mode == NormalMode::kLeastTranslation;
  query.settings.relative_tolerance =
      query.is_asked ? std::min(kExact, options.relative_tolerance) : options.relative_tolerance;
  query.settings.max_iterations = options.max_iterations;
  query.settings.separation_limit = SeparationLimit(query.range, query.motion);

  FindNormal(query);
  dgd::Result<double>& result = query.result;
  if (result.status != dgd::Status::kSeparated && !IsCertified(result)) return FallbackOf(result.status);
  contacts.patch = FindContactPatch(query);
  had_contact_ = contacts.patch.size > 0;
  if (PairCounters* counters = narrowphase_.pair_counters()) {
    counters->Count(ShapeOf(&body_a).getShapeType(), ShapeOf(&body_b).getShapeType(),
                    OutcomeOf(result, !query.has_growth_distance, contacts.patch.size));
  }
  if (is_swapped) Swap(contacts.patch, result);
  return std::nullopt;
} catch (const std::bad_alloc&) {
  return Fallback::kNoMemory;  // For a hull.
} catch (const std::exception&) {
  return Fallback::kInvalid;  // A shape that is not one: NaN or infinite sizes, no points.
}

std::optional<Fallback> ConvexConvexAlgorithm::FindContacts(const Bodies& bodies, const btDispatcherInfo& info,
                                                            btManifoldResult& output) {
  if (StaysApart(bodies, info, output)) return std::nullopt;
  const Options& options = narrowphase_.options();
  const auto prepare = [&](Query& query, bool is_swapped) {
    if (is_for_step_) {
      const Bodies solved = InOrder(bodies, is_swapped);
      const BodyReach reach_a(*solved.first.getCollisionObject()), reach_b(*solved.second.getCollisionObject());
      query.motion = MotionOfStep(manifold_, reach_a, reach_b, info);
    }
    query.range = RangeOfContacts(options, manifold_, query.motion, output);
    query.patch_settings = PatchSettingsOf(options, manifold_, query.range, query.is_asked);
  };
  PairContacts contacts;
  if (const auto failure = SolveContacts(bodies.first, bodies.second, IsAskedByApp(output), prepare, contacts)) {
    return failure;
  }
  if (had_contact_ && !EnsureManifold(bodies, output)) {
    had_contact_ = false;
    return Fallback::kNoMemory;
  }
  const PairMotion motion = was_swapped_ ? contacts.motion.Reversed() : contacts.motion;
  WriteContacts(contacts.patch, contacts.result.normal, motion, options, manifold_, output);
  if (MayRecycle() && !contacts.lets_pass) {
    const Bodies solved = InOrder(bodies, was_swapped_);
    RememberRest(solved, FootingOfContacts(solved), contacts.motion);
  }
  return std::nullopt;
}

std::optional<Fallback> ConvexConvexAlgorithm::FindTriangleContacts(const btCollisionObjectWrapper& convex,
                                                                    const btCollisionObjectWrapper& triangle,
                                                                    const TriangleQuery& triangle_query,
                                                                    PairContacts& contacts) {
  contacts.patch.size = 0;
  if (Recorder* recorder = narrowphase_.options().recorder) recorder->Add(convex, triangle);
  const bool is_swapped = ComesBefore(triangle, convex);
  const PairMotion& motion = is_swapped ? triangle_query.reverse_motion : triangle_query.motion;
  const auto get_motion = [&](const BodyReach&, const BodyReach&) -> const PairMotion& { return motion; };
  const double contact_distance = std::max(triangle_query.range.touching, 0.0);
  if (StaysApartBy(convex, triangle, contact_distance, get_motion)) return std::nullopt;
  const auto prepare = [&](Query& query, bool) {
    query.motion = motion;
    query.range = triangle_query.range;
    query.is_of_mesh = true;
    query.patch_settings = triangle_query.patch_settings;
  };
  const std::optional<Fallback> failure = SolveContacts(convex, triangle, triangle_query.is_asked, prepare, contacts);
  if (failure) {
    contacts.patch.size = 0;
    Count(*failure, {convex, triangle});
  }
  return failure;
}

FaceContacts ConvexConvexAlgorithm::FindTriangleFaceContacts(const btCollisionObjectWrapper& convex,
                                                             const btCollisionObjectWrapper& triangle,
                                                             const Vector3& normal, const TriangleQuery& query) try {
  std::shared_ptr<const CachedHull> no_hull;
  const PosedShape shape = Query::Adapt(narrowphase_, convex, was_swapped_ ? hull_1_ : hull_0_, query.is_asked);
  const PosedShape face = Query::Adapt(narrowphase_, triangle, no_hull, query.is_asked);
  return FindFaceContacts(shape, face, IsTowards(normal, shape, face) ? normal : Vector3(-normal), query);
} catch (const std::exception&) {
  return {};  // FindTriangleContacts() has counted it.
}

bool ConvexConvexAlgorithm::IsTowards(const Vector3& normal, const PosedShape& convex,
                                      const PosedShape& triangle) const {
  if (dgd::HasNormal(warm_start_)) {
    // Most of a body may be behind the plane of a triangle that it is next to.
    const Vector3 last = was_swapped_ ? Vector3(-(triangle.pose.rotation * warm_start_.normal_1))
                                      : Vector3(convex.pose.rotation * warm_start_.normal_1);
    const double cosine = normal.dot(last);
    if (std::abs(cosine) > kLeastFacing) return cosine > 0;
  }
  return normal.dot(CenterOf(triangle) - CenterOf(convex)) > 0;
}

Footing ConvexConvexAlgorithm::FootingOfContacts(const Bodies& bodies) const {
  const int contacts = manifold_->getNumContacts();
  if (contacts < FewestOfFooting(bodies.first, bodies.second)) return {};
  if (face_holder_ != dgd::FaceHolder::kNone) return FootingOn(face_holder_, *manifold_);
  // Where edges of two faces cross that are nearly parallel, the normal is neither's, and turns with both. That of
  // edges alone may turn by more than either body does.
  constexpr int kFewestOfTwoFaces = 3;
  if (contacts < kFewestOfTwoFaces) return {};
  return FootingOn(dgd::FaceHolder::kSet1, *manifold_);
}

void ConvexConvexAlgorithm::FindNormal(Query& query) {
  // What had the last answer is asked first: boxes at each other's edges or corners have no face to follow.
  const bool distance_first = follows_distance_ && face_holder_ == dgd::FaceHolder::kNone;
  follows_distance_ = distance_first && FollowLastSimplex(query);
  bool is_known = follows_distance_ || FollowLastContact(query);
  if (!is_known && !distance_first) is_known = follows_distance_ = FollowLastSimplex(query);
  query.has_growth_distance = !is_known;
  if (!is_known) {
    MoveCentersTogether(query.shape_a, query.shape_b);
    query.result = dgd::GrowthDistance(query.shape_a.set, query.shape_a.pose, query.shape_b.set, query.shape_b.pose,
                                       query.settings, &warm_start_);
  }
  may_be_apart_ = is_known || query.result.status == dgd::Status::kSeparated || query.result.separation > 0;
}

bool ConvexConvexAlgorithm::FollowLastContact(Query& query) {
  const bool is_known = query.wants_least && FollowContact(query.shape_a, query.shape_b, query.settings,
                                                           narrowphase_.options().angular_tolerance, face_holder_,
                                                           warm_start_, query.facing, query.result);
  query.has_facing = is_known && query.facing.overlap.size > 0;
  if (!is_known) face_holder_ = dgd::FaceHolder::kNone;
  return is_known;
}

bool ConvexConvexAlgorithm::FollowLastSimplex(Query& query) {
  return query.wants_least && may_be_apart_ &&
         FollowDistance(query.shape_a, query.shape_b, query.settings, warm_start_, query.result);
}

dgd::ContactPatch<double> ConvexConvexAlgorithm::FindContactPatch(Query& query) {
  dgd::Result<double>& result = query.result;
  if (result.status == dgd::Status::kSeparated) return {};
  const bool is_apart = result.separation > std::min(query.range.touching, 0.0);
  const ContactKind kind = is_apart ? ClassifySpeculative(query) : ContactKind::kPatch;
  if (kind == ContactKind::kNone) return {};
  if (kind != ContactKind::kPoint) TurnNormal(query);
  const Options& options = narrowphase_.options();
  dgd::ContactPatch<double> patch;
  if (kind == ContactKind::kPoint || !options.contact_patch) {
    patch = WitnessOnly(result);
  } else {
    FindFacing(query);
    patch = FindPatch(result, query.facing, query.patch_settings, query.motion);
    if (options.rim_damping) {
      AddRimPoint(query.shape_a, query.shape_b, result, query.facing, query.patch_settings, query.motion, patch);
    }
  }
  query.lets_pass = kind == ContactKind::kPassingPatch;
  if (query.lets_pass) {
    LetPass(patch, result.normal, query.motion, NegligibleDistance(manifold_.BreakingThreshold()));
  }
  return patch;
}

void ConvexConvexAlgorithm::TurnNormal(Query& query) {
  if (!query.wants_least || !query.has_growth_distance || std::exchange(query.is_turned, true)) return;
  if (query.is_asked) query.settings.max_iterations *= kPatience;
  may_be_apart_ = TurnToLeastTranslation(query.shape_a, query.shape_b, query.settings, warm_start_, query.result);
}

void ConvexConvexAlgorithm::FindFacing(Query& query) {
  if (std::exchange(query.has_facing, true)) return;
  FindFacingFaces(query.shape_a, query.shape_b, query.result, narrowphase_.options().angular_tolerance, query.facing);
  if (query.wants_least && may_be_apart_) face_holder_ = HolderOf(query.facing);
}

ConvexConvexAlgorithm::ContactKind ConvexConvexAlgorithm::ClassifySpeculative(Query& query) {
  dgd::Result<double>& result = query.result;
  const PairMotion& motion = query.motion;
  const bool is_touching = result.separation <= query.range.touching;
  if (is_touching) TurnNormal(query);  // What the motion closes is to be judged along the normal that is handed over.
  if (!motion.MayApproachBy(result.separation, result.normal))
    return is_touching ? ContactKind::kPatch : ContactKind::kNone;
  if (!is_touching && result.separation > query.range.limit) return ContactKind::kNone;
  const double flush = NegligibleDistance(manifold_.BreakingThreshold());
  TurnNormal(query);
  FindFacing(query);
  // Impacts of other bodies may change a motion that does not make them meet. A contact that has no effect otherwise
  // keeps them apart then; but a rebound would act on it, and in a mesh the next triangle is what they pass to.
  const bool may_be_knocked = is_touching && !query.is_of_mesh && !query.range.is_rebound;
  if (result.separation > flush && TurnsClear(query.shape_a, query.shape_b, motion, result.normal, flush)) {
    return may_be_knocked ? ContactKind::kPassingPatch : ContactKind::kNone;
  }
  const Vector3 middle = (result.witness_1 + result.witness_2) / 2;
  if (query.facing.IsInset(flush + motion.Passing(middle, result.normal))) return ContactKind::kPatch;
  // Weight is left out: what supports the bodies takes it up, and would seem to let them sink into each other.
  MovingPair pair(query.shape_a, query.shape_b, motion.WithoutForces());
  pair.MoveTo(1);
  const double at_end = pair.SeparationAlong(result.normal);
  if (at_end > -flush) return is_touching ? ContactKind::kPatch : ContactKind::kNone;
  const PredictedEncounter predicted =
      PredictEncounter(pair, query.settings, warm_start_, may_be_apart_, result, at_end, flush);
  if (predicted.encounter == Encounter::kMeet) return ContactKind::kPatch;
  const double separation = predicted.contact.separation;
  if (predicted.encounter == Encounter::kPass) {
    const bool is_plane_between = separation > -flush && separation <= query.range.touching;
    if (!may_be_knocked || !is_plane_between) return ContactKind::kNone;
  }
  result = predicted.contact;
  if (predicted.encounter == Encounter::kPass) result.separation = std::max(separation, 0.0);
  face_holder_ = dgd::FaceHolder::kNone;
  return ContactKind::kPoint;
}

bool ConvexConvexAlgorithm::UpdateRecycledContacts(const Bodies& bodies, double anchor_time_step,
                                                   btManifoldResult& output) {
  const Bodies solved = InOrder(bodies, was_swapped_);
  return KeepContacts(*resting_, solved.first, solved.second, hull_0_, hull_1_, anchor_time_step, *manifold_, output);
}

bool ConvexConvexAlgorithm::StaysApart(const Bodies& bodies, const btDispatcherInfo& info,
                                       const btManifoldResult& output) {
  const Options& options = narrowphase_.options();
  const double contact_distance = ContactDistance(options, manifold_.BreakingThreshold(), output);
  const auto get_motion = [&](const BodyReach& reach_a, const BodyReach& reach_b) {
    const bool counts = is_for_step_ && options.speculative_contacts;
    return counts ? MotionOfStep(manifold_, reach_a, reach_b, info) : PairMotion();
  };
  return StaysApartBy(bodies.first, bodies.second, contact_distance, get_motion);
}

template <class GetMotion>
bool ConvexConvexAlgorithm::StaysApartBy(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                                         double contact_distance, const GetMotion& get_motion) try {
  const Options& options = narrowphase_.options();
  if (had_contact_ || face_holder_ != dgd::FaceHolder::kNone || !dgd::HasNormal(warm_start_) || !options.warm_start ||
      options.geometry_mode != GeometryMode::kBullet) {
    return false;
  }
  const bool is_swapped = ComesBefore(body_1, body_0);
  if (is_swapped != was_swapped_) return false;
  const btCollisionObjectWrapper &a = is_swapped ? body_1 : body_0, &b = is_swapped ? body_0 : body_1;
  const BodyReach reach_a(*a.getCollisionObject()), reach_b(*b.getCollisionObject());
  const btVector3 normal = a.getWorldTransform().getBasis() * InBulletAxes(warm_start_.normal_1, UpAxis(ShapeOf(&a)));
  const double separation = SeparationAlong({a, reach_a}, {b, reach_b}, normal);
  // What memory is slow to bring comes last.
  if (!(separation > contact_distance)) return false;
  if (get_motion(reach_a, reach_b).MayApproachBy(separation, FromBullet(normal))) return false;
  if (manifold_.IsOwn() && !manifold_.IsEmpty()) return false;  // Of an answer that was not ours.
  if (PairCounters* counters = narrowphase_.pair_counters()) {
    counters->Count(ShapeOf(&a).getShapeType(), ShapeOf(&b).getShapeType(),
                    {.way = PairOutcome::Way::kSeparated, .iterations = 1});
  }
  return true;
} catch (const std::exception&) {
  return false;  // A user's shape that throws: SolveContacts() says what comes of it.
}

void ConvexConvexAlgorithm::Recall(bool is_other_order, const Pose& pose_a, const Pose& pose_b) {
  if (!narrowphase_.options().warm_start) {
    warm_start_ = {};
    may_be_apart_ = true;
    follows_distance_ = false;
    face_holder_ = dgd::FaceHolder::kNone;
  } else if (is_other_order) {
    std::swap(warm_start_.features_1, warm_start_.features_2);
    warm_start_.normal_1 = (-pose_a.rotation.transpose() * (pose_b.rotation * warm_start_.normal_1)).normalized();
    face_holder_ = Swapped(face_holder_);
  }
}

btScalar ConvexConvexAlgorithm::calculateTimeOfImpact(btCollisionObject* body_0, btCollisionObject* body_1,
                                                      const btDispatcherInfo&, btManifoldResult*) {
  constexpr btScalar kNever = 1;
  const btCollisionShape *shape_0 = body_0->getCollisionShape(), *shape_1 = body_1->getCollisionShape();
  if (!Narrowphase::Handles(shape_0->getShapeType(), shape_1->getShapeType()) || (IsSlow(*body_0) && IsSlow(*body_1))) {
    return kNever;
  }
  const auto moving = [](const btCollisionObject& body, std::shared_ptr<const CachedHull>& hull) -> MovingShape {
    return {*static_cast<const btConvexShape*>(body.getCollisionShape()), body.getWorldTransform(),
            body.getInterpolationWorldTransform(), hull};
  };
  const MovingShape a = moving(*body_0, hull_0_), b = moving(*body_1, hull_1_);
  const dgd::TimeOfImpactResult<double> impact =
      SweepShapes(a, b, narrowphase_.options().geometry_mode, narrowphase_.hulls(), HullUse::kStep);
  if (!Meet(impact, a, b)) return kNever;
  const btScalar fraction = RoundDown(impact.time);
  for (btCollisionObject* body : {body_0, body_1}) body->setHitFraction(std::min(body->getHitFraction(), fraction));
  return fraction;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
