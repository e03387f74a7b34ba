#include "simulation/world.h"

#include <algorithm>
#include <utility>

#include "simulation/bullet_math.h"
#include "simulation/bullet_shape.h"
#include "simulation/bullet_state.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

// A body this far above the highest start was thrown there by the contact solver. m
constexpr double kHeadroom = 10;

Vector3d BulletInertia(const Body& body, const btConvexShape& shape) {
  if (body.mass == 0) return Vector3d::Zero();
  if (body.inertia) return *body.inertia;
  btVector3 inertia;
  shape.calculateLocalInertia(ToBullet(body.mass), inertia);
  return FromBullet(inertia);
}

}  // namespace

World::World(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase)
    : configuration_(MakeCollisionConfiguration(narrowphase)),
      dispatcher_(configuration_.get()),
      world_(&dispatcher_, &broadphase_, &solver_, configuration_.get()),
      oracle_bodies_(OracleBodiesOf(bodies)),
      may_sleep_(scene.sleeping),
      gravity_(scene.gravity),
      time_step_(scene.time_step) {
  world_.setGravity(ToBullet(gravity_));
  world_.getSolverInfo().m_numIterations = scene.solver.iterations;
  if (scene.solver.friction_directions == 2) world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  for (std::size_t i = 0; i < bodies.size(); ++i) AddBody(bodies[i], static_cast<int>(i));

  // The column above the ground, down to the middle of the ground: below that, a body has gone through.
  double highest = 0;
  for (const Body& body : bodies) highest = std::max(highest, body.pose.position.z());
  const Vector3d& ground = scene.ground.half_extents;
  room_ = {-ground, Vector3d(ground.x(), ground.y(), highest + kHeadroom)};
}

void World::AddBody(const Body& body, int index) {
  shapes_.push_back(MakeBulletShape(body.shape, body.margin));
  btRigidBody::btRigidBodyConstructionInfo info(ToBullet(body.mass), nullptr, shapes_.back().get(),
                                                ToBullet(BulletInertia(body, *shapes_.back())));
  info.m_startWorldTransform = ToBullet(body.pose);
  info.m_friction = ToBullet(body.friction);
  info.m_restitution = ToBullet(body.restitution);
  info.m_linearDamping = info.m_angularDamping = ToBullet(body.damping);
  rigid_bodies_.push_back(std::make_unique<btRigidBody>(info));
  rigid_bodies_.back()->setUserIndex(index);
  rigid_bodies_.back()->setLinearVelocity(ToBullet(body.motion.velocity));
  rigid_bodies_.back()->setAngularVelocity(ToBullet(body.motion.angular_velocity));
  if (!may_sleep_) rigid_bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
  world_.addRigidBody(rigid_bodies_.back().get());
  bodies_.push_back(SimulatedBodyOf(body));
}

CollisionReport World::Step() {
  const std::uint64_t fallbacks_before = Fallbacks(*configuration_);
  // No substeps: exactly one step of this length.
  world_.stepSimulation(ToBullet(time_step_), 0);
  return ReportStep(dispatcher_, *broadphase_.m_paircache, Fallbacks(*configuration_) - fallbacks_before);
}

std::vector<Pose> World::Poses() const {
  std::vector<Pose> poses;
  for (const auto& body : rigid_bodies_) poses.push_back(FromBullet(body->getWorldTransform()));
  return poses;
}

std::vector<BodyPair> World::OverlappingPairs() const { return IndexPairs(*broadphase_.m_paircache); }

std::vector<Motion> World::Motions() const {
  std::vector<Motion> motions;
  for (const auto& body : rigid_bodies_) {
    motions.push_back({FromBullet(body->getLinearVelocity()), FromBullet(body->getAngularVelocity())});
  }
  return motions;
}

Energy World::TotalEnergy() const {
  Energy energy{0, 0};
  for (const auto& body : rigid_bodies_) {
    if (body->isStaticObject()) continue;
    energy.kinetic += KineticEnergy(*body);
    energy.potential -= body->getMass() * gravity_.dot(FromBullet(body->getWorldTransform().getOrigin()));
  }
  return energy;
}

}  // namespace dgd_demos
