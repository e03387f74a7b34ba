// A dispatcher with the narrowphase under test, and a world around it.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dgd_bullet/collision_configuration.h"
#include "dgd_bullet/collision_dispatcher.h"
#include "dgd_bullet/register.h"
#include "plugin/bullet_oracle.h"
#include "plugin/rigid_body.h"

namespace dgd_test {

/// Metres: roundoff of float positions of a few metres, and contact points through the manifold.
inline constexpr double kLength = 1e-5;

/// How a dispatcher gets its narrowphase.
enum class Route { kConfiguration, kRegister, kBuiltin };
std::string Name(Route route);

/// With the statistics by pair of types.
inline dgd_bullet::Options Counting() {
  dgd_bullet::Options options;
  options.count_pairs = true;
  return options;
}

/// Configuration and dispatcher in one.
class Dispatching {
 public:
  /// @param dispatcher  For dgd_bullet::CollisionDispatcher in place of btCollisionDispatcher.
  explicit Dispatching(Route route, const dgd_bullet::Options& options = {},
                       const std::optional<dgd_bullet::DispatcherOptions>& dispatcher = std::nullopt);

  btCollisionDispatcher& dispatcher() { return *dispatcher_; }
  btDefaultCollisionConfiguration& configuration() { return *configuration_; }
  dgd_bullet::Statistics statistics() const;

 private:
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  const dgd_bullet::CollisionConfiguration* ours_ = nullptr;
  const dgd_bullet::Narrowphase* registered_ = nullptr;
};

/// A world that owns its bodies; z is up. Shapes are the world's too, from Make() or Keep(), or outlive it.
class TestWorld {
 public:
  static constexpr double kTimeStep = 1.0 / 240;

  /// @param dispatcher  For dgd_bullet::CollisionDispatcher in place of btCollisionDispatcher.
  explicit TestWorld(Route route, const dgd_bullet::Options& options = {},
                     const std::optional<dgd_bullet::DispatcherOptions>& dispatcher = std::nullopt);
  ~TestWorld();
  TestWorld(const TestWorld&) = delete;
  TestWorld& operator=(const TestWorld&) = delete;

  /// @param mass  0 for a static body.
  btRigidBody& Add(btCollisionShape& shape, double mass, const btTransform& pose);
  btRigidBody& Add(btCollisionShape& shape, double mass, const btVector3& position);
  /// A static box whose top is the plane z = 0.
  btRigidBody& AddGround(double half_width = 10);
  /// Holds a shape, or what a shape refers to, as long as the bodies.
  template <class T>
  T& Keep(std::shared_ptr<T> kept) {
    T& reference = *kept;
    kept_.emplace_back(std::move(kept));
    return reference;
  }
  template <class T, class... Arguments>
  T& Make(Arguments&&... arguments) {
    return Keep(std::make_shared<T>(std::forward<Arguments>(arguments)...));
  }

  void Simulate(double seconds);
  /// One collision detection without motion.
  void Detect() { world_.performDiscreteCollisionDetection(); }

  btDiscreteDynamicsWorld& world() { return world_; }
  btCollisionDispatcher& dispatcher() { return dispatching_.dispatcher(); }
  dgd_bullet::Statistics statistics() const { return dispatching_.statistics(); }
  /// All contact points of all manifolds.
  std::vector<btManifoldPoint> Points();

 private:
  std::vector<std::shared_ptr<void>> kept_;
  Dispatching dispatching_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

bool IsFinite(const btVector3& vector);
/// Whether all twelve numbers are finite.
bool IsFinite(const btTransform& transform);
/// Distance, normal and positions, on the bodies and in the world.
bool IsFinite(const btManifoldPoint& point);

}  // namespace dgd_test
