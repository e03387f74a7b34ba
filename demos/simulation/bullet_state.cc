#include "simulation/bullet_state.h"

#include <algorithm>

#include "simulation/bullet_math.h"

namespace dgd_demos {

using Eigen::Vector3d;

CollisionReport ReportStep(TimingDispatcher& dispatcher, const btOverlappingPairCache& pairs, std::uint64_t fallbacks) {
  CollisionReport report{};
  report.narrowphase_us = dispatcher.last_duration().count();
  report.pairs = pairs.getNumOverlappingPairs();
  report.queries = dispatcher.last_queries();
  report.fallbacks = fallbacks;
  for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
    report.contacts += manifold.getNumContacts();
    for (int c = 0; c < manifold.getNumContacts(); ++c) {
      const double depth = -manifold.getContactPoint(c).getDistance();
      report.deepest_penetration = std::max(report.deepest_penetration, depth);
    }
  }
  return report;
}

std::vector<BodyPair> IndexPairs(const btOverlappingPairCache& pairs) {
  const btBroadphasePairArray& array = const_cast<btOverlappingPairCache&>(pairs).getOverlappingPairArray();
  std::vector<BodyPair> indices;
  for (int i = 0; i < array.size(); ++i) {
    const auto index_of = [](const btBroadphaseProxy* proxy) {
      return static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
    };
    const auto [first, second] = std::minmax({index_of(array[i].m_pProxy0), index_of(array[i].m_pProxy1)});
    indices.push_back({first, second});
  }
  return indices;
}

double KineticEnergy(const btRigidBody& body) {
  const Eigen::Matrix3d rotation = FromBullet(body.getWorldTransform()).rotation;
  const Vector3d velocity = FromBullet(body.getLinearVelocity());
  const Vector3d spin = rotation.transpose() * FromBullet(body.getAngularVelocity());
  const Vector3d inertia = FromBullet(body.getLocalInertia());
  const double mass = body.getMass();
  return (mass * velocity.squaredNorm() + inertia.dot(spin.cwiseAbs2())) / 2;
}

}  // namespace dgd_demos
