#include "world_file/bullet_worlds.h"

#include <BulletCollision/CollisionShapes/btScaledBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace dgd_test {
namespace {

btTransform At(const btVector3& position, const btVector3& axis = {0, 0, 1}, btScalar angle = 0) {
  return btTransform(btQuaternion(axis.normalized(), angle), position);
}

std::unique_ptr<BulletWorld> MakeBoxes() {
  auto world = std::make_unique<BulletWorld>(false);
  world->AddGround();
  auto& box = world->Make<btBoxShape>(btVector3(btScalar(0.3), btScalar(0.4), btScalar(0.5)));
  auto& scaled = world->Make<btBoxShape>(btVector3(btScalar(0.5), btScalar(0.5), btScalar(0.25)));
  scaled.setLocalScaling(btVector3(1, btScalar(0.5), 2));
  for (int i = 0; i < 5; ++i) {
    auto& body = world->Add(i % 2 == 0 ? box : scaled, btScalar(1 + i),
                            btVector3(btScalar(0.05) * btScalar(i), 0, btScalar(0.6 + 1.1 * i)));
    body.setLinearVelocity(btVector3(btScalar(0.1), btScalar(-0.2) * btScalar(i), 0));
    body.setAngularVelocity(btVector3(0, btScalar(0.3), btScalar(0.7)));
    body.setDamping(btScalar(0.02), btScalar(0.04));
    body.setFriction(btScalar(0.7));
  }
  return world;
}

void AddHull(BulletWorld& world, int seed) {
  auto& hull = world.Make<btConvexHullShape>();
  for (int i = 0; i < 20; ++i) {
    const btScalar a = btScalar(1.3 * i + seed), b = btScalar(0.9 * i);
    hull.addPoint(btScalar(0.5) * btVector3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
  }
  if (seed % 2 == 1) hull.setLocalScaling(btVector3(1, btScalar(0.8), btScalar(1.2)));
  world.Add(hull, 2,
            At(btVector3(btScalar(0.1) * btScalar(seed), 0, btScalar(0.8 + 1.2 * seed)), {1, 2, 3}, btScalar(seed)));
}

std::unique_ptr<BulletWorld> MakeHulls() {
  auto world = std::make_unique<BulletWorld>(false);
  world->AddGround();
  for (int seed = 0; seed < 6; ++seed) AddHull(*world, seed);
  return world;
}

std::unique_ptr<BulletWorld> MakePrimitives() {
  auto world = std::make_unique<BulletWorld>(false);
  world->AddGround();
  const btScalar r = btScalar(0.4), h = btScalar(0.8);
  std::vector<btCollisionShape*> shapes = {&world->Make<btSphereShape>(r),
                                           &world->Make<btCapsuleShape>(r, h),
                                           &world->Make<btCapsuleShapeX>(r, h),
                                           &world->Make<btCapsuleShapeZ>(r, h),
                                           &world->Make<btCylinderShape>(btVector3(r, h, r)),
                                           &world->Make<btCylinderShapeX>(btVector3(h, r, r)),
                                           &world->Make<btCylinderShapeZ>(btVector3(r, r, h)),
                                           &world->Make<btConeShape>(r, h),
                                           &world->Make<btConeShapeX>(r, h),
                                           &world->Make<btConeShapeZ>(r, h)};
  auto& scaled_cylinder = world->Make<btCylinderShapeZ>(btVector3(r, r, r));
  scaled_cylinder.setLocalScaling(btVector3(btScalar(1.5), btScalar(1.5), btScalar(0.5)));
  auto& scaled_cone = world->Make<btConeShapeZ>(r, h);
  scaled_cone.setLocalScaling(btVector3(2, 2, btScalar(0.5)));
  auto& scaled_sphere = world->Make<btSphereShape>(r);
  scaled_sphere.setLocalScaling(btVector3(2, 2, 2));
  shapes.insert(shapes.end(), {&scaled_cylinder, &scaled_cone, &scaled_sphere});
  const std::vector<btVector3> centres = {btVector3(-r, 0, 0), btVector3(r, 0, 0)};
  const std::vector<btScalar> radii = {r, r}, unequal = {r, r / 2};
  shapes.push_back(&world->Make<btMultiSphereShape>(centres.data(), radii.data(), 2));
  shapes.push_back(&world->Make<btMultiSphereShape>(centres.data(), unequal.data(), 2));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const btScalar x = btScalar(3) * btScalar(i % 4) - 4, y = btScalar(3) * btScalar(i / 4) - 4;
    world->Add(*shapes[i], 1, At(btVector3(x, y, 2), {1, 1, 0}, btScalar(0.3) * btScalar(i)));
  }
  return world;
}

std::unique_ptr<BulletWorld> MakeCompounds() {
  auto world = std::make_unique<BulletWorld>(false);
  world->AddGround();
  auto& box = world->Make<btBoxShape>(btVector3(btScalar(0.5), btScalar(0.1), btScalar(0.1)));
  auto& ball = world->Make<btSphereShape>(btScalar(0.25));
  auto& bell = world->Make<btCompoundShape>();
  bell.addChildShape(At(btVector3(0, 0, 0)), &box);
  bell.addChildShape(At(btVector3(btScalar(-0.5), 0, 0)), &ball);
  bell.addChildShape(At(btVector3(btScalar(0.5), 0, 0)), &ball);
  auto& nested = world->Make<btCompoundShape>();
  nested.addChildShape(At(btVector3(0, 0, btScalar(0.4))), &bell);
  nested.addChildShape(At(btVector3(0, 0, btScalar(-0.4)), {0, 0, 1}, btScalar(1.5)), &bell);
  for (int i = 0; i < 3; ++i) world->Add(bell, 2, btVector3(0, btScalar(0.2) * btScalar(i), btScalar(1 + i)));
  world->Add(nested, 3, btVector3(3, 0, 2));
  // Bullet writes this shape twice: as a child and as a body's.
  world->Add(ball, 1, btVector3(-3, 0, 1));
  return world;
}

btTriangleMesh& MakeTerrainMesh(BulletWorld& world, bool in_32_bits) {
  auto& mesh = world.Make<btTriangleMesh>(in_32_bits, /*use4componentVertices=*/false);
  const auto point = [](int i, int j) {
    return btVector3(btScalar(2 * i - 10), btScalar(2 * j - 10), btScalar(0.1 * std::sin(1.7 * i) * std::cos(1.3 * j)));
  };
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) {
      mesh.addTriangle(point(i, j), point(i + 1, j), point(i + 1, j + 1));
      mesh.addTriangle(point(i, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
  return mesh;
}

void DropSome(BulletWorld& world) {
  auto& box = world.Make<btBoxShape>(btVector3(btScalar(0.4), btScalar(0.4), btScalar(0.4)));
  auto& ball = world.Make<btSphereShape>(btScalar(0.4));
  for (int i = 0; i < 6; ++i) {
    world.Add(i % 2 == 0 ? static_cast<btCollisionShape&>(box) : ball, 1,
              btVector3(btScalar(1.5 * i - 4), btScalar(0.3 * i), btScalar(1.2)));
  }
}

std::unique_ptr<BulletWorld> MakeTerrain() {
  auto world = std::make_unique<BulletWorld>(false);
  auto& shape = world->Make<btBvhTriangleMeshShape>(&MakeTerrainMesh(*world, true), true);
  world->Add(shape, 0, btVector3(0, 0, 0));
  DropSome(*world);
  AddHull(*world, 1);
  return world;
}

std::unique_ptr<BulletWorld> MakeScaledTerrain() {
  auto world = std::make_unique<BulletWorld>(false);
  auto& mesh = world->Make<btBvhTriangleMeshShape>(&MakeTerrainMesh(*world, false), true);
  auto& shape = world->Make<btScaledBvhTriangleMeshShape>(&mesh, btVector3(1, btScalar(0.8), btScalar(1.5)));
  world->Add(shape, 0, btVector3(0, 0, 0));
  DropSome(*world);
  return world;
}

std::unique_ptr<BulletWorld> MakePlane() {
  auto world = std::make_unique<BulletWorld>(false);
  auto& plane = world->Make<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(-0.5));
  auto object = std::make_unique<btCollisionObject>();
  object->setCollisionShape(&plane);
  object->setWorldTransform(At(btVector3(0, 0, btScalar(0.5))));
  object->setFriction(btScalar(0.8));
  world->Add(std::move(object));
  AddHull(*world, 0);
  auto& box = world->Make<btBoxShape>(btVector3(btScalar(0.4), btScalar(0.4), btScalar(0.4)));
  box.setMargin(btScalar(0.01));
  world->Add(box, 1, btVector3(3, 0, 1));
  auto& cylinder = world->Make<btCylinderShapeZ>(btVector3(btScalar(0.4), btScalar(0.4), btScalar(0.4)));
  cylinder.setMargin(btScalar(0.1));
  world->Add(cylinder, 1, btVector3(-3, 0, 1));
  return world;
}

std::unique_ptr<BulletWorld> MakeRagdoll() {
  auto world = std::make_unique<BulletWorld>(false);
  world->AddGround();
  const auto limb = [&](double radius, double length, double x, double z) -> btRigidBody& {
    return world->Add(world->Make<btCapsuleShapeZ>(btScalar(radius), btScalar(length)), 1,
                      btVector3(btScalar(x), 0, btScalar(z)));
  };
  btRigidBody& torso = limb(0.2, 0.5, 0, 2);
  btRigidBody& head = limb(0.15, 0.05, 0, 2.65);
  const auto end = [](double x, double z) { return At(btVector3(btScalar(x), 0, btScalar(z))); };
  auto neck = std::make_unique<btConeTwistConstraint>(torso, head, end(0, 0.45), end(0, -0.2));
  neck->setLimit(btScalar(0.7), btScalar(0.7), btScalar(1.5));
  world->Join(std::move(neck));
  for (const double side : {-0.2, 0.2}) {
    btRigidBody& thigh = limb(0.1, 0.3, side, 1.35);
    btRigidBody& shin = limb(0.08, 0.3, side, 0.75);
    auto hip = std::make_unique<btConeTwistConstraint>(torso, thigh, end(side, -0.35), end(0, 0.3));
    hip->setLimit(btScalar(0.8), btScalar(0.8), 0);
    world->Join(std::move(hip));
    auto knee =
        std::make_unique<btHingeConstraint>(thigh, shin, btVector3(0, 0, btScalar(-0.3)),
                                            btVector3(0, 0, btScalar(0.3)), btVector3(0, 1, 0), btVector3(0, 1, 0));
    knee->setLimit(0, btScalar(1.5));
    world->Join(std::move(knee));
  }
  // To the world: Bullet's own fixed body is in no file.
  DropSome(*world);
  world->Join(std::make_unique<btPoint2PointConstraint>(head, btVector3(0, 0, btScalar(0.2))));
  return world;
}

std::unique_ptr<BulletWorld> MakeVehicle() {
  auto world = std::make_unique<BulletWorld>(false);
  world->AddGround();
  btRigidBody& chassis =
      world->Add(world->Make<btBoxShape>(btVector3(1, btScalar(0.5), btScalar(0.2))), 20, btVector3(0, 0, 1));
  chassis.setActivationState(DISABLE_DEACTIVATION);
  auto& wheel = world->Make<btCylinderShape>(btVector3(btScalar(0.4), btScalar(0.1), btScalar(0.4)));
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      const btVector3 axle(btScalar(0.8 * x), btScalar(0.7 * y), btScalar(-0.4));
      btRigidBody& body = world->Add(wheel, 2, btVector3(0, 0, 1) + axle);
      if (x < 0) {
        auto hinge = std::make_unique<btHingeConstraint>(chassis, body, axle, btVector3(0, 0, 0), btVector3(0, 1, 0),
                                                         btVector3(0, 1, 0));
        hinge->enableAngularMotor(true, 3, 10);
        world->Join(std::move(hinge));
      } else {
        auto spring =
            std::make_unique<btGeneric6DofSpringConstraint>(chassis, body, At(axle), At(btVector3(0, 0, 0)), true);
        spring->setLinearLowerLimit(btVector3(0, 0, btScalar(-0.1)));
        spring->setLinearUpperLimit(btVector3(0, 0, btScalar(0.1)));
        spring->setAngularLowerLimit(btVector3(0, 1, 0));
        spring->setAngularUpperLimit(btVector3(0, -1, 0));
        spring->enableSpring(2, true);
        spring->setStiffness(2, 500);
        world->Join(std::move(spring));
      }
    }
  }
  auto& box = world->Make<btBoxShape>(btVector3(btScalar(0.2), btScalar(0.2), btScalar(0.2)));
  btRigidBody& first = world->Add(box, 1, btVector3(4, 0, 2));
  btRigidBody& second = world->Add(box, 1, btVector3(5, 0, 2));
  btRigidBody& third = world->Add(box, 1, btVector3(6, 0, 2));
  world->Join(std::make_unique<btGeneric6DofConstraint>(first, At(btVector3(0, 0, 0)), true));
  auto spring = std::make_unique<btGeneric6DofSpring2Constraint>(first, second, At(btVector3(btScalar(0.5), 0, 0)),
                                                                 At(btVector3(btScalar(-0.5), 0, 0)));
  spring->enableSpring(2, true);
  spring->setStiffness(2, 50);
  world->Join(std::move(spring));
  world->Join(std::make_unique<btSliderConstraint>(second, third, At(btVector3(btScalar(0.5), 0, 0)),
                                                   At(btVector3(btScalar(-0.5), 0, 0)), true));
  world->Join(std::make_unique<btGearConstraint>(second, third, btVector3(1, 0, 0), btVector3(1, 0, 0), 2));
  return world;
}

std::unique_ptr<BulletWorld> MakeChain() {
  auto world = std::make_unique<BulletWorld>(true);
  world->AddGround();
  constexpr int kLinks = 4;
  const btVector3 inertia(btScalar(0.05), btScalar(0.05), btScalar(0.05));
  auto& box = world->Make<btBoxShape>(btVector3(btScalar(0.1), btScalar(0.1), btScalar(0.4)));
  for (const bool is_fixed : {true, false}) {
    auto chain = std::make_unique<btMultiBody>(kLinks, is_fixed ? btScalar(0) : btScalar(1), inertia, is_fixed, false);
    chain->setBasePos(btVector3(is_fixed ? btScalar(0) : btScalar(4), 0, is_fixed ? btScalar(4) : btScalar(5)));
    chain->setHasSelfCollision(false);
    const btVector3 to_pivot(0, 0, btScalar(-0.45)), to_centre(0, 0, btScalar(-0.45));
    chain->setupRevolute(0, 1, inertia, -1, btQuaternion(0, 0, 0, 1), btVector3(0, 1, 0), to_pivot, to_centre, true);
    chain->setupPrismatic(1, 1, inertia, 0, btQuaternion(0, 0, 0, 1), btVector3(1, 0, 0), to_pivot, to_centre, true);
    chain->setupFixed(2, 1, inertia, 1, btQuaternion(0, 0, 0, 1), to_pivot, to_centre);
    chain->setupSpherical(3, 1, inertia, 2, btQuaternion(0, 0, 0, 1), to_pivot, to_centre, true);
    chain->finalizeMultiDof();
    chain->setJointPos(0, btScalar(0.4));
    chain->setJointVel(0, btScalar(0.6));
    chain->setJointVel(1, btScalar(-0.1));
    if (!is_fixed) chain->setBaseVel(btVector3(btScalar(0.2), 0, 0));
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    chain->forwardKinematics(turns, places);
    btMultiBody& multibody = *chain;
    world->Add(std::move(chain));
    for (int link = -1; link < kLinks; ++link) world->AddLinkCollider(multibody, link, box);
    multibody.updateCollisionObjectWorldTransforms(turns, places);
  }
  world->Add(box, 1, btVector3(-3, 0, 1));
  return world;
}

}  // namespace

BulletWorld::BulletWorld(bool has_multibodies) {
  if (has_multibodies) {
    auto solver = std::make_unique<btMultiBodyConstraintSolver>();
    world_ = std::make_unique<btMultiBodyDynamicsWorld>(&dispatcher_, &broadphase_, solver.get(), &configuration_);
    solver_ = std::move(solver);
  } else {
    solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, solver_.get(), &configuration_);
  }
  world_->setGravity(btVector3(0, 0, btScalar(-9.81)));
  world_->getSolverInfo().m_timeStep = btScalar(1) / 240;
  world_->getSolverInfo().m_numIterations = 20;
}

BulletWorld::~BulletWorld() {
  for (const auto& constraint : constraints_) world_->removeConstraint(constraint.get());
  for (const auto& multibody : multibodies_) multibody_world().removeMultiBody(multibody.get());
  for (const auto& object : objects_) {
    if (btRigidBody* body = btRigidBody::upcast(object.get())) {
      world_->removeRigidBody(body);
    } else {
      world_->removeCollisionObject(object.get());
    }
  }
}

btRigidBody& BulletWorld::Add(btCollisionShape& shape, btScalar mass, const btTransform& pose) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0) shape.calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
  info.m_startWorldTransform = pose;
  auto body = std::make_unique<btRigidBody>(info);
  btRigidBody& added = *body;
  world_->addRigidBody(body.get());
  objects_.push_back(std::move(body));
  return added;
}

btRigidBody& BulletWorld::Add(btCollisionShape& shape, btScalar mass, const btVector3& position) {
  return Add(shape, mass, At(position));
}

btRigidBody& BulletWorld::AddGround() { return Add(Make<btBoxShape>(btVector3(10, 10, 1)), 0, btVector3(0, 0, -1)); }

void BulletWorld::Join(std::unique_ptr<btTypedConstraint> constraint) {
  world_->addConstraint(constraint.get(), true);
  constraints_.push_back(std::move(constraint));
}

void BulletWorld::Add(std::unique_ptr<btCollisionObject> object) {
  world_->addCollisionObject(object.get(), btBroadphaseProxy::StaticFilter,
                             btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
  objects_.push_back(std::move(object));
}

void BulletWorld::Add(std::unique_ptr<btMultiBody> multibody) {
  multibody_world().addMultiBody(multibody.get());
  multibodies_.push_back(std::move(multibody));
}

void BulletWorld::AddLinkCollider(btMultiBody& multibody, int link, btCollisionShape& shape) {
  auto collider = std::make_unique<btMultiBodyLinkCollider>(&multibody, link);
  collider->setCollisionShape(&shape);
  const bool is_static = link < 0 && multibody.hasFixedBase();
  const int group = is_static ? btBroadphaseProxy::StaticFilter : btBroadphaseProxy::DefaultFilter;
  world_->addCollisionObject(
      collider.get(), group,
      is_static ? btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter : int(btBroadphaseProxy::AllFilter));
  if (link < 0) {
    multibody.setBaseCollider(collider.get());
  } else {
    multibody.getLink(link).m_collider = collider.get();
  }
  objects_.push_back(std::move(collider));
}

std::vector<std::byte> BulletWorld::Serialize(int flags) {
  btDefaultSerializer serializer;
  serializer.setSerializationFlags(flags);
  world_->serialize(&serializer);
  const auto* bytes = reinterpret_cast<const std::byte*>(serializer.getBufferPointer());
  return {bytes, bytes + serializer.getCurrentBufferSize()};
}

std::vector<const btRigidBody*> BulletWorld::Bodies() const {
  std::vector<const btRigidBody*> bodies;
  for (int i = 0; i < world_->getNumCollisionObjects(); ++i) {
    const btRigidBody* body = btRigidBody::upcast(world_->getCollisionObjectArray()[i]);
    if (body != nullptr) bodies.push_back(body);
  }
  return bodies;
}

const std::vector<WorldCase>& AllWorldCases() {
  static const std::vector<WorldCase> cases = {
      {"boxes", MakeBoxes},         {"hulls", MakeHulls},     {"primitives", MakePrimitives},
      {"compounds", MakeCompounds}, {"terrain", MakeTerrain}, {"scaled_terrain", MakeScaledTerrain},
      {"plane", MakePlane},         {"ragdoll", MakeRagdoll}, {"vehicle", MakeVehicle},
      {"chain", MakeChain},
  };
  return cases;
}

std::unique_ptr<BulletWorld> MakeWorld(const std::string& name) {
  for (const WorldCase& world_case : AllWorldCases()) {
    if (world_case.name == name) return world_case.make();
  }
  throw std::invalid_argument(name);
}

std::unique_ptr<BulletWorld> MakeFallingSphere() {
  auto world = std::make_unique<BulletWorld>(false);
  world->Add(world->Make<btSphereShape>(btScalar(0.5)), 1, btVector3(0, 0, 1));
  return world;
}

}  // namespace dgd_test
