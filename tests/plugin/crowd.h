// A busy world on either dispatcher, for comparing dgd_bullet::CollisionDispatcher with btCollisionDispatcher.
#pragma once

#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "dgd_bullet/collision_dispatcher.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"
#include "plugin/triangle_grid.h"

namespace dgd_test {

/// Nothing for btCollisionDispatcher.
using DispatcherChoice = std::optional<dgd_bullet::DispatcherOptions>;

/// All numbers of a world's state: poses and velocities of its bodies, and its manifolds, in their order.
using State = std::vector<double>;

/// Bodies of all convex types, and compounds, fall onto a box, a plane and a mesh; an app adds, removes, moves, turns
/// and changes them.
class Crowd {
 public:
  explicit Crowd(const DispatcherChoice& dispatcher, const dgd_bullet::Options& options = {})
      : world_(Route::kConfiguration, options, dispatcher) {
    world_.AddGround();
    world_.Add(world_.Make<btStaticPlaneShape>(Vec(-0.6, 0, 0.8), btScalar(-3)), 0, btTransform::getIdentity());
    AddMesh();
    AddShapes();
    paddle_ = &world_.Add(world_.Make<btBoxShape>(Vec(1, 0.2, 0.3)), 0, Vec(0, 0, 0.5));
    paddle_->setCollisionFlags(paddle_->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    paddle_->setActivationState(DISABLE_DEACTIVATION);
    AddWalker();
    for (int i = 0; i < 150; ++i) AddBody();
  }

  ~Crowd() { world_.world().removeCollisionObject(&walker_); }
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  void Step() {
    ++step_;
    paddle_->getWorldTransform().setOrigin(Vec(1.5 * std::sin(0.1 * step_), 0, 0.5));
    if (step_ % 7 == 0) AddBody();
    if (step_ % 11 == 0) RemoveBody();
    if (step_ % 13 == 0) Teleport();
    if (step_ % 17 == 0) ChangeShape();
    if (step_ % 19 == 0) CleanPairs();
    world_.world().stepSimulation(btScalar(1) / 120, 0);
    // As Bullet's character controller does.
    walker_.getWorldTransform().setOrigin(Vec(-1.5 * std::sin(0.05 * step_), 1, 0.8));
    world_.world().updateSingleAabb(&walker_);
    world_.dispatcher().dispatchAllCollisionPairs(walker_.getOverlappingPairCache(), world_.world().getDispatchInfo(),
                                                  &world_.dispatcher());
  }

  State Read() {
    State state;
    const auto add = [&](const btVector3& v) { state.insert(state.end(), {v.x(), v.y(), v.z()}); };
    const btCollisionObjectArray& objects = world_.world().getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i) {
      const btTransform& pose = objects[i]->getWorldTransform();
      add(pose.getOrigin());
      for (int row = 0; row < 3; ++row) add(pose.getBasis()[row]);
      state.push_back(objects[i]->getActivationState());
      const btRigidBody* body = btRigidBody::upcast(objects[i]);
      if (body == nullptr) continue;
      add(body->getLinearVelocity());
      add(body->getAngularVelocity());
    }
    for (int i = 0; i < world_.dispatcher().getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *world_.dispatcher().getManifoldByIndexInternal(i);
      state.push_back(manifold.m_index1a);
      state.push_back(manifold.getBody0()->getWorldArrayIndex());
      state.push_back(manifold.getBody1()->getWorldArrayIndex());
      for (int j = 0; j < manifold.getNumContacts(); ++j) {
        const btManifoldPoint& point = manifold.getContactPoint(j);
        add(point.m_positionWorldOnB);
        add(point.m_normalWorldOnB);
        state.insert(state.end(), {point.m_distance1, point.m_appliedImpulse, double(point.m_lifeTime)});
      }
    }
    return state;
  }

  TestWorld& world() { return world_; }

 private:
  void AddMesh() {
    auto& mesh = world_.Make<btTriangleMesh>();
    AddGrid(mesh, 4, 1, [](double x, double y) { return 0.1 * x * y; });
    world_.Add(world_.Make<btBvhTriangleMeshShape>(&mesh, true), 0, Vec(0, 3, 0.3));
  }

  /// A ghost that caches its pairs, next to those of the world.
  void AddWalker() {
    world_.world().getPairCache()->setInternalGhostPairCallback(&world_.Make<btGhostPairCallback>());
    walker_.setCollisionShape(&world_.Make<btCapsuleShapeZ>(btScalar(0.3), btScalar(0.6)));
    walker_.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
    world_.world().addCollisionObject(&walker_, btBroadphaseProxy::CharacterFilter);
  }

  void AddShapes() {
    for (const ZooShape& zoo : zoo_) shapes_.push_back(zoo.shape.get());
    for (int i = 0; i < 4; ++i) shapes_.push_back(&world_.Keep(MakeRandomHull(random_, 12, 0.5)));
    auto& cross = world_.Make<btCompoundShape>();
    auto& rod = world_.Make<btCapsuleShape>(btScalar(0.08), btScalar(0.4));
    cross.addChildShape(btTransform::getIdentity(), &rod);
    cross.addChildShape(btTransform(btQuaternion(Vec(0, 0, 1), btScalar(1.5)), Vec(0, 0, 0.05)), &rod);
    shapes_.push_back(&cross);
  }

  btCollisionShape& AnyShape() { return *shapes_[std::size_t(random_.Below(int(shapes_.size())))]; }

  /// A moving body; they come after five others.
  btCollisionObject& AnyBody() {
    const btCollisionObjectArray& objects = world_.world().getCollisionObjectArray();
    return *objects[5 + random_.Below(objects.size() - 5)];
  }

  btTransform AnyPose() {
    const double x = random_.Uniform(-2, 2), y = random_.Uniform(-2, 4), z = random_.Uniform(0.5, 3);
    return MakeTransform(random_.Rotation(), {x, y, z});
  }

  void AddBody() {
    btRigidBody& body = world_.Add(AnyShape(), 1, AnyPose());
    if (random_.Flip()) body.setRestitution(btScalar(0.4));
    if (random_.Below(10) == 0) body.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    // Swept against tunnelling.
    if (random_.Below(5) == 0) {
      body.setCcdMotionThreshold(btScalar(0.05));
      body.setCcdSweptSphereRadius(btScalar(0.1));
    }
  }

  void RemoveBody() { world_.world().removeCollisionObject(&AnyBody()); }

  void Teleport() {
    btCollisionObject& body = AnyBody();
    body.setWorldTransform(AnyPose());
    body.activate(true);
  }

  void ChangeShape() {
    auto& hull = static_cast<btConvexHullShape&>(*shapes_[zoo_.size()]);
    switch (random_.Below(4)) {
      case 0:
        return hull.addPoint(Vec(0, 0, random_.Uniform(0.2, 0.4)));
      case 1:
        return hull.setMargin(btScalar(random_.Uniform(0, 0.1)));
      case 2:
        return hull.setLocalScaling(Vec(1, random_.Uniform(0.8, 1.2), 1));
      default:
        return AnyBody().setCollisionShape(&AnyShape());
    }
  }

  void CleanPairs() {
    world_.world().getPairCache()->cleanProxyFromPairs(AnyBody().getBroadphaseHandle(), &world_.dispatcher());
  }

  Random random_{TestSeed()};
  std::vector<ZooShape> zoo_ = MakeShapeZoo(0.5);
  std::vector<btCollisionShape*> shapes_;
  TestWorld world_;
  btPairCachingGhostObject walker_;
  btRigidBody* paddle_ = nullptr;
  int step_ = 0;
};

}  // namespace dgd_test
