#include "simulation/world.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "simulation/bullet_math.h"
#include "simulation/bullet_shape.h"

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

bool IsFinite(const btRigidBody& body) {
  const Pose pose = FromBullet(body.getWorldTransform());
  return pose.position.allFinite() && pose.rotation.allFinite() && FromBullet(body.getLinearVelocity()).allFinite() &&
         FromBullet(body.getAngularVelocity()).allFinite();
}

double KineticEnergy(const btRigidBody& body) {
  const Eigen::Matrix3d rotation = FromBullet(body.getWorldTransform()).rotation;
  const Vector3d velocity = FromBullet(body.getLinearVelocity());
  const Vector3d spin = rotation.transpose() * FromBullet(body.getAngularVelocity());
  const Vector3d inertia = FromBullet(body.getLocalInertia());
  const double mass = body.getMass();
  return (mass * velocity.squaredNorm() + inertia.dot(spin.cwiseAbs2())) / 2;
}

}  // namespace

World::World(const Scene& scene, const std::vector<Body>& bodies, const NarrowphaseChoice& narrowphase)
    : configuration_(MakeCollisionConfiguration(narrowphase)),
      dispatcher_(configuration_.get()),
      world_(&dispatcher_, &broadphase_, &solver_, configuration_.get()),
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
  room_min_ = -ground;
  room_max_ = Vector3d(ground.x(), ground.y(), highest + kHeadroom);
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
  names_.push_back(body.name);
}

CollisionReport World::Step() {
  // No substeps: exactly one step of this length.
  world_.stepSimulation(ToBullet(time_step_), 0);

  CollisionReport report{};
  report.narrowphase_us = dispatcher_.last_duration().count();
  report.pairs = broadphase_.m_paircache->getNumOverlappingPairs();
  report.queries = dispatcher_.last_queries();
  report.fallbacks = Fallbacks(*configuration_) - std::exchange(fallbacks_so_far_, Fallbacks(*configuration_));
  for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(m);
    report.contacts += manifold.getNumContacts();
    for (int c = 0; c < manifold.getNumContacts(); ++c) {
      const double depth = -manifold.getContactPoint(c).getDistance();
      report.deepest_penetration = std::max(report.deepest_penetration, depth);
    }
  }
  return report;
}

std::vector<Pose> World::Poses() const {
  std::vector<Pose> poses;
  for (const auto& body : rigid_bodies_) poses.push_back(FromBullet(body->getWorldTransform()));
  return poses;
}

std::vector<BodyPair> World::OverlappingPairs() const {
  const btBroadphasePairArray& array = broadphase_.m_paircache->getOverlappingPairArray();
  std::vector<BodyPair> pairs;
  for (int i = 0; i < array.size(); ++i) {
    const auto index_of = [](const btBroadphaseProxy* proxy) {
      return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
    };
    const auto [first, second] = std::minmax({index_of(array[i].m_pProxy0), index_of(array[i].m_pProxy1)});
    pairs.push_back({first, second});
  }
  return pairs;
}

std::vector<double> World::Speeds() const {
  std::vector<double> speeds;
  for (const auto& body : rigid_bodies_) speeds.push_back(FromBullet(body->getLinearVelocity()).norm());
  return speeds;
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

std::optional<std::string> World::FindLostBody() const {
  for (std::size_t i = 0; i < rigid_bodies_.size(); ++i) {
    const btRigidBody& body = *rigid_bodies_[i];
    if (body.isStaticObject()) continue;
    if (!IsFinite(body)) return names_[i] + " has a pose or a velocity that is not finite";
    const Vector3d position = FromBullet(body.getWorldTransform().getOrigin());
    if ((position.array() < room_min_.array()).any() || (position.array() > room_max_.array()).any()) {
      std::ostringstream sentence;
      sentence << names_[i] << " left the world at (" << position.x() << ", " << position.y() << ", " << position.z()
               << ") m";
      return sentence.str();
    }
  }
  return std::nullopt;
}

}  // namespace dgd_demos
