// How the contacts of a step and the points of a manifold correspond: continued points have the solver's last impulses.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <array>
#include <span>

#include "dgd/assert.h"
#include "dgd_bullet/linkage.h"
#include "manifold/manifold_writer.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Contacts, and which of the manifold's points they continue: the nearest one within the breaking threshold, by the
/// place on body A, as in Bullet's own cache.
class ContinuedContacts {
 public:
  static constexpr int kNew = -1;

  ContinuedContacts(std::span<const ManifoldContact> contacts, const btPersistentManifold& manifold)
      : size_(contacts.size()) {
    DGD_ASSERT(contacts.size() <= MANIFOLD_CACHE_SIZE);
    const int cached = manifold.getNumContacts();
    const btTransform& pose_a = manifold.getBody0()->getWorldTransform();
    const btScalar threshold = manifold.getContactBreakingThreshold();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      on_a_in_body_[i] = pose_a.invXform(contacts[i].on_a);
      btScalar nearest_sq = threshold * threshold;
      int nearest = kNew;
      for (int j = 0; j < cached; ++j) {
        if (IsContinued(j)) continue;
        const btScalar distance_sq = (manifold.getContactPoint(j).m_localPointA - on_a_in_body_[i]).length2();
        if (!(distance_sq < nearest_sq)) continue;
        nearest_sq = distance_sq;
        nearest = j;
      }
      continued_[i] = nearest;
      if (nearest != kNew) is_continued_[static_cast<std::size_t>(nearest)] = true;
    }
  }

  /// The manifold's point that a contact continues, or kNew. No two contacts continue the same one.
  int PointOf(std::size_t contact) const {
    DGD_ASSERT(contact < size_);
    return continued_[contact];
  }
  bool IsContinued(int point) const {
    DGD_ASSERT(point >= 0 && point < MANIFOLD_CACHE_SIZE);
    return is_continued_[static_cast<std::size_t>(point)];
  }
  bool IsAnyContinued() const {
    return std::find(is_continued_.begin(), is_continued_.end(), true) != is_continued_.end();
  }
  /// A contact's place on body A, in A's frame.
  const btVector3& OnAInBody(std::size_t contact) const { return on_a_in_body_[contact]; }

  /// Drops the manifold's points that no contact continues. If there are contacts and none continues, the first point
  /// is left for a new one to take its place: a contact that goes on at another point never passes through zero points.
  /// @return whether it is left.
  bool DropStale(btPersistentManifold& manifold) {
    const bool spares_first = size_ > 0 && manifold.getNumContacts() > 0 && !IsAnyContinued();
    for (int j = manifold.getNumContacts() - 1; j >= (spares_first ? 1 : 0); --j) {
      if (IsContinued(j)) continue;
      // Bullet moves the last point into the gap.
      const int last = manifold.getNumContacts() - 1;
      manifold.removeContactPoint(j);
      for (std::size_t i = 0; i < size_; ++i) {
        if (continued_[i] == last) continued_[i] = j;
      }
    }
    return spares_first;
  }

 private:
  std::size_t size_;
  std::array<btVector3, MANIFOLD_CACHE_SIZE> on_a_in_body_;
  std::array<int, MANIFOLD_CACHE_SIZE> continued_;
  std::array<bool, MANIFOLD_CACHE_SIZE> is_continued_{};  // Indexed by the manifold's points.
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
