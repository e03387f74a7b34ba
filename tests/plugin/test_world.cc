#include "plugin/test_world.h"

#include <cmath>

namespace dgd_test {

std::string Name(Route route) {
  switch (route) {
    case Route::kConfiguration:
      return "Configuration";
    case Route::kRegister:
      return "Register";
    default:
      return "Builtin";
  }
}

Dispatching::Dispatching(Route route, const dgd_bullet::Options& options,
                         const std::optional<dgd_bullet::DispatcherOptions>& dispatcher) {
  if (route == Route::kConfiguration) {
    auto configuration = std::make_unique<dgd_bullet::CollisionConfiguration>(options);
    ours_ = configuration.get();
    configuration_ = std::move(configuration);
  } else {
    configuration_ = std::make_unique<btDefaultCollisionConfiguration>();
  }
  if (dispatcher) {
    dispatcher_ = std::make_unique<dgd_bullet::CollisionDispatcher>(configuration_.get(), *dispatcher);
  } else {
    dispatcher_ = std::make_unique<btCollisionDispatcher>(configuration_.get());
  }
  if (route == Route::kRegister) registered_ = &dgd_bullet::Register(*dispatcher_, options);
}

dgd_bullet::Statistics Dispatching::statistics() const {
  if (ours_ != nullptr) return ours_->statistics();
  return registered_ != nullptr ? dgd_bullet::StatisticsOf(*registered_) : dgd_bullet::Statistics{};
}

TestWorld::TestWorld(Route route, const dgd_bullet::Options& options,
                     const std::optional<dgd_bullet::DispatcherOptions>& dispatcher)
    : dispatching_(route, options, dispatcher),
      world_(&dispatching_.dispatcher(), &broadphase_, &solver_, &dispatching_.configuration()) {
  world_.setGravity(Vec(0, 0, -9.81));
}

TestWorld::~TestWorld() {
  for (const auto& body : bodies_) world_.removeRigidBody(body.get());
}

btRigidBody& TestWorld::Add(btCollisionShape& shape, double mass, const btTransform& pose) {
  bodies_.push_back(MakeRigidBody(shape, mass, pose));
  world_.addRigidBody(bodies_.back().get());
  return *bodies_.back();
}

btRigidBody& TestWorld::Add(btCollisionShape& shape, double mass, const btVector3& position) {
  return Add(shape, mass, btTransform(btMatrix3x3::getIdentity(), position));
}

btRigidBody& TestWorld::AddGround(double half_width) {
  return Add(Make<btBoxShape>(Vec(half_width, half_width, 1)), 0, Vec(0, 0, -1));
}

void TestWorld::Simulate(double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kTimeStep));
  for (int i = 0; i < steps; ++i) world_.stepSimulation(btScalar(kTimeStep), 0);
}

std::vector<btManifoldPoint> TestWorld::Points() {
  std::vector<btManifoldPoint> points;
  for (int i = 0; i < dispatcher().getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher().getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold.getNumContacts(); ++j) points.push_back(manifold.getContactPoint(j));
  }
  return points;
}

bool IsFinite(const btVector3& vector) {
  return std::isfinite(vector.x()) && std::isfinite(vector.y()) && std::isfinite(vector.z());
}

bool IsFinite(const btTransform& transform) {
  btScalar sum = 0;
  for (int row = 0; row < 3; ++row)
    sum += transform.getBasis()[row].dot(btVector3(1, 1, 1)) + transform.getOrigin()[row];
  return std::isfinite(sum);
}

bool IsFinite(const btManifoldPoint& point) {
  return std::isfinite(point.getDistance()) && IsFinite(point.m_normalWorldOnB) && IsFinite(point.m_localPointA) &&
         IsFinite(point.m_localPointB) && IsFinite(point.getPositionWorldOnA()) &&
         IsFinite(point.getPositionWorldOnB());
}

}  // namespace dgd_test
