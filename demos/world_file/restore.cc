#include "world_file/restore.h"

#include <array>

namespace dgd_demos {
namespace {

template <class Data>
btVector3 VectorOf(const Data& data) {
  btVector3 vector;
  vector.deSerialize(data);
  return vector;
}

// The remaining flags follow from the mass (static), or request callbacks that are not set here.
constexpr int kRestoredFlags = btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_NO_CONTACT_RESPONSE |
                               btCollisionObject::CF_CHARACTER_OBJECT |
                               btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING |
                               btCollisionObject::CF_HAS_FRICTION_ANCHOR;

// The file has the sizes as they are after scaling, without the margin.
void RestoreSizes(const btCollisionShapeData& data, btCollisionShape& shape) {
  const int type = shape.getShapeType();
  if (type == BOX_SHAPE_PROXYTYPE || type == CYLINDER_SHAPE_PROXYTYPE) {
    const auto& sizes = reinterpret_cast<const btConvexInternalShapeData&>(data).m_implicitShapeDimensions;
    btVector3 dimensions;
    dimensions.deSerializeFloat(sizes);
    static_cast<btConvexInternalShape&>(shape).setImplicitShapeDimensions(dimensions);
  } else if (type == COMPOUND_SHAPE_PROXYTYPE) {
    const auto& children = reinterpret_cast<const btCompoundShapeData&>(data);
    auto& compound = static_cast<btCompoundShape&>(shape);
    for (int i = 0; i < compound.getNumChildShapes(); ++i) {
      RestoreSizes(*children.m_childShapePtr[i].m_childShape, *compound.getChildShape(i));
    }
    compound.recalculateLocalAabb();
  }
}

}  // namespace

void RestoreObject(const ObjectData& data, btCollisionObject& object) {
  RestoreSizes(*static_cast<const btCollisionShapeData*>(data.m_collisionShape), *object.getCollisionShape());
  object.setCollisionFlags(object.getCollisionFlags() | (data.m_collisionFlags & kRestoredFlags));
  if ((data.m_collisionFlags & btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING) != 0) {
    object.setContactStiffnessAndDamping(btScalar(data.m_contactStiffness), btScalar(data.m_contactDamping));
  }
  object.setFriction(btScalar(data.m_friction));
  object.setRollingFriction(btScalar(data.m_rollingFriction));
  object.setRestitution(btScalar(data.m_restitution));
  if (data.m_hasAnisotropicFriction != 0) {
    object.setAnisotropicFriction(VectorOf(data.m_anisotropicFriction), data.m_hasAnisotropicFriction);
  }
  object.setContactProcessingThreshold(btScalar(data.m_contactProcessingThreshold));
  object.setCcdSweptSphereRadius(btScalar(data.m_ccdSweptSphereRadius));
  object.setCcdMotionThreshold(btScalar(data.m_ccdMotionThreshold));
  object.forceActivationState(data.m_activationState1);
  object.setDeactivationTime(btScalar(data.m_deactivationTime));
  object.setInterpolationWorldTransform(object.getWorldTransform());
}

void RestoreFilter(const ObjectData& data, btCollisionObject& object, btCollisionWorld& world) {
  btBroadphaseProxy& proxy = *object.getBroadphaseHandle();
  proxy.m_collisionFilterGroup = data.m_collisionFilterGroup;
  proxy.m_collisionFilterMask = data.m_collisionFilterMask;
  world.refreshBroadphaseProxy(&object);
}

void RestoreBody(const BodyData& data, btRigidBody& body) {
  body.setLinearVelocity(VectorOf(data.m_linearVelocity));
  body.setAngularVelocity(VectorOf(data.m_angularVelocity));
  body.setInterpolationLinearVelocity(body.getLinearVelocity());
  body.setInterpolationAngularVelocity(body.getAngularVelocity());
  body.setDamping(btScalar(data.m_linearDamping), btScalar(data.m_angularDamping));
  body.setSleepingThresholds(btScalar(data.m_linearSleepingThreshold), btScalar(data.m_angularSleepingThreshold));
  if (body.getInvMass() == 0) return;
  // The importer estimates the inertia by the shape, regardless of the body's own.
  body.setInvInertiaDiagLocal(VectorOf(data.m_invInertiaLocal));
  body.updateInertiaTensor();
  body.setGravity(VectorOf(data.m_gravity_acceleration));
  body.clearForces();
  // What the body adds, it multiplies by its linear factor; what was written is a sum of such.
  const btVector3 factor = body.getLinearFactor();
  body.setLinearFactor(btVector3(1, 1, 1));
  body.applyCentralForce(VectorOf(data.m_totalForce));
  body.setLinearFactor(factor);
  const btVector3 turn = body.getAngularFactor();
  body.setAngularFactor(btVector3(1, 1, 1));
  body.applyTorque(VectorOf(data.m_totalTorque));
  body.setAngularFactor(turn);
}

void RestoreMultibody(const MultibodyData& data, btMultiBody& multibody) {
  multibody.setBaseVel(VectorOf(data.m_baseLinearVelocity));
  multibody.setBaseOmega(VectorOf(data.m_baseAngularVelocity));
  for (int i = 0; i < multibody.getNumLinks(); ++i) {
    const auto& from = data.m_links[i];
    btMultibodyLink& link = multibody.getLink(i);
    link.m_jointDamping = btScalar(from.m_jointDamping);
    link.m_jointFriction = btScalar(from.m_jointFriction);
    link.m_jointLowerLimit = btScalar(from.m_jointLowerLimit);
    link.m_jointUpperLimit = btScalar(from.m_jointUpperLimit);
    link.m_jointMaxForce = btScalar(from.m_jointMaxForce);
    link.m_jointMaxVelocity = btScalar(from.m_jointMaxVelocity);
    // Arrays have the length that Bullet reads: a fixed joint has no freedom, a spherical one four numbers for three.
    std::array<btScalar, 7> position{};
    std::array<btScalar, 6> velocity{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(link.m_posVarCount); ++k) {
      position[k] = btScalar(from.m_jointPos[k]);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(link.m_dofCount); ++k) {
      velocity[k] = btScalar(from.m_jointVel[k]);
    }
    multibody.setJointPosMultiDof(i, position.data());
    multibody.setJointVelMultiDof(i, velocity.data());
  }
}

}  // namespace dgd_demos
