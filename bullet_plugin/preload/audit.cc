#include "audit.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <new>

namespace dgd_preload {
namespace {

/// Records the deepest of the contacts that are handed over, and adds them nowhere.
class WatchedResult : public btManifoldResult {
 public:
  WatchedResult(const btManifoldResult& output, btPersistentManifold* manifold)
      : btManifoldResult(output.getBody0Wrap(), output.getBody1Wrap()) {
    m_closestPointDistanceThreshold = output.m_closestPointDistanceThreshold;
    setPersistentManifold(manifold);
  }

  void addContactPoint(const btVector3& /*normal_on_b*/, const btVector3& /*point*/, btScalar separation) override {
    if (!(separation <= BreakingDistance())) return;  // Bullet drops it as well. NaN stays.
    deepest_ = {true, deepest_.is_contact ? std::min(deepest_.separation, double(separation)) : double(separation)};
  }

  const Deepest& deepest() const { return deepest_; }

 private:
  btScalar BreakingDistance() const {
    return getPersistentManifold()->getContactBreakingThreshold() + m_closestPointDistanceThreshold;
  }

  Deepest deepest_;
};

/// Forwards everything to the result of the call, too.
class ForwardingResult final : public WatchedResult {
 public:
  explicit ForwardingResult(btManifoldResult& output)
      : WatchedResult(output, output.getPersistentManifold()), output_(output) {}

  void setShapeIdentifiersA(int part, int index) override { output_.setShapeIdentifiersA(part, index); }
  void setShapeIdentifiersB(int part, int index) override { output_.setShapeIdentifiersB(part, index); }
  void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar separation) override {
    WatchedResult::addContactPoint(normal_on_b, point, separation);
    output_.setPersistentManifold(getPersistentManifold());
    output_.addContactPoint(normal_on_b, point, separation);
  }

 private:
  btManifoldResult& output_;
};

class AuditAlgorithm final : public btCollisionAlgorithm {
 public:
  AuditAlgorithm(const btCollisionAlgorithmConstructionInfo& info, btCollisionAlgorithm* builtin,
                 btCollisionAlgorithmCreateFunc& ours, AuditReport& report)
      : btCollisionAlgorithm(info), builtin_(builtin), create_ours_(ours), report_(report) {}
  ~AuditAlgorithm() override {
    Destroy(ours_);
    Destroy(builtin_);
  }
  AuditAlgorithm(const AuditAlgorithm&) = delete;
  AuditAlgorithm& operator=(const AuditAlgorithm&) = delete;

  void processCollision(const btCollisionObjectWrapper* body_0, const btCollisionObjectWrapper* body_1,
                        const btDispatcherInfo& info, btManifoldResult* output) override {
    ForwardingResult builtin(*output);
    builtin_->processCollision(body_0, body_1, info, &builtin);
    output->setPersistentManifold(builtin.getPersistentManifold());
    if (const btPersistentManifold* manifold = builtin.getPersistentManifold()) {
      Compare(*body_0, *body_1, info, *manifold, *output, builtin.deepest());
    }
  }

  btScalar calculateTimeOfImpact(btCollisionObject* body_0, btCollisionObject* body_1, const btDispatcherInfo& info,
                                 btManifoldResult* output) override {
    return builtin_->calculateTimeOfImpact(body_0, body_1, info, output);
  }

  void getAllContactManifolds(btManifoldArray& manifolds) override { builtin_->getAllContactManifolds(manifolds); }

 private:
  void Destroy(btCollisionAlgorithm* algorithm) {
    if (algorithm == nullptr) return;
    algorithm->~btCollisionAlgorithm();
    m_dispatcher->freeCollisionAlgorithm(algorithm);
  }

  /// Solves the pair by ours, with a manifold like the built-in's, and counts what differs.
  void Compare(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
               const btDispatcherInfo& info, const btPersistentManifold& manifold, const btManifoldResult& output,
               const Deepest& builtin) {
    if (ours_ == nullptr) {
      manifold_ = std::make_unique<btPersistentManifold>();
      btCollisionAlgorithmConstructionInfo construction(m_dispatcher, 0);
      construction.m_manifold = manifold_.get();
      ours_ = create_ours_.CreateCollisionAlgorithm(construction, &body_0, &body_1);
      if (ours_ == nullptr) return;
    }
    manifold_->setBodies(manifold.getBody0(), manifold.getBody1());
    manifold_->setContactBreakingThreshold(manifold.getContactBreakingThreshold());
    manifold_->setContactProcessingThreshold(manifold.getContactProcessingThreshold());
    btDispatcherInfo unseen_info = info;
    unseen_info.m_debugDraw = nullptr;
    WatchedResult ours(output, manifold_.get());
    ours_->processCollision(&body_0, &body_1, unseen_info, &ours);
    report_.Add(body_0.getCollisionShape()->getShapeType(), body_1.getCollisionShape()->getShapeType(), builtin,
                ours.deepest());
  }

  btCollisionAlgorithm* builtin_;
  btCollisionAlgorithmCreateFunc& create_ours_;
  AuditReport& report_;
  btCollisionAlgorithm* ours_ = nullptr;            ///< Made by the first call.
  std::unique_ptr<btPersistentManifold> manifold_;  ///< Never has points.
};

static_assert(sizeof(AuditAlgorithm) <= 184 && alignof(AuditAlgorithm) <= 8, "must fit Bullet's smallest pool element");

}  // namespace

AuditCreateFunc::AuditCreateFunc(btCollisionAlgorithmCreateFunc& builtin, btCollisionAlgorithmCreateFunc& ours,
                                 AuditReport& report)
    : builtin_(builtin), ours_(ours), report_(report) {
  m_swapped = builtin.m_swapped;
}

btCollisionAlgorithm* AuditCreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                const btCollisionObjectWrapper* body_0,
                                                                const btCollisionObjectWrapper* body_1) {
  btCollisionAlgorithm* builtin = builtin_.CreateCollisionAlgorithm(info, body_0, body_1);
  if (builtin == nullptr) return nullptr;
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(AuditAlgorithm));
  if (memory == nullptr) return builtin;
  return new (memory) AuditAlgorithm(info, builtin, ours_, report_);
}

AuditCreateFunc* Audit::CreateFuncOf(btCollisionAlgorithmCreateFunc& builtin, btCollisionAlgorithmCreateFunc& ours) {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<AuditCreateFunc>& create_func = create_funcs_[{&builtin, &ours}];
  if (create_func == nullptr) create_func = std::make_unique<AuditCreateFunc>(builtin, ours, report_);
  return create_func.get();
}

}  // namespace dgd_preload
