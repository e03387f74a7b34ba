// Bodies in a pit that a paddle stirs, and that come and go all the time: a world that never comes to an end.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "plugin/test_world.h"
#include "support/random.h"

namespace dgd_soak {

class StirredHeap {
 public:
  static constexpr double kTimeStep = 1.0 / 60;

  /// @param bodies  That are in the pit at a time, of all convex types.
  StirredHeap(int bodies, std::uint64_t seed);
  ~StirredHeap();
  StirredHeap(const StirredHeap&) = delete;
  StirredHeap& operator=(const StirredHeap&) = delete;

  /// One time step. Each tenth of a second a body leaves, with its shape, and another one with a shape of its own, most
  /// often where the last one's memory was, falls in.
  void Step();

  /// Whether all bodies and all contacts are finite.
  bool IsFinite();
  /// Bodies that are not in the pit any more.
  int Escaped() const;

  int Manifolds() { return dispatching_.dispatcher().getNumManifolds(); }
  int Contacts();
  int Replaced() const { return replaced_; }
  dgd_bullet::Statistics statistics() const { return dispatching_.statistics(); }

 private:
  struct Resident {
    std::shared_ptr<btConvexShape> shape;
    std::vector<std::shared_ptr<void>> kept_alive;  ///< What the shape refers to.
    std::unique_ptr<btRigidBody> body;
  };

  void AddPit();
  void AddStatic(std::shared_ptr<btConvexShape> shape, const btVector3& position);
  Resident MakeResident();
  void FinalizeBasis(Resident resident);
  void ReplaceOne();

  dgd_test::Random random_;
  dgd_test::Dispatching dispatching_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<Resident> pit_;  ///< Ground, walls, and last the paddle.
  std::vector<Resident> residents_;
  double time_ = 0;
  int steps_ = 0, replaced_ = 0;
};

}  // namespace dgd_soak
