// Bodies that lie still keep their contacts: what was found for them once is what would be found again.
//
// A pile at rest is most of what most worlds ask about, and its contacts change by less than the solver's own
// tolerance. While neither body has moved by more than a small part of the manifold's breaking threshold since the
// contacts were found, they are kept: Bullet's refresh makes their distances exact along their normals, as it does for
// all contacts between two steps, and a normal is off by no more than the part of the threshold over the body's size.
#pragma once

#include <LinearMath/btTransform.h>

#include <array>
#include <memory>

#include "hull_cache.h"

class btConvexShape;
class btManifoldResult;
class btPersistentManifold;
struct btCollisionObjectWrapper;

namespace dgd_bullet {

/// Distance that counts as none, in metres, for a manifold with this breaking threshold: 20 micrometres for large
/// bodies. Five times as much saves another tenth of a heap's narrowphase time, and triples the speed that a pyramid is
/// left with (0.012 to 0.038 mm/s).
constexpr double RestingDistance(double breaking_threshold) { return 1e-3 * breaking_threshold; }

/// A pair as it was when its contacts were found.
class RestingPair {
 public:
  using Hull = std::shared_ptr<const CachedHull>;

  RestingPair(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
              const btPersistentManifold& manifold);

  /// Whether a pair can be told to be as it was: shapes whose numbers can be compared, and bodies whose contacts an app
  /// does not want to see anew at each step, for it colours them; where poses are exact enough to tell the distance.
  static bool CanTell(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1, double distance);

  /// Whether both bodies are still in their places, their shapes are what they were, and the manifold holds the
  /// contacts that were left in it.
  /// @param hull_0, hull_1  Of the shapes if they are hulls of points, else of no account.
  bool IsAsItWas(const btCollisionObjectWrapper& body_0, const btCollisionObjectWrapper& body_1,
                 const btPersistentManifold& manifold, const Hull& hull_0, const Hull& hull_1) const;

 private:
  struct Side {
    const btConvexShape* shape;
    int type;
    int axis;  // Another shape of the same size may have taken the address.
    btVector3 size;
    btScalar margin;
    btTransform pose;
  };

  static Side SideOf(const btCollisionObjectWrapper& body);
  static bool IsSame(const Side& then, const btCollisionObjectWrapper& body, const Hull& hull, btScalar distance);

  std::array<Side, 2> sides_;
  int contacts_;
};

/// Brings the contacts of a pair that is as it was up to date: distances, and what the bodies' materials make of them.
void KeepContacts(btPersistentManifold& manifold, btManifoldResult& output);

}  // namespace dgd_bullet
