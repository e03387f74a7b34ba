#include "dispatch/separated_pairs.h"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <limits>

#include "body_velocity.h"
#include "dgd/assert.h"
#include "dispatch/content_hash.h"
#include "pair/pair_state.h"
#include "pair_motion.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// Half the diagonal of a box about the origin that contains the core, a shape without its margin; metres.
btScalar CoreRadius(const btConvexShape& shape) {
  btVector3 corner(0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    btVector3 direction(0, 0, 0);
    for (const btScalar sign : {btScalar(-1), btScalar(1)}) {
      direction[axis] = sign;
      corner[axis] = btMax(corner[axis], btFabs(shape.localGetSupportVertexWithoutMarginNonVirtual(direction)[axis]));
    }
  }
  // The axis is tried on the whole of a box.
  const btScalar margin = shape.getShapeType() == BOX_SHAPE_PROXYTYPE ? btFabs(shape.getMargin()) : 0;
  return (corner + btVector3(margin, margin, margin)).length();
}

constexpr std::uint32_t kNoBody = std::numeric_limits<std::uint32_t>::max();

/// Roundoff of the bound and of the separation that the pair's algorithm finds, with its allowance (32 epsilon of the
/// bodies' radii), relative to the lengths that go into them: some ten roundings each.
constexpr btScalar kRoundoff = 256 * std::numeric_limits<btScalar>::epsilon();

const btCollisionObject& ObjectOf(const btBroadphaseProxy& proxy) {
  return *static_cast<const btCollisionObject*>(proxy.m_clientObject);
}

/// The object's place in its world, or kNoBody.
std::uint32_t IndexOf(const btBroadphaseProxy& proxy) {
  const int index = ObjectOf(proxy).getWorldArrayIndex();
  return index < 0 ? kNoBody : static_cast<std::uint32_t>(index);
}

/// Whether a matrix leaves lengths as they are: only then A's support value is constant along the axis that turns with
/// it. Apps may set other matrices.
bool IsRotation(const btMatrix3x3& basis) {
  constexpr btScalar kTolerance = 32 * std::numeric_limits<btScalar>::epsilon();
  for (int i = 0; i < 3; ++i) {
    if (!(btFabs(basis[i].length2() - 1) <= kTolerance)) return false;
    if (!(btFabs(basis[i].dot(basis[(i + 1) % 3])) <= kTolerance)) return false;
  }
  return true;
}

btScalar L1Norm(const btVector3& vector) { return btFabs(vector.x()) + btFabs(vector.y()) + btFabs(vector.z()); }

}  // namespace

void SeparatedPairs::BeginDispatch(const std::vector<btBroadphasePair*>& pairs, btScalar time_step) {
  ++dispatch_;
  time_step_ = btMax(time_step, btScalar(0));
  entries_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const btBroadphasePair& pair = *pairs[i];
    Entry& entry = entries_[i];
    if (entry.algorithm != nullptr && IsOf(entry, pair)) continue;
    entry.algorithm = nullptr;
    entry.is_apart = false;
    entry.body_0 = IndexOf(*pair.m_pProxy0);
    entry.body_1 = IndexOf(*pair.m_pProxy1);
    if (!ReadBody(entry.body_0, *pair.m_pProxy0)) entry.body_0 = kNoBody;
    if (!ReadBody(entry.body_1, *pair.m_pProxy1)) entry.body_1 = kNoBody;
  }
}

bool SeparatedPairs::IsOf(const Entry& entry, const btBroadphasePair& pair) {
  return entry.algorithm == pair.m_algorithm && ReadBody(entry.body_0, *pair.m_pProxy0) &&
         ReadBody(entry.body_1, *pair.m_pProxy1);
}

bool SeparatedPairs::ReadBody(std::uint32_t index, const btBroadphaseProxy& proxy) {
  if (index == kNoBody) return false;
  if (index < bodies_.size() && bodies_[index].dispatch == dispatch_) return bodies_[index].proxy == &proxy;
  if (IndexOf(proxy) != index) return false;
  if (index >= bodies_.size()) bodies_.resize(std::size_t{index} + 1);
  Body& body = bodies_[index];
  body.dispatch = dispatch_;
  body.proxy = &proxy;
  Read(ObjectOf(proxy), body);
  return true;
}

void SeparatedPairs::Read(const btCollisionObject& object, Body& body) {
  const btTransform& pose = object.getWorldTransform();
  body.basis = pose.getBasis();
  body.origin = pose.getOrigin();
  body.order = OrderOf(pose);
  body.path.setZero();
  body.turn = 0;
  const double radius = BoundingRadius(object, pose.getOrigin());
  const bool is_static = object.isStaticObject();
  if (const btRigidBody* rigid = btRigidBody::upcast(&object); rigid != nullptr && !is_static) {
    const btVector3 gain = time_step_ * (rigid->getInvMass() * rigid->getTotalForce());
    body.path = time_step_ * (rigid->getLinearVelocity() + gain);
    body.turn = time_step_ * L1Norm(rigid->getAngularVelocity()) * btScalar(radius);
  }
  // Bullet wakes the neighbours of a kinematic body, and a link moves by its joints.
  const bool is_decided = !object.isKinematicObject() && AsLink(object) == nullptr && IsRotation(body.basis);
  const btCollisionShape& shape = *object.getCollisionShape();
  const std::uint64_t hash = is_decided ? ContentHash(shape) : 0;
  if (hash != body.shape) body.core_radius = hash == 0 ? 0 : CoreRadius(static_cast<const btConvexShape&>(shape));
  body.shape = hash;
  body.extent = btScalar(radius) + body.core_radius + L1Norm(body.path) + body.turn;
}

bool SeparatedPairs::IsApart(std::size_t place) const {
  const Entry& entry = entries_[place];
  if (!entry.is_apart) return false;
  const Body &body_0 = bodies_[entry.body_0], &body_1 = bodies_[entry.body_1];
  if (body_0.shape != entry.shape_0 || body_1.shape != entry.shape_1) return false;
  const Body &a = entry.is_swapped ? body_1 : body_0, &b = entry.is_swapped ? body_0 : body_1;
  if (entry.is_ordered_by_place && (body_1.order < body_0.order) != entry.is_swapped) return false;
  const btVector3 normal = a.basis * entry.normal_in_a;
  const btVector3 between = b.origin - a.origin;
  const btScalar turned = (normal * b.basis - entry.normal_in_b).length();
  const btScalar roundoff = kRoundoff * (a.extent + b.extent + L1Norm(between));
  const btScalar separation = normal.dot(between) - entry.support - b.core_radius * turned - roundoff;
  // False for NaN.
  return separation > entry.contact_distance && separation > normal.dot(a.path - b.path) + a.turn + b.turn;
}

void SeparatedPairs::Update(std::size_t place, const btBroadphasePair& pair, const SeparationReport& report) {
  if (report.algorithm == nullptr) return;  // The bodies sleep, or do not collide: the pair is as it was.
  Entry& entry = entries_[place];
  entry.is_apart = false;
  entry.algorithm = nullptr;
  // Other algorithms may have called one of two convex shapes for their parts.
  if (report.algorithm != pair.m_algorithm || entry.body_0 == kNoBody || entry.body_1 == kNoBody) return;
  entry.algorithm = pair.m_algorithm;
  if (!report.is_apart) return;
  const Body &body_0 = bodies_[entry.body_0], &body_1 = bodies_[entry.body_1];
  if (body_0.shape == 0 || body_1.shape == 0) return;
  const Body &a = report.is_swapped ? body_1 : body_0, &b = report.is_swapped ? body_0 : body_1;
  entry.normal_in_a = report.normal_in_a;
  entry.normal_in_b = report.normal_w * b.basis;
  entry.support =
      btScalar(FromBullet(report.normal_w).dot(FromBullet(b.origin) - FromBullet(a.origin)) - report.separation);
  entry.contact_distance = btScalar(report.contact_distance);
  entry.shape_0 = body_0.shape;
  entry.shape_1 = body_1.shape;
  entry.is_swapped = report.is_swapped;
  entry.is_ordered_by_place = ObjectOf(*pair.m_pProxy0).getCollisionShape()->getShapeType() ==
                              ObjectOf(*pair.m_pProxy1).getCollisionShape()->getShapeType();
  entry.is_apart = true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
