// Worlds as other programs make them, written by Bullet's serializer: nothing here is the project's.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace dgd_test {

/// A Bullet world with all that it refers to.
class BulletWorld {
 public:
  explicit BulletWorld(bool has_multibodies);
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;
  ~BulletWorld();

  btDiscreteDynamicsWorld& world() { return *world_; }
  btMultiBodyDynamicsWorld& multibody_world() { return static_cast<btMultiBodyDynamicsWorld&>(*world_); }

  template <class Shape, class... Arguments>
  Shape& Make(Arguments&&... arguments) {
    auto shape = std::make_shared<Shape>(std::forward<Arguments>(arguments)...);
    Shape& made = *shape;
    owned_.push_back(std::move(shape));
    return made;
  }
  /// @param mass  kg; 0: static.
  btRigidBody& Add(btCollisionShape& shape, btScalar mass, const btTransform& pose);
  btRigidBody& Add(btCollisionShape& shape, btScalar mass, const btVector3& position);
  /// A box of 20 m by 20 m, its top at z = 0.
  btRigidBody& AddGround();
  void Join(std::unique_ptr<btTypedConstraint> constraint);
  void Add(std::unique_ptr<btCollisionObject> object);
  void Add(std::unique_ptr<btMultiBody> multibody);
  void AddLinkCollider(btMultiBody& multibody, int link, btCollisionShape& shape);

  /// The file, and the bodies in their order in it.
  std::vector<std::byte> Serialize(int flags = 0);
  std::vector<const btRigidBody*> Bodies() const;

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::vector<std::shared_ptr<void>> owned_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
  std::vector<std::unique_ptr<btMultiBody>> multibodies_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

struct WorldCase {
  std::string name;
  std::unique_ptr<BulletWorld> (*make)();
};
const std::vector<WorldCase>& AllWorldCases();
/// By its name.
std::unique_ptr<BulletWorld> MakeWorld(const std::string& name);

/// One sphere that falls: the smallest world of use.
std::unique_ptr<BulletWorld> MakeFallingSphere();

}  // namespace dgd_test
