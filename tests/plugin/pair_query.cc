#include "plugin/pair_query.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>

#include <algorithm>

namespace dgd_test {
namespace {

/// Passes contacts on to Bullet and remembers them as they came: as an app's own result, of which the narrowphase can
/// tell that it is one.
class RecordingResult : public btManifoldResult {
 public:
  using btManifoldResult::btManifoldResult;
  void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar depth) override {
    contacts.push_back({ToEigen(normal_on_b), ToEigen(point), double(depth)});
    btManifoldResult::addContactPoint(normal_on_b, point, depth);
  }

  std::vector<Contact> contacts;
};

/// Remembers what this thread puts into manifolds of bodies with CF_CUSTOM_MATERIAL_CALLBACK, by Bullet's own callback:
/// the result is the one that steps have.
thread_local std::vector<Contact>* recorded = nullptr;

bool Record(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int, const btCollisionObjectWrapper*, int,
            int) {
  if (recorded != nullptr) {
    recorded->push_back(
        {ToEigen(point.m_normalWorldOnB), ToEigen(point.m_positionWorldOnB), double(point.getDistance())});
  }
  return false;
}

}  // namespace

const Contact& Deepest(const std::vector<Contact>& contacts) {
  return *std::min_element(contacts.begin(), contacts.end(),
                           [](const Contact& a, const Contact& b) { return a.depth < b.depth; });
}

PairQuery::PairQuery(btCollisionDispatcher& dispatcher, btConvexShape& shape_a, btConvexShape& shape_b)
    : dispatcher_(dispatcher) {
  body_a_.setCollisionShape(&shape_a);
  body_b_.setCollisionShape(&shape_b);
  gContactAddedCallback = Record;
  body_a_.setCollisionFlags(body_a_.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
  SetPoses(btTransform::getIdentity(), btTransform::getIdentity());
}

PairQuery::~PairQuery() { Forget(); }

void PairQuery::SetPoses(const btTransform& pose_a, const btTransform& pose_b) {
  body_a_.setWorldTransform(pose_a);
  body_b_.setWorldTransform(pose_b);
}

PosedConvex PairQuery::A() const {
  return {static_cast<const btConvexShape&>(*body_a_.getCollisionShape()), body_a_.getWorldTransform()};
}

PosedConvex PairQuery::B() const {
  return {static_cast<const btConvexShape&>(*body_b_.getCollisionShape()), body_b_.getWorldTransform()};
}

std::vector<Contact> PairQuery::Step(btPersistentManifold* shared, double time_step) {
  const btCollisionObjectWrapper a(nullptr, body_a_.getCollisionShape(), &body_a_, body_a_.getWorldTransform(), -1, -1);
  const btCollisionObjectWrapper b(nullptr, body_b_.getCollisionShape(), &body_b_, body_b_.getWorldTransform(), -1, -1);
  if (algorithm_ == nullptr) algorithm_ = dispatcher_.findAlgorithm(&a, &b, shared, BT_CONTACT_POINT_ALGORITHMS);
  std::vector<Contact> contacts;
  recorded = &contacts;
  btManifoldResult result(&a, &b);
  btDispatcherInfo info;
  info.m_timeStep = btScalar(time_step);
  algorithm_->processCollision(&a, &b, info, &result);
  recorded = nullptr;
  return contacts;
}

std::vector<Contact> PairQuery::Ask(ebtDispatcherQueryType table, double threshold) {
  const btCollisionObjectWrapper a(nullptr, body_a_.getCollisionShape(), &body_a_, body_a_.getWorldTransform(), -1, -1);
  const btCollisionObjectWrapper b(nullptr, body_b_.getCollisionShape(), &body_b_, body_b_.getWorldTransform(), -1, -1);
  btCollisionAlgorithm* algorithm = dispatcher_.findAlgorithm(&a, &b, nullptr, table);
  RecordingResult result(&a, &b);
  result.m_closestPointDistanceThreshold = btScalar(threshold);
  algorithm->processCollision(&a, &b, btDispatcherInfo(), &result);
  algorithm->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(algorithm);
  return result.contacts;
}

void PairQuery::Forget() {
  if (algorithm_ == nullptr) return;
  algorithm_->~btCollisionAlgorithm();
  dispatcher_.freeCollisionAlgorithm(algorithm_);
  algorithm_ = nullptr;
}

btPersistentManifold* PairQuery::manifold() {
  btManifoldArray manifolds;
  if (algorithm_ != nullptr) algorithm_->getAllContactManifolds(manifolds);
  return manifolds.size() > 0 ? manifolds[0] : nullptr;
}

}  // namespace dgd_test
