// What Bullet's own algorithm may say to an app in this one's place: nothing but numbers.
#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <cmath>

namespace dgd_bullet {

/// What Bullet makes of a contact are products of two lengths: in float, of 1e19 m they would be infinite.
inline bool IsSomewhere(const btVector3& point, btScalar separation) {
  constexpr btScalar kFarthest = btScalar(1e15);
  return std::abs(separation) <= kFarthest && point.absolute().dot({1, 1, 1}) <= kFarthest;  // False for NaN.
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
    const bool has_normal = std::isfinite(normal_on_b.x() + normal_on_b.y() + normal_on_b.z());
    if (has_normal && IsSomewhere(point, separation)) output_.addContactPoint(normal_on_b, point, separation);
  }

 private:
  btManifoldResult& output_;
};

}  // namespace dgd_bullet
