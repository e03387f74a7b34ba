// Contacts are numbers, in the world and in both bodies' frames: what that takes, and Bullet's own algorithm held to it
// where it answers in this one's place.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <cmath>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// What Bullet makes of a contact are products of two lengths: in float, of 1e19 m they would be infinite. False for
/// NaN.
inline bool IsSomewhere(const btVector3& point) { return point.absolute().dot({1, 1, 1}) <= btScalar(1e15); }

/// Whether a contact is.
inline bool IsSomewhere(const btVector3& point, btScalar separation) {
  return IsSomewhere(point) && IsSomewhere({separation, 0, 0});
}

/// Whether the bodies are, in whose frames Bullet keeps contacts.
inline bool AreBodiesSomewhere(const btManifoldResult& output) {
  const auto is_near = [](const btCollisionObjectWrapper& body) {
    return IsSomewhere(body.getCollisionObject()->getWorldTransform().getOrigin());
  };
  return is_near(*output.getBody0Wrap()) && is_near(*output.getBody1Wrap());
}

/// Hands on to another result all contacts but those that are nowhere.
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
    const bool has_normal = std::abs(normal_on_b.length2() - 1) <= kOff;
    if (has_normal && IsSomewhere(point, separation) && AreBodiesSomewhere(*this)) {
      output_.addContactPoint(normal_on_b, point, separation);
    }
  }

 private:
  /// Of a unit normal's square: float's rounding is far below, and a normal that is none is zero or NaN.
  static constexpr btScalar kOff = btScalar(0.01);

  btManifoldResult& output_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
