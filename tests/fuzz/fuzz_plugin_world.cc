// A world on our narrowphase in which bodies of all convex types are added, removed, scaled, moved, given other shapes
// and asked for, in any order and with any numbers, and which steps in between.
//
// No crash; no contact that is not finite; and what was given nothing but numbers as a game's stays finite, whatever
// stands beside it.
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "dgd_bullet/collision_configuration.h"
#include "fuzz/fuzz_input.h"
#include "fuzz/fuzz_target.h"
#include "plugin/lying_shape.h"
#include "plugin/rigid_body.h"
#include "plugin/test_world.h"

namespace dgd_fuzz {
namespace {

using dgd_test::Vec;

constexpr std::size_t kMostBodies = 10;
constexpr int kMostOperations = 60;

dgd_bullet::Options ReadOptions(FuzzInput& input) {
  dgd_bullet::Options options;
  options.on_first_fallback = nullptr;
  options.contact_patch = input.Below(8) != 0;
  options.patch_size = 1 + input.Below(4);
  input.Below(4);  // An option that is no more: the corpus keeps its meaning.
  options.geometry_mode = input.Below(4) == 0 ? dgd_bullet::GeometryMode::kSharp : dgd_bullet::GeometryMode::kBullet;
  options.speculative_contacts = input.Below(4) != 0;
  options.friction_anchors = input.Below(4) != 0;
  options.keep_resting_contacts = input.Below(4) != 0;
  const int history = input.Below(4);
  options.warm_start = history != 0;
  options.keep_empty_manifolds = history != 1;
  options.count_pairs = input.Flip();
  options.max_iterations = input.Flip() ? 100 : 1 + input.Below(20);
  options.contact_distance = input.Below(4) == 0 ? std::abs(input.ModerateNumber()) : 0;
  return options;
}

btDefaultCollisionConstructionInfo ReadPools(FuzzInput& input) {
  btDefaultCollisionConstructionInfo pools;
  pools.m_defaultMaxPersistentManifoldPoolSize = 1 + input.Below(256);
  pools.m_defaultMaxCollisionAlgorithmPoolSize = 1 + input.Below(256);
  return pools;
}

/// A body, its shape and what the shape refers to.
struct Resident {
  std::shared_ptr<btCollisionShape> shape;
  std::shared_ptr<void> kept_alive;
  std::unique_ptr<btRigidBody> body;
  bool is_tame = true;  ///< All its numbers are such as a game's are.
};

class FuzzWorld {
 public:
  explicit FuzzWorld(FuzzInput& input)
      : input_(input),
        options_(ReadOptions(input)),
        pools_(ReadPools(input)),
        is_continuous_(input.Below(4) == 0),
        configuration_(options_, pools_),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity(Vec(0, 0, -9.81));
    if (input.Below(4) == 0) {
      dispatcher_.setDispatcherFlags(dispatcher_.getDispatcherFlags() |
                                     btCollisionDispatcher::CD_DISABLE_CONTACTPOOL_DYNAMIC_ALLOCATION);
    }
    if (is_continuous_) world_.getDispatchInfo().m_dispatchFunc = btDispatcherInfo::DISPATCH_CONTINUOUS;
    Resident ground;
    ground.shape = std::make_shared<btBoxShape>(Vec(10, 10, 1));
    FinalizeBasis(std::move(ground), 0, btTransform(btMatrix3x3::getIdentity(), Vec(0, 0, -1)));
  }
  ~FuzzWorld() {
    for (const Resident& resident : residents_) world_.removeRigidBody(resident.body.get());
  }
  FuzzWorld(const FuzzWorld&) = delete;
  FuzzWorld& operator=(const FuzzWorld&) = delete;

  void Run() {
    for (int i = 0; i < kMostOperations && !input_.IsOver(); ++i) {
      Operate();
      Check();
    }
    Step();
    Check();
  }

 private:
  void Operate() {
    switch (input_.Below(12)) {
      case 0:
      case 1:
        return Add();
      case 2:
        return Remove();
      case 3:
        return Scale();
      case 4:
        return Move();
      case 5:
        return Push();
      case 6:
        return ChangeShape();
      case 7:
        return ChangeMargin();
      case 8:
        return AskContacts();
      default:
        return Step();
    }
  }

  /// A number as a game has it, or, if `is_tame` is not so any more, any.
  btScalar Number(bool is_tame) { return btScalar(is_tame ? input_.ModerateNumber() : input_.Number()); }
  btVector3 Vector(bool is_tame) {
    const btScalar x = Number(is_tame), y = Number(is_tame), z = Number(is_tame);
    return {x, y, z};
  }
  /// Not below a centimetre.
  btScalar Length(bool is_tame) {
    return is_tame ? btScalar(0.01 + std::abs(input_.ModerateNumber()) / 4) : Number(false);
  }
  btVector3 Lengths(bool is_tame) {
    const btScalar x = Length(is_tame), y = Length(is_tame), z = Length(is_tame);
    return {x, y, z};
  }
  btTransform Pose(bool is_tame) {
    const btVector3 origin = Vector(is_tame);
    btMatrix3x3 basis = btMatrix3x3::getIdentity();
    if (!is_tame && input_.Flip()) {
      // No rotation, but of about its size; or with a number that is any.
      for (int row = 0; row < 3; ++row) basis[row] = Vector(true);
      if (input_.Flip()) basis[input_.Below(3)].setX(std::numeric_limits<btScalar>::quiet_NaN());
    } else if (input_.Flip()) {
      const btScalar yaw = Number(true), pitch = Number(true), roll = Number(true);
      basis.setEulerYPR(yaw, pitch, roll);
    }
    return btTransform(basis, origin);
  }
  bool ReadTame() { return input_.Below(4) != 0; }

  void FillShape(Resident& resident) {
    const bool is_tame = resident.is_tame;
    switch (input_.Below(12)) {
      case 0:
        resident.shape = std::make_shared<btBoxShape>(Lengths(is_tame));
        break;
      case 1:
        resident.shape = std::make_shared<btSphereShape>(Length(is_tame));
        break;
      case 2: {
        const btScalar radius = Length(is_tame), height = Length(is_tame);
        resident.shape = std::make_shared<btCapsuleShapeX>(radius, height);
        break;
      }
      case 3:
        resident.shape = std::make_shared<btCylinderShape>(Lengths(is_tame));
        break;
      case 4: {
        const btScalar radius = Length(is_tame), height = Length(is_tame);
        resident.shape = std::make_shared<btConeShapeZ>(radius, height);
        break;
      }
      case 5:
      case 6: {
        auto hull = std::make_shared<btConvexHullShape>();
        const int points = input_.Below(20);
        for (int i = 0; i < points; ++i) hull->addPoint(Vector(is_tame) / 4, false);
        hull->recalcLocalAabb();
        resident.shape = hull;
        resident.is_tame = is_tame && points > 0;
        break;
      }
      case 7: {
        const btVector3 a = Vector(is_tame), b = Vector(is_tame), c = Vector(is_tame);
        resident.shape = std::make_shared<btTriangleShape>(a, b, c);
        break;
      }
      case 8: {
        const btVector3 centers[2] = {Vector(is_tame) / 8, Vector(is_tame) / 8};
        const btScalar radii[2] = {Length(is_tame), Length(is_tame)};
        resident.shape = std::make_shared<btMultiSphereShape>(centers, radii, 2);
        break;
      }
      case 9: {
        auto points = std::make_shared<std::vector<btVector3>>();
        const int count = input_.Below(10);
        for (int i = 0; i < count; ++i) points->push_back(Vector(is_tame) / 4);
        resident.shape = std::make_shared<btConvexPointCloudShape>(points->data(), count, Lengths(is_tame));
        resident.kept_alive = points;
        resident.is_tame = is_tame && count > 0;
        break;
      }
      case 10: {
        auto child = std::make_shared<btCylinderShapeX>(Lengths(is_tame));
        if (is_continuous_) {
          // Bullet 3.24 reads null there: btCompoundCollisionAlgorithm::calculateTimeOfImpact().
          resident.shape = child;
          break;
        }
        auto compound = std::make_shared<btCompoundShape>();
        compound->addChildShape(Pose(true), child.get());
        compound->addChildShape(Pose(true), child.get());
        resident.shape = compound;
        resident.kept_alive = child;
        break;
      }
      default: {
        const auto lie = static_cast<dgd_test::Lie>(input_.Below(1 + static_cast<int>(dgd_test::kLies.size())));
        resident.shape = std::make_shared<dgd_test::LyingShape>(lie);
        // Contacts of what is somewhere else, or without end, may be as deep.
        if (lie == dgd_test::Lie::kHuge || lie == dgd_test::Lie::kInfinite) resident.is_tame = false;
      }
    }
  }

  void FinalizeBasis(Resident resident, double mass, const btTransform& pose) {
    resident.body = dgd_test::MakeRigidBody(*resident.shape, mass, pose);
    resident.body->setContactProcessingThreshold(BT_LARGE_FLOAT);
    world_.addRigidBody(resident.body.get());
    are_all_tame_ = are_all_tame_ && resident.is_tame;
    residents_.push_back(std::move(resident));
  }

  void Add() {
    if (residents_.size() >= kMostBodies) return;
    Resident resident;
    resident.is_tame = ReadTame();
    FillShape(resident);
    const double mass = input_.Below(5) == 0 ? 0 : 1 + std::abs(input_.ModerateNumber());
    const btTransform pose = Pose(resident.is_tame);
    const btScalar restitution = input_.Flip() ? 0 : 1;
    FinalizeBasis(std::move(resident), mass, pose);
    residents_.back().body->setRestitution(restitution);
  }

  Resident* Any() {
    if (residents_.empty()) return nullptr;
    return &residents_[static_cast<std::size_t>(input_.Below(static_cast<int>(residents_.size())))];
  }

  void Remove() {
    Resident* resident = Any();
    if (resident == nullptr) return;
    world_.removeRigidBody(resident->body.get());
    residents_.erase(residents_.begin() + (resident - residents_.data()));
  }

  void Scale() {
    Resident* resident = Any();
    if (resident == nullptr) return;
    Tame(*resident, ReadTame());
    btVector3 scaling = Lengths(resident->is_tame);
    if (resident->is_tame && input_.Flip()) scaling = -scaling;
    resident->shape->setLocalScaling(scaling);
  }

  void Move() {
    Resident* resident = Any();
    if (resident == nullptr) return;
    Tame(*resident, ReadTame());
    const btTransform pose = Pose(resident->is_tame);
    resident->body->setWorldTransform(pose);
    resident->body->setInterpolationWorldTransform(pose);
    resident->body->activate(true);
  }

  /// Without a CCD motion threshold, which asks for a world's own sweeps: Bullet's read points that a hull has not.
  void Push() {
    Resident* resident = Any();
    if (resident == nullptr) return;
    Tame(*resident, ReadTame());
    resident->body->setLinearVelocity(Vector(resident->is_tame));
    resident->body->setAngularVelocity(Vector(resident->is_tame));
    resident->body->activate(true);
  }

  /// Another one, perhaps at the address of the last; with the pair's algorithms kept if both are convex, as an app
  /// may.
  void ChangeShape() {
    Resident* resident = Any();
    if (resident == nullptr) return;
    const std::shared_ptr<btCollisionShape> old = std::exchange(resident->shape, nullptr);
    const std::shared_ptr<void> old_kept = std::exchange(resident->kept_alive, nullptr);
    resident->is_tame = resident->is_tame && ReadTame();
    FillShape(*resident);
    Tame(*resident, resident->is_tame);
    const bool keeps_pairs = old->isConvex() && resident->shape->isConvex();
    if (!keeps_pairs) world_.removeRigidBody(resident->body.get());
    resident->body->setCollisionShape(resident->shape.get());
    if (!keeps_pairs) world_.addRigidBody(resident->body.get());
  }

  void ChangeMargin() {
    Resident* resident = Any();
    if (resident == nullptr) return;
    Tame(*resident, ReadTame());
    resident->shape->setMargin(resident->is_tame ? std::abs(Number(true)) / 16 : Number(false));
  }

  /// As an app asks, besides the steps.
  void AskContacts() {
    struct Callback : btCollisionWorld::ContactResultCallback {
      btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                               const btCollisionObjectWrapper*, int, int) override {
        if (!dgd_test::IsFinite(point)) Fail("a contact that is not finite goes to the app");
        return 0;
      }
    } callback;
    const Resident *a = Any(), *b = Any();
    if (a == nullptr || b == nullptr || a == b) return;
    callback.m_closestDistanceThreshold = input_.Flip() ? 0 : btScalar(std::abs(input_.ModerateNumber()));
    world_.contactPairTest(a->body.get(), b->body.get(), callback);
  }

  void Step() {
    const int steps = 1 + input_.Below(4);
    for (int i = 0; i < steps; ++i) world_.stepSimulation(btScalar(1.0 / 60), 0);
  }

  /// Once wild, a body does not become tame: what it has been pushed to is not known.
  void Tame(Resident& resident, bool is_tame) {
    resident.is_tame = resident.is_tame && is_tame;
    are_all_tame_ = are_all_tame_ && resident.is_tame;
  }

  static std::string Describe(const btPersistentManifold& manifold, const btManifoldPoint& point) {
    std::ostringstream text;
    const auto print = [&](const char* name, const btVector3& v) {
      text << "\n  " << name << " " << v.x() << " " << v.y() << " " << v.z();
    };
    text << "a contact that is not finite, distance " << point.getDistance();
    print("normal", point.m_normalWorldOnB);
    print("on A", point.getPositionWorldOnA());
    print("on B", point.getPositionWorldOnB());
    for (const btCollisionObject* body : {manifold.getBody0(), manifold.getBody1()}) {
      text << "\n of " << body->getCollisionShape()->getName() << ", margin " << body->getCollisionShape()->getMargin();
      print("at", body->getWorldTransform().getOrigin());
      for (int row = 0; row < 3; ++row) print("rotation", body->getWorldTransform().getBasis()[row]);
      print("scaling", body->getCollisionShape()->getLocalScaling());
    }
    return text.str();
  }

  /// A compound's algorithm is Bullet's, and takes the contacts of its children along with a body that an app moves to
  /// infinity, before it asks whether they are still near each other.
  static bool IsRefreshedNowhere(const btPersistentManifold& manifold) {
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    const bool are_both_convex = a.getCollisionShape()->isConvex() && b.getCollisionShape()->isConvex();
    return !are_both_convex &&
           !(dgd_test::IsFinite(a.getWorldTransform()) && dgd_test::IsFinite(b.getWorldTransform()));
  }

  void Check() {
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      if (IsRefreshedNowhere(manifold)) continue;
      for (int j = 0; j < manifold.getNumContacts(); ++j) {
        if (!dgd_test::IsFinite(manifold.getContactPoint(j))) Fail(Describe(manifold, manifold.getContactPoint(j)));
      }
    }
    if (!are_all_tame_) return;
    for (const Resident& resident : residents_) {
      if (!dgd_test::IsFinite(resident.body->getWorldTransform())) Fail("a body that is not finite");
    }
  }

  FuzzInput& input_;
  const dgd_bullet::Options options_;
  const btDefaultCollisionConstructionInfo pools_;
  const bool is_continuous_;
  dgd_bullet::CollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<Resident> residents_;
  bool are_all_tame_ = true;  ///< And have been so since the start.
};

}  // namespace
}  // namespace dgd_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  dgd_fuzz::FuzzInput input({data, size});
  dgd_fuzz::FuzzWorld(input).Run();
  return 0;
}
