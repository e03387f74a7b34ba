#include "world_file/imported_world.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletFileLoader/btBulletFile.h>
#include <BulletWorldImporter/btBulletWorldImporter.h>
#include <BulletWorldImporter/btMultiBodyWorldImporter.h>
#include <LinearMath/btSerializer.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "scene/scene_error.h"
#include "simulation/bullet_math.h"
#include "simulation/bullet_state.h"
#include "simulation/rounded_core.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

constexpr Precision kOwnPrecision = kInDouble ? Precision::kDouble : Precision::kFloat;
static_assert(sizeof(void*) == 8, "files with 64-bit pointers are read, which the structures must have as well");

// A body is lost that is farther away from all starts than this and ten times their extent. m
constexpr double kRoom = 100;
constexpr double kRoomExtents = 10;
// Bullet's planes have bounds of 1e18 m.
constexpr double kGreatestRadius = 1e12;

const Dna& OwnDna() {
  static const Dna dna({reinterpret_cast<const std::byte*>(btDefaultSerializer::getMemoryDna()),
                        static_cast<std::size_t>(btDefaultSerializer::getMemoryDnaSizeInBytes())},
                       "Bullet's own DNA");
  return dna;
}

// The importer's view of a file that it has read: here, of what was checked. It reads nothing but the header.
class CheckedFile : public bParse::btBulletFile {
 public:
  CheckedFile(std::string& header, const CheckedWorld& file)
      : btBulletFile(header.data(), static_cast<int>(header.size())) {
    Add(file.shapes, m_collisionShapes);
    Add(file.worlds, m_dynamicsWorldInfo);
    Add(file.bodies, m_rigidBodies);
    Add(file.objects, m_collisionObjects);
    Add(file.constraints, m_constraints);
    Add(file.multibodies, m_multiBodies);  // Without colliders; see AddMultibodies().
  }

  static std::string HeaderOf(const CheckedWorld& file) {
    return std::string("BULLET") + (file.precision == Precision::kDouble ? "d-v" : "f-v") +
           std::to_string(file.version);
  }

 private:
  static void Add(const std::vector<void*>& addresses, btAlignedObjectArray<bParse::bStructHandle*>& handles) {
    for (void* address : addresses) handles.push_back(static_cast<bParse::bStructHandle*>(address));
  }
};

// Bullet's importer, with access to its map from structures to shapes.
class MultibodyImporter : public btMultiBodyWorldImporter {
 public:
  using btMultiBodyWorldImporter::btMultiBodyWorldImporter;
  btCollisionShape* ShapeOf(const void* data) { return *m_shapeMap.find(data); }
};

std::string NameOr(const char* name, const std::string& other) {
  return name == nullptr || *name == '\0' ? other : std::string(name);
}

double RadiusOf(const btCollisionShape& shape) {
  btVector3 centre;
  btScalar radius = 0;
  shape.getBoundingSphere(centre, radius);
  const double from_origin = FromBullet(centre).norm() + double(radius);
  return from_origin < kGreatestRadius ? from_origin : std::numeric_limits<double>::infinity();
}

/// Vectors of base and links, each in its own frame; the base is the first.
struct LinkVelocities {
  explicit LinkVelocities(const btMultiBody& multibody)
      : angular(static_cast<std::size_t>(multibody.getNumLinks()) + 1), linear(angular.size()) {
    multibody.compTreeLinkVelocities(angular.data(), linear.data());
  }
  std::vector<btVector3> angular, linear;
};

Energy EnergyOf(const btMultiBody& multibody, const Vector3d& gravity) {
  const LinkVelocities velocities(multibody);
  Energy energy{0, 0};
  const auto add = [&](double mass, const btVector3& inertia, const btVector3& centre, std::size_t index) {
    const Vector3d spin = FromBullet(velocities.angular[index]);
    energy.kinetic +=
        (mass * FromBullet(velocities.linear[index]).squaredNorm() + FromBullet(inertia).dot(spin.cwiseAbs2())) / 2;
    energy.potential -= mass * gravity.dot(FromBullet(centre));
  };
  if (!multibody.hasFixedBase()) {
    add(double(multibody.getBaseMass()), multibody.getBaseInertia(), multibody.getBasePos(), 0);
  }
  for (int i = 0; i < multibody.getNumLinks(); ++i) {
    const btMultibodyLink& link = multibody.getLink(i);
    add(double(link.m_mass), link.m_inertiaLocal, link.m_cachedWorldTransform.getOrigin(),
        static_cast<std::size_t>(i) + 1);
  }
  return energy;
}

}  // namespace

CheckedWorld LoadWorldFile(const std::filesystem::path& file) {
  return CheckWorld(ReadBulletFile(file), kOwnPrecision, OwnDna());
}

CheckedWorld LoadWorldBytes(const std::string& name, std::vector<std::byte> bytes) {
  return CheckWorld(ParseBulletFile(name, std::move(bytes)), kOwnPrecision, OwnDna());
}

ImportedWorld::ImportedWorld(const CheckedWorld& file, const NarrowphaseChoice& narrowphase,
                             std::optional<double> time_step)
    : configuration_(MakeCollisionConfiguration(narrowphase)),
      dispatcher_(configuration_.get()),
      remarks_(file.remarks) {
  Import(file);
  AddBodies(file);
  FindRoom();
  AddRemarks();
  time_step_ = time_step.value_or(double(world_->getSolverInfo().m_timeStep));
}

ImportedWorld::~ImportedWorld() {
  auto* multibody_world = dynamic_cast<btMultiBodyDynamicsWorld*>(world_.get());
  for (const auto& multibody : multibodies_) multibody_world->removeMultiBody(multibody.get());
  for (const auto& collider : colliders_) world_->removeCollisionObject(collider.get());
  importer_->deleteAllData();
}

void ImportedWorld::Import(const CheckedWorld& file) {
  std::string header = CheckedFile::HeaderOf(file);
  CheckedFile bullet_file(header, file);
  if (file.multibodies.empty()) {
    solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
    world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, solver_.get(), configuration_.get());
    importer_ = std::make_unique<btBulletWorldImporter>(world_.get());
  } else {
    auto solver = std::make_unique<btMultiBodyConstraintSolver>();
    auto world =
        std::make_unique<btMultiBodyDynamicsWorld>(&dispatcher_, &broadphase_, solver.get(), configuration_.get());
    importer_ = std::make_unique<MultibodyImporter>(world.get());
    solver_ = std::move(solver);
    world_ = std::move(world);
  }
  importer_->convertAllObjects(&bullet_file);
}

// The importer makes bodies, objects and multibodies in the file's order.
void ImportedWorld::AddBodies(const CheckedWorld& file) {
  const std::size_t count = file.bodies.size() + file.objects.size();
  if (static_cast<std::size_t>(importer_->getNumRigidBodies()) != count) {
    throw SceneError(file.name + ": Bullet's importer made " + std::to_string(importer_->getNumRigidBodies()) + " of " +
                     std::to_string(count) + " bodies");
  }
  for (std::size_t i = 0; i < count; ++i) {
    btRigidBody& body = *btRigidBody::upcast(importer_->getRigidBodyByIndex(static_cast<int>(i)));
    const bool is_body = i < file.bodies.size();
    const ObjectData& data = is_body ? static_cast<const BodyData*>(file.bodies[i])->m_collisionObjectData
                                     : *static_cast<const ObjectData*>(file.objects[i - file.bodies.size()]);
    RestoreObject(data, body);
    if (is_body) RestoreBody(*static_cast<const BodyData*>(file.bodies[i]), body);
    RestoreFilter(data, body, *world_);
    AddBody(body, NameOr(data.m_name, "body " + std::to_string(i)), !body.isStaticOrKinematicObject());
  }

  if (!file.multibodies.empty()) AddMultibodies(file);
}

void ImportedWorld::AddMultibodies(const CheckedWorld& file) {
  auto& world = static_cast<btMultiBodyDynamicsWorld&>(*world_);
  std::map<const void*, btMultiBody*> multibodies;
  for (std::size_t i = 0; i < file.multibodies.size(); ++i) {
    btMultiBody* multibody = world.getMultiBody(static_cast<int>(i));
    multibodies_.emplace_back(multibody);
    multibodies[file.multibodies[i]] = multibody;
    RestoreMultibody(*static_cast<const MultibodyData*>(file.multibodies[i]), *multibody);
  }
  // The importer makes them in double precision only.
  for (const void* address : file.colliders) {
    const auto& data = *static_cast<const ColliderData*>(address);
    AddCollider(data, *multibodies.at(data.m_multiBody));
  }
  for (const auto& multibody : multibodies_) {
    btAlignedObjectArray<btQuaternion> turns;
    btAlignedObjectArray<btVector3> places;
    multibody->forwardKinematics(turns, places);
    multibody->updateCollisionObjectWorldTransforms(turns, places);
  }
  for (std::size_t i = 0; i < colliders_.size(); ++i) {
    const auto& data = *static_cast<const ColliderData*>(file.colliders[i]);
    btMultiBodyLinkCollider& collider = *colliders_[i];
    RestoreObject(data.m_colObjData, collider);
    const int group = data.m_colObjData.m_collisionFilterGroup, mask = data.m_colObjData.m_collisionFilterMask;
    world_->addCollisionObject(&collider, group, mask);
    AddBody(collider, NameOr(data.m_colObjData.m_name, "link " + std::to_string(data.m_link)),
            data.m_link >= 0 || !collider.m_multiBody->hasFixedBase());
  }
}

void ImportedWorld::AddCollider(const ColliderData& data, btMultiBody& multibody) {
  auto collider = std::make_unique<btMultiBodyLinkCollider>(&multibody, data.m_link);
  auto& importer = static_cast<MultibodyImporter&>(*importer_);
  collider->setCollisionShape(importer.ShapeOf(data.m_colObjData.m_collisionShape));
  if (data.m_link >= 0) {
    multibody.getLink(data.m_link).m_collider = collider.get();
  } else {
    multibody.setBaseCollider(collider.get());
    if (multibody.hasFixedBase()) {
      collider->setCollisionFlags(collider->getCollisionFlags() | btCollisionObject::CF_STATIC_OBJECT);
    }
  }
  colliders_.push_back(std::move(collider));
}

void ImportedWorld::AddBody(btCollisionObject& object, std::string name, bool moves) {
  object.setUserIndex(static_cast<int>(objects_.size()));
  objects_.push_back(&object);
  const btCollisionShape& shape = *object.getCollisionShape();
  bodies_.push_back({std::move(name), moves, FromBullet(object.getWorldTransform().getOrigin()), RadiusOf(shape)});
  oracle_bodies_.push_back(OracleBodyOf(shape));
}

void ImportedWorld::FindRoom() {
  for (const SimulatedBody& body : bodies_) room_.extend(body.start);
  if (room_.isEmpty()) return;
  const double around = kRoom + kRoomExtents * room_.sizes().maxCoeff();
  room_ = {room_.min().array() - around, room_.max().array() + around};
}

void ImportedWorld::AddRemarks() {
  std::map<std::string, int> unjudged;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!oracle_bodies_[i].IsJudged()) ++unjudged[objects_[i]->getCollisionShape()->getName()];
  }
  for (const auto& [shape, count] : unjudged) {
    remarks_.push_back("Penetration with " + std::to_string(count) + " x " + shape +
                       " is not judged by the oracle; the pairs are counted.");
  }
}

CollisionReport ImportedWorld::Step() {
  const std::uint64_t fallbacks_before = Fallbacks(*configuration_);
  // No substeps: exactly one step of this length.
  world_->stepSimulation(ToBullet(time_step_), 0);
  return ReportStep(dispatcher_, *broadphase_.m_paircache, Fallbacks(*configuration_) - fallbacks_before);
}

std::vector<Pose> ImportedWorld::Poses() const {
  std::vector<Pose> poses;
  for (const btCollisionObject* object : objects_) poses.push_back(FromBullet(object->getWorldTransform()));
  return poses;
}

std::vector<BodyPair> ImportedWorld::OverlappingPairs() const {
  std::vector<BodyPair> pairs = IndexPairs(*broadphase_.m_paircache);
  std::erase_if(pairs, [&](const BodyPair& pair) {
    const btCollisionObject &first = *objects_[pair.first], &second = *objects_[pair.second];
    return !first.hasContactResponse() || !second.hasContactResponse() || !first.checkCollideWith(&second) ||
           !second.checkCollideWith(&first);
  });
  return pairs;
}

std::vector<Motion> ImportedWorld::Motions() const {
  std::map<const btMultiBody*, LinkVelocities> velocities;
  for (const auto& multibody : multibodies_) velocities.emplace(multibody.get(), LinkVelocities(*multibody));
  std::vector<Motion> motions;
  for (const btCollisionObject* object : objects_) {
    if (const btRigidBody* body = btRigidBody::upcast(object)) {
      motions.push_back({FromBullet(body->getLinearVelocity()), FromBullet(body->getAngularVelocity())});
      continue;
    }
    const auto& collider = static_cast<const btMultiBodyLinkCollider&>(*object);
    const LinkVelocities& of_links = velocities.at(collider.m_multiBody);
    const auto link = static_cast<std::size_t>(collider.m_link + 1);
    const btMatrix3x3& from_link = collider.getWorldTransform().getBasis();
    motions.push_back({FromBullet(from_link * of_links.linear[link]), FromBullet(from_link * of_links.angular[link])});
  }
  return motions;
}

Energy ImportedWorld::TotalEnergy() const {
  const Vector3d gravity = FromBullet(world_->getGravity());
  Energy energy{0, 0};
  for (const btCollisionObject* object : objects_) {
    const btRigidBody* body = btRigidBody::upcast(object);
    if (body == nullptr || body->isStaticOrKinematicObject()) continue;
    energy.kinetic += KineticEnergy(*body);
    const Vector3d own_gravity = FromBullet(body->getGravity());  // It need not be the world's.
    energy.potential -= double(body->getMass()) * own_gravity.dot(FromBullet(body->getWorldTransform().getOrigin()));
  }
  for (const auto& multibody : multibodies_) {
    const Energy own = EnergyOf(*multibody, gravity);
    energy.kinetic += own.kinetic;
    energy.potential += own.potential;
  }
  return energy;
}

}  // namespace dgd_demos
