// Contacts are finite numbers, in the world and in both bodies' frames: when that is so, and a filter for the contacts
// of Bullet's own algorithm.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <cmath>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether Bullet can compute with a place. It multiplies two lengths: in float, the product of 1e19 m would be
/// infinite. False for NaN.
inline bool IsRepresentable(const btVector3& point) { return point.absolute().dot({1, 1, 1}) <= btScalar(1e15); }

/// Whether Bullet can compute with a contact.
inline bool IsRepresentable(const btVector3& point, btScalar separation) {
  return IsRepresentable(point) && IsRepresentable({separation, 0, 0});
}

/// Whether it can compute in the bodies' frames, in which it stores contacts.
inline bool AreBodiesRepresentable(const btManifoldResult& output) {
  const auto is_near = [](const btCollisionObjectWrapper& body) {
    return IsRepresentable(body.getCollisionObject()->getWorldTransform().getOrigin());
  };
  return is_near(*output.getBody0Wrap()) && is_near(*output.getBody1Wrap());
}

/// Passes on to another result all contacts that Bullet can compute with.
class FiniteResult final : public btManifoldResult {
 public:
  explicit FiniteResult(btManifoldResult& output)
      : btManifoldResult(output.getBody0Wrap(), output.getBody1Wrap()), output_(output) {
    setPersistentManifold(output.getPersistentManifold());
    m_closestPointDistanceThreshold = output.m_closestPointDistanceThreshold;
  }

  void setShapeIdentifiersA(int part, int index) override { output_.setShapeIdentifiersA(part, index); }
  void setShapeIdentifiersB(int part, int index) override { output_.setShapeIdentifiersB(part, index); }
  void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar separation) override {
    const bool has_normal = std::abs(normal_on_b.length2() - 1) <= kTolerance;
    if (has_normal && IsRepresentable(point, separation) && AreBodiesRepresentable(*this)) {
      output_.addContactPoint(normal_on_b, point, separation);
    }
  }

 private:
  /// Tolerance of a unit normal's square: float's roundoff is far below, and a normal that is none is zero or NaN.
  static constexpr btScalar kTolerance = btScalar(0.01);

  btManifoldResult& output_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
