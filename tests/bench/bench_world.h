// A Bullet world that owns what is put into it and times its narrowphase. z is up; metres, kilograms, seconds.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "plugin/rigid_body.h"
#include "simulation/narrowphase.h"
#include "simulation/timing_dispatcher.h"

namespace dgd_bench {

/// What a step cost.
struct StepCost {
  double narrowphase_ms = 0, step_ms = 0;
  int queries = 0;
};

/// How the moving bodies are.
struct WorldState {
  double rms_speed = 0;  ///< m/s
  double p90_speed = 0;  ///< Nine in ten are no faster; m/s
  int awake = 0;
  int lost = 0;  ///< Below the floor, or not finite.
};

class BenchWorld {
 public:
  /// Height of the floor at a place of the ground.
  using Floor = std::function<double(double x, double y)>;

  /// @param threads  0 for btCollisionDispatcher; else those of dgd_bullet::CollisionDispatcher.
  explicit BenchWorld(dgd_demos::Narrowphase narrowphase, int threads = 0);
  ~BenchWorld();
  BenchWorld(const BenchWorld&) = delete;
  BenchWorld& operator=(const BenchWorld&) = delete;

  /// Makes a shape, or what a shape refers to, and holds it as long as the bodies.
  template <class T, class... Arguments>
  T& Make(Arguments&&... arguments) {
    auto made = std::make_shared<T>(std::forward<Arguments>(arguments)...);
    kept_.push_back(made);
    return *made;
  }

  /// @param mass  0 for a static body.
  btRigidBody& Add(btCollisionShape& shape, double mass, const btTransform& pose);
  /// The linked bodies do not collide with each other.
  void Add(std::unique_ptr<btTypedConstraint> constraint);
  /// A static box with its top at z = 0.
  void AddGround(double half_width);
  void SetFloor(Floor floor) { floor_ = std::move(floor); }

  /// The bodies' poses and speeds from a world that was built alike; all are awake then.
  void TakePlacesFrom(const BenchWorld& other);

  /// A step of a 60th of a second.
  StepCost Step();
  WorldState State() const;
  int MovingBodies() const;
  btDiscreteDynamicsWorld& world() { return world_; }
  const btCollisionConfiguration& configuration() const { return *configuration_; }

  static constexpr double kTimeStep = 1.0 / 60;

 private:
  /// Makes `dispatcher_`.
  /// @return what it takes.
  const dgd_demos::DispatchCost& MakeDispatcher(int threads);

  std::vector<std::shared_ptr<void>> kept_;
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  std::unique_ptr<btCollisionDispatcher> dispatcher_;
  const dgd_demos::DispatchCost& cost_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
  Floor floor_;
};

using dgd_test::Vec;
inline btTransform At(const btVector3& place, const btQuaternion& turn = btQuaternion::getIdentity()) {
  return btTransform(turn, place);
}

}  // namespace dgd_bench
