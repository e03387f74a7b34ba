#include "soak/stirred_heap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plugin/shape_zoo.h"

namespace dgd_soak {
namespace {

using dgd_test::Vec;

constexpr double kPit = 3;          // Half its width, m.
constexpr double kStirring = 0.4;   // Turns of the paddle, 1/s.
constexpr double kFall = 5;         // Height that bodies fall from, m.
constexpr int kStepsToReplace = 6;  // A tenth of a second.
constexpr double kDensity = 500;    // kg of a body of 1 m.

/// Half the paddle's length, m. It leaves 1.2 m to the walls, and no body is wider than 1 m: a kinematic body yields to
/// nothing, and what it presses against a wall leaves the pit in the end, whatever finds the contacts.
constexpr double kPaddle = 0.6 * kPit;

}  // namespace

StirredHeap::StirredHeap(int bodies, std::uint64_t seed)
    : random_(seed),
      dispatching_(dgd_test::Route::kConfiguration),
      world_(&dispatching_.dispatcher(), &broadphase_, &solver_, &dispatching_.configuration()) {
  world_.setGravity(Vec(0, 0, -9.81));
  AddPit();
  for (int i = 0; i < bodies; ++i) FinalizeBasis(MakeResident());
}

StirredHeap::~StirredHeap() {
  for (const std::vector<Resident>* residents : {&residents_, &pit_}) {
    for (const Resident& resident : *residents) world_.removeRigidBody(resident.body.get());
  }
}

void StirredHeap::Step() {
  time_ += kTimeStep;
  if (++steps_ % kStepsToReplace == 0) ReplaceOne();
  const double angle = 2 * std::numbers::pi * kStirring * time_;
  pit_.back().body->setWorldTransform(btTransform(
      btMatrix3x3(btQuaternion(btVector3(0, 0, 1), btScalar(std::fmod(angle, 2 * std::numbers::pi)))), Vec(0, 0, 0.6)));
  world_.stepSimulation(btScalar(kTimeStep), 0);
}

void StirredHeap::AddPit() {
  AddStatic(std::make_shared<btBoxShape>(Vec(3 * kPit, 3 * kPit, 1)), Vec(0, 0, -1));
  for (const double side : {-1.0, 1.0}) {
    AddStatic(std::make_shared<btBoxShape>(Vec(1, kPit + 2, 20)), Vec(side * (kPit + 1), 0, 20));
    AddStatic(std::make_shared<btBoxShape>(Vec(kPit + 2, 1, 20)), Vec(0, side * (kPit + 1), 20));
  }
  AddStatic(std::make_shared<btBoxShape>(Vec(kPaddle, 0.15, 0.5)), Vec(0, 0, 0.6));
  btRigidBody& paddle = *pit_.back().body;
  paddle.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  paddle.setActivationState(DISABLE_DEACTIVATION);
}

void StirredHeap::AddStatic(std::shared_ptr<btConvexShape> shape, const btVector3& position) {
  Resident resident;
  resident.body = dgd_test::MakeRigidBody(*shape, 0, btTransform(btMatrix3x3::getIdentity(), position));
  resident.shape = std::move(shape);
  world_.addRigidBody(resident.body.get());
  pit_.push_back(std::move(resident));
}

StirredHeap::Resident StirredHeap::MakeResident() {
  const double size = random_.LogUniform(0.2, 0.7);
  Resident resident;
  if (random_.Flip()) {
    // A hull of its own: what there is memory of beyond a body's life.
    resident.shape = dgd_test::MakeRandomHull(random_, 8 + random_.Below(80), size);
  } else {
    std::vector<dgd_test::ZooShape> zoo = dgd_test::MakeShapeZoo(size);
    dgd_test::ZooShape& chosen = zoo[static_cast<std::size_t>(random_.Below(static_cast<int>(zoo.size())))];
    resident.shape = std::move(chosen.shape);
    resident.kept_alive = std::move(chosen.kept_alive);
  }
  const double mass = kDensity * size * size * size;
  const btVector3 position =
      Vec(random_.Uniform(-0.7, 0.7) * kPit, random_.Uniform(-0.7, 0.7) * kPit, random_.Uniform(1, kFall));
  const btTransform pose(btMatrix3x3(btQuaternion(btScalar(random_.Uniform(0, 6)), btScalar(random_.Uniform(0, 6)),
                                                  btScalar(random_.Uniform(0, 6)))),
                         position);
  resident.body = dgd_test::MakeRigidBody(*resident.shape, mass, pose);
  return resident;
}

void StirredHeap::FinalizeBasis(Resident resident) {
  world_.addRigidBody(resident.body.get());
  residents_.push_back(std::move(resident));
}

void StirredHeap::ReplaceOne() {
  Resident& leaving = residents_[static_cast<std::size_t>(random_.Below(static_cast<int>(residents_.size())))];
  world_.removeRigidBody(leaving.body.get());
  std::swap(leaving, residents_.back());
  residents_.pop_back();
  FinalizeBasis(MakeResident());
  ++replaced_;
}

bool StirredHeap::IsFinite() {
  for (const Resident& resident : residents_) {
    const btRigidBody& body = *resident.body;
    if (!dgd_test::IsFinite(body.getWorldTransform()) || !dgd_test::IsFinite(body.getLinearVelocity()) ||
        !dgd_test::IsFinite(body.getAngularVelocity())) {
      return false;
    }
  }
  for (int i = 0; i < Manifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatching_.dispatcher().getManifoldByIndexInternal(i);
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      if (!dgd_test::IsFinite(point) || !std::isfinite(point.getAppliedImpulse())) return false;
    }
  }
  return true;
}

int StirredHeap::Escaped() const {
  int escaped = 0;
  for (const Resident& resident : residents_) {
    const btVector3& at = resident.body->getWorldTransform().getOrigin();
    const double aside = std::max(std::abs(double(at.x())), std::abs(double(at.y())));
    escaped += !(aside <= kPit + 0.5 && at.z() >= -0.5);
  }
  return escaped;
}

int StirredHeap::Contacts() {
  int contacts = 0;
  for (int i = 0; i < Manifolds(); ++i) {
    contacts += dispatching_.dispatcher().getManifoldByIndexInternal(i)->getNumContacts();
  }
  return contacts;
}

}  // namespace dgd_soak
