// How a triangle of a mesh or a child of a compound takes its body's place in a result of Bullet: by that an app's
// callbacks identify the part of a contact, as btAdjustInternalEdgeContacts() needs it.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Puts a part in the place of its body in a result, as long as this lives.
class BoundPart {
 public:
  BoundPart(btManifoldResult& output, const btCollisionObjectWrapper& part)
      : output_(output), is_first_(output.getBody0Internal() == part.getCollisionObject()) {
    whole_ = is_first_ ? output.getBody0Wrap() : output.getBody1Wrap();
    Bind(&part);
    if (is_first_) {
      output.setShapeIdentifiersA(part.m_partId, part.m_index);
    } else {
      output.setShapeIdentifiersB(part.m_partId, part.m_index);
    }
  }
  ~BoundPart() { Bind(whole_); }
  BoundPart(const BoundPart&) = delete;
  BoundPart& operator=(const BoundPart&) = delete;

 private:
  void Bind(const btCollisionObjectWrapper* wrapper) {
    if (is_first_) {
      output_.setBody0Wrap(wrapper);
    } else {
      output_.setBody1Wrap(wrapper);
    }
  }

  btManifoldResult& output_;
  const bool is_first_;
  const btCollisionObjectWrapper* whole_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
