#include "algorithms/pair_algorithm.h"

#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>

#include "conditioning/contact_recycling.h"
#include "conditioning/just_touching.h"
#include "dgd/assert.h"
#include "pipeline/manifold_writer.h"
#include "pipeline/pair_contacts.h"
#include "pipeline/pair_motion.h"
#include "pipeline/user_query.h"
#include "record/contact_drawer.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

PairAlgorithm::PairAlgorithm(const btCollisionAlgorithmConstructionInfo& info, Narrowphase& narrowphase,
                             bool is_for_step)
    : btCollisionAlgorithm(info), narrowphase_(narrowphase), manifold_(info.m_manifold), is_for_step_(is_for_step) {}

PairAlgorithm::~PairAlgorithm() {
  if (manifold_.IsOwn()) manifold_.GiveBack(*m_dispatcher);
}

void PairAlgorithm::Process(const Bodies& bodies, const btDispatcherInfo& info, btManifoldResult& output) {
  if (manifold_.IsOwn() && manifold_) ForgetTouching(*manifold_);
  const bool can_do_without = CanDoWithoutManifold(bodies, output);
  // Not in the step that ends the contact: most likely such bodies touch again. Nor in the one that made the manifold,
  // which btCollisionDispatcherMt has not listed yet.
  const bool may_give_back = can_do_without && manifold_ && !had_contact_;
  if ((manifold_.IsNew() || !can_do_without) && !EnsureManifold(bodies, output)) {
    return Count(Fallback::kNoMemory, bodies);
  }
  manifold_.ShowTo(output);
  FindOrRecycleContacts(bodies, info, output);
  if (had_contact_) DrawContacts(*manifold_, info.m_debugDraw);
  if (may_give_back && !had_contact_ && manifold_.IsEmpty()) {
    manifold_.GiveBack(*m_dispatcher);
    manifold_.ShowTo(output);
  }
}

void PairAlgorithm::FindOrRecycleContacts(const Bodies& bodies, const btDispatcherInfo& info,
                                          btManifoldResult& output) {
  if (TryRecycleContacts(bodies, info, output)) return;
  is_resting_ = false;
  const std::optional<Fallback> fallback = FindContacts(bodies, info, output);
  if (!fallback) return;
  Count(*fallback, bodies);
  // Bullet has no answer to what is no shape or no pose either: it reads points that a hull has not, and keeps NaN.
  if (!IsAnsweredByBullet(*fallback)) {
    if (manifold_.IsOwn() && manifold_) manifold_->clearManifold();
    return;
  }
  if (!EnsureManifold(bodies, output)) return Count(Fallback::kNoMemory, bodies);
  narrowphase_.FallBack(*m_dispatcher, &bodies.first, &bodies.second, info, output);
  if (manifold_.IsOwn()) {
    output.refreshContactPoints();
    DropPointsNotFinite(*manifold_);
  }
}

bool PairAlgorithm::TryRecycleContacts(const Bodies& bodies, const btDispatcherInfo& info, btManifoldResult& output) {
  // For an app's own query each contact is found again.
  if (!is_resting_ || IsAskedByApp(output)) return false;
  DGD_ASSERT(resting_ != nullptr && manifold_.IsOwn() && manifold_);
  const double anchor_time_step = narrowphase_.options().friction_anchors ? double(info.m_timeStep) : 0;
  if (!UpdateRecycledContacts(bodies, anchor_time_step, output)) return false;
  if (PairCounters* counters = narrowphase_.pair_counters()) {
    counters->Count(bodies.first.getCollisionShape()->getShapeType(), bodies.second.getCollisionShape()->getShapeType(),
                    {.way = PairOutcome::Way::kResting, .patch_size = manifold_->getNumContacts()});
  }
  return true;
}

bool PairAlgorithm::MayRecycle() const { return had_contact_ && MayKeepContacts(narrowphase_.options(), manifold_); }

void PairAlgorithm::RememberRest(const Bodies& bodies, const Footing& footing, const PairMotion& motion) {
  is_resting_ = dgd_bullet::RememberRest(bodies.first, bodies.second, footing, motion, *manifold_, resting_);
}

bool PairAlgorithm::EnsureManifold(const Bodies& bodies, btManifoldResult& output) {
  const bool has_been_there = bool(manifold_);
  if (!manifold_.Provide(*m_dispatcher, *bodies.first.getCollisionObject(), *bodies.second.getCollisionObject())) {
    return false;
  }
  if (!has_been_there) manifold_.ShowTo(output);
  return true;
}

bool PairAlgorithm::CanDoWithoutManifold(const Bodies& bodies, const btManifoldResult& output) const {
  // Bullet wakes whoever shares a manifold with a kinematic body, empty or not; an app's own result may look into it.
  const Options& options = narrowphase_.options();
  return !options.keep_empty_manifolds && options.warm_start && manifold_.IsOwn() &&
         !bodies.first.getCollisionObject()->isKinematicObject() &&
         !bodies.second.getCollisionObject()->isKinematicObject() && !IsAskedByApp(output);
}

void PairAlgorithm::Count(Fallback fallback, const Bodies& bodies) {
  narrowphase_.CountFallback(*bodies.first.getCollisionShape(), *bodies.second.getCollisionShape(), fallback);
}

void PairAlgorithm::getAllContactManifolds(btManifoldArray& manifolds) {
  if (manifold_.IsOwn() && manifold_) manifolds.push_back(manifold_.Get());
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
