// A world from a .bullet file, on any narrowphase: one object that owns everything.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/narrowphase.h"
#include "simulation/simulated_world.h"
#include "simulation/timing_dispatcher.h"
#include "world_file/checked_world.h"
#include "world_file/restore.h"

class btBulletWorldImporter;

namespace dgd_demos {

/// Reads and checks a file for the Bullet that is linked here. @throws SceneError as ReadBulletFile() and CheckWorld().
CheckedWorld LoadWorldFile(const std::filesystem::path& file);
/// The same for the bytes of a file. @param name  Name of the file in messages.
CheckedWorld LoadWorldBytes(const std::string& name, std::vector<std::byte> bytes);

/// What Bullet's importer makes of the file, and what it leaves out though the file has it: links' colliders,
/// velocities, inertia, damping, gravity of single bodies, collision flags and filters, sleep, and the exact sizes of
/// scaled boxes and cylinders.
class ImportedWorld : public SimulatedWorld {
 public:
  /// @param time_step  s; without it, that of the last step before the world was written.
  ImportedWorld(const CheckedWorld& file, const NarrowphaseChoice& narrowphase,
                std::optional<double> time_step = std::nullopt);
  ~ImportedWorld() override;

  /// Sentences about parts that are not restored, and about shapes that the oracle does not judge.
  const std::vector<std::string>& Remarks() const { return remarks_; }
  int ConstraintCount() const { return world_->getNumConstraints(); }

  void ShowQueriesTo(dgd_bullet::PairObserver& observer) override { dispatcher_.ShowQueriesTo(observer); }
  double time_step() const override { return time_step_; }
  CollisionReport Step() override;

  /// Rigid bodies, then static collision objects, then links of multibodies that have a shape.
  const std::vector<SimulatedBody>& Bodies() const override { return bodies_; }
  std::vector<OracleBody> OracleBodies() const override { return oracle_bodies_; }
  std::vector<Pose> Poses() const override;
  /// Pairs that may collide. Pairs whose boxes overlap are left out if they are two bodies of a constraint, neighbours
  /// in a multibody, or objects without contact response.
  std::vector<BodyPair> OverlappingPairs() const override;
  std::vector<Motion> Motions() const override;
  Energy TotalEnergy() const override;
  Eigen::AlignedBox3d Room() const override { return room_; }
  btDynamicsWorld& Bullet() override { return *world_; }

 private:
  void Import(const CheckedWorld& file);
  void AddBodies(const CheckedWorld& file);
  void AddMultibodies(const CheckedWorld& file);
  void AddCollider(const ColliderData& data, btMultiBody& multibody);
  void AddBody(btCollisionObject& object, std::string name, bool moves);
  void FindRoom();
  void AddRemarks();

  // Members in order of construction: each refers to those above it until it is destroyed.
  std::unique_ptr<btDefaultCollisionConfiguration> configuration_;
  TimingDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
  std::unique_ptr<btBulletWorldImporter> importer_;
  // The importer does not own these.
  std::vector<std::unique_ptr<btMultiBody>> multibodies_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;

  std::vector<btCollisionObject*> objects_;
  std::vector<SimulatedBody> bodies_;  // Bodies of the objects, in their order.
  std::vector<OracleBody> oracle_bodies_;
  std::vector<std::string> remarks_;
  Eigen::AlignedBox3d room_;
  double time_step_;
};

}  // namespace dgd_demos
