// Two bodies on a dispatcher, asked as Bullet asks: the raw contacts that leave the algorithm, and the manifold they
// end up in.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <memory>
#include <vector>

#include "plugin/bullet_oracle.h"

namespace dgd_test {

/// One contact as it leaves the algorithm.
struct Contact {
  Vector normal_b_to_a{0, 0, 0};
  Vector on_b{0, 0, 0};
  double depth = 0;  ///< Signed distance, metres.

  Vector OnA() const { return on_b + depth * normal_b_to_a; }
};

/// The one with the least depth; the list must not be empty.
const Contact& Deepest(const std::vector<Contact>& contacts);

/// One pair of bodies and its algorithm, which lives as long as this or until Forget().
class PairQuery {
 public:
  /// The dispatcher and the shapes must outlive this.
  PairQuery(btCollisionDispatcher& dispatcher, btConvexShape& shape_a, btConvexShape& shape_b);
  ~PairQuery();
  PairQuery(const PairQuery&) = delete;
  PairQuery& operator=(const PairQuery&) = delete;

  btCollisionObject& body_a() { return body_a_; }
  btCollisionObject& body_b() { return body_b_; }
  void SetPoses(const btTransform& pose_a, const btTransform& pose_b);
  PosedConvex A() const;
  PosedConvex B() const;

  /// One step of the pair, in the contact table; makes the algorithm if there is none. The contacts that go into the
  /// manifold.
  /// @param shared     Manifold to hand to a new algorithm, as a mesh does; null for the algorithm's own.
  /// @param time_step  Seconds; 0 as in a world without steps.
  std::vector<Contact> Step(btPersistentManifold* shared = nullptr, double time_step = 1.0 / 60);

  /// As contactPairTest() does it: a fresh algorithm, of the contact table, or of the closest-points table and all
  /// points up to `threshold` apart.
  std::vector<Contact> ContactTest() { return Ask(BT_CONTACT_POINT_ALGORITHMS, 0); }
  std::vector<Contact> ClosestPoints(double threshold) { return Ask(BT_CLOSEST_POINT_ALGORITHMS, threshold); }

  /// Destroys the algorithm, as the loss of the broadphase pair does.
  void Forget();

  btCollisionAlgorithm* algorithm() { return algorithm_; }
  /// The algorithm's own manifold; null if it has none.
  btPersistentManifold* manifold();

 private:
  std::vector<Contact> Ask(ebtDispatcherQueryType table, double threshold);

  btCollisionDispatcher& dispatcher_;
  btCollisionObject body_a_, body_b_;
  btCollisionAlgorithm* algorithm_ = nullptr;
};

}  // namespace dgd_test
