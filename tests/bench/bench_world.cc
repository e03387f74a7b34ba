#include "bench/bench_world.h"

#include <dgd_bullet/collision_dispatcher.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

#include "bench/percentile.h"

namespace dgd_bench {

BenchWorld::BenchWorld(dgd_demos::Narrowphase narrowphase, int threads)
    : configuration_(dgd_demos::MakeCollisionConfiguration(narrowphase)),
      cost_(MakeDispatcher(threads)),
      world_(dispatcher_.get(), &broadphase_, &solver_, configuration_.get()),
      floor_([](double, double) { return 0.0; }) {
  world_.setGravity(Vec(0, 0, -9.81));
}

const dgd_demos::DispatchCost& BenchWorld::MakeDispatcher(int threads) {
  const auto make = [this]<class Dispatcher>(std::unique_ptr<Dispatcher> dispatcher) -> const dgd_demos::DispatchCost& {
    const Dispatcher& cost = *dispatcher;
    dispatcher_ = std::move(dispatcher);
    return cost;
  };
  if (threads == 0) return make(std::make_unique<dgd_demos::TimingDispatcher>(configuration_.get()));
  using Dispatcher = dgd_demos::TimingDispatcherOf<dgd_bullet::CollisionDispatcher>;
  return make(std::make_unique<Dispatcher>(configuration_.get(), dgd_bullet::DispatcherOptions{.threads = threads}));
}

BenchWorld::~BenchWorld() {
  for (const auto& constraint : constraints_) world_.removeConstraint(constraint.get());
  for (const auto& body : bodies_) world_.removeRigidBody(body.get());
}

btRigidBody& BenchWorld::Add(btCollisionShape& shape, double mass, const btTransform& pose) {
  bodies_.push_back(dgd_test::MakeRigidBody(shape, mass, pose));
  world_.addRigidBody(bodies_.back().get());
  return *bodies_.back();
}

void BenchWorld::Add(std::unique_ptr<btTypedConstraint> constraint) {
  world_.addConstraint(constraint.get(), true);
  constraints_.push_back(std::move(constraint));
}

void BenchWorld::AddGround(double half_width) {
  Add(Make<btBoxShape>(Vec(half_width, half_width, 5)), 0, At(Vec(0, 0, -5)));
}

void BenchWorld::TakePlacesFrom(const BenchWorld& other) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    btRigidBody& body = *bodies_[i];
    const btRigidBody& from = *other.bodies_[i];
    if (body.isStaticObject()) continue;
    body.setCenterOfMassTransform(from.getCenterOfMassTransform());
    body.setInterpolationWorldTransform(from.getCenterOfMassTransform());
    body.setLinearVelocity(from.getLinearVelocity());
    body.setAngularVelocity(from.getAngularVelocity());
    body.activate(true);
  }
}

StepCost BenchWorld::Step() {
  const auto start = std::chrono::steady_clock::now();
  world_.stepSimulation(btScalar(kTimeStep), 0);
  const std::chrono::duration<double, std::milli> duration = std::chrono::steady_clock::now() - start;
  return {cost_.last_duration().count() / 1000, duration.count(), cost_.last_queries()};
}

WorldState BenchWorld::State() const {
  constexpr double kInto = 0.3;  // A centre of mass this far below the floor is not just a body deep in it.
  WorldState state;
  double squares = 0;
  std::vector<double> speeds;
  for (const auto& body : bodies_) {
    if (body->isStaticObject()) continue;
    const btVector3& at = body->getWorldTransform().getOrigin();
    const double speed = double(body->getLinearVelocity().length());
    const double height = double(at.z()) - floor_(double(at.x()), double(at.y()));
    state.lost += std::isfinite(speed) && height > -kInto ? 0 : 1;
    state.awake += body->isActive() ? 1 : 0;
    squares += speed * speed;
    speeds.push_back(speed);
  }
  if (speeds.empty()) return state;
  state.rms_speed = std::sqrt(squares / double(speeds.size()));
  std::ranges::sort(speeds);
  state.p90_speed = Percentile(speeds, 0.9);
  return state;
}

int BenchWorld::MovingBodies() const {
  return static_cast<int>(std::ranges::count_if(bodies_, [](const auto& body) { return !body->isStaticObject(); }));
}

}  // namespace dgd_bench
