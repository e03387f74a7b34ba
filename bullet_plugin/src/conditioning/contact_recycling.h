// Bodies that lie still on each other keep their contacts: what was found for them once is what would be found again.
//
// A pile at rest is most of what most worlds ask about, and its contacts change by less than the solver's own
// tolerance. While neither body has moved by more than a small part of the manifold's breaking threshold since the
// contacts were found, they are kept: Bullet's refresh makes their distances exact along their normals, as it does for
// all contacts between two steps, and a normal is off by no more than the part of the threshold over the body's size.
//
// Bodies that sink, sway or are carried along together keep theirs as well, where a face of one holds the contact or
// two faces meet: the normal turns with the face, and along that the refresh is exact for the very points. What the
// bodies have moved by against each other may then be more, for it only leaves the points where they are on the face;
// the distance of what would be found instead differs by that way times the angle between the surfaces. The way is that
// of the contacts, or what the smaller body tilts by against the other: about the normal it may turn. Between two
// turns of the normal the bodies are still, and nothing but distances changes: a change in each step, be it of the
// points' order alone, makes bodies tremble.
#pragma once

#include <LinearMath/btTransform.h>

#include <array>
#include <memory>

#include "dgd/held_face.h"
#include "dgd_bullet/linkage.h"
#include "shapes/hull_cache.h"

class btCollisionShape;
class btManifoldResult;
class btPersistentManifold;
struct btCollisionObjectWrapper;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairMotion;

/// Distance that counts as none, in metres, for a manifold with this breaking threshold: 20 micrometres for large
/// bodies. Five times as much saves another tenth of a heap's narrowphase time, and triples the speed that a pyramid is
/// left with (0.012 to 0.038 mm/s).
constexpr double RestingDistance(double breaking_threshold) { return 1e-3 * breaking_threshold; }

/// What contacts lie on: a face of a body, or none.
struct Footing {
  dgd::FaceHolder holder = dgd::FaceHolder::kNone;  ///< Whose face it is that the contacts' normal turns with.
  /// How far contacts may slide, and the smaller body's rim tilt by half as much, before they are found anew; metres.
  double max_drift = 0;
};

/// On fewer contacts a body rolls, and is pushed on by points that turn with it: they are no footing. Polytopes do not:
/// one stands on a face by a corner of its own as well.
int FewestOfFooting(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b);

/// The footing of FewestOfFooting() contacts or more on a holder's face. Its drift is 1.6 mm for large bodies, or less
/// where the surfaces are not as good as parallel, so that no distance changes by more than 10 micrometres on the way.
Footing FootingOn(dgd::FaceHolder holder, const btPersistentManifold& manifold);

/// Whether the footing of one contact or more lasts for the time step at least.
bool Lasts(const Footing& footing, const PairMotion& motion, const btPersistentManifold& manifold);

/// A pair as it was when its contacts were found. The two bodies in the order that they are solved in.
class RestingPair {
 public:
  using Hull = std::shared_ptr<const CachedHull>;

  /// @param manifold  With contacts, of one normal.
  RestingPair(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
              const btPersistentManifold& manifold, const Footing& footing);

  /// Whether a pair can be told to be as it was: shapes whose numbers can be compared, and bodies whose contacts an app
  /// does not want to see anew at each step, for it colours them; where poses are exact enough to tell the distance.
  /// @param breaking_threshold  The manifold's, metres.
  static bool CanTell(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                      double breaking_threshold, const Footing& footing);

  /// What has become of a pair since.
  enum class Since {
    kStill,          ///< Both bodies are in the places that they were last found or followed in.
    kMovedTogether,  ///< On a face, in their places to each other: to be followed.
    kChanged,        ///< Neither; or the shapes or the manifold's contacts are others.
  };

  /// @param hull_a, hull_b  Of the shapes if they are hulls of points, else of no account.
  Since Compare(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                const btPersistentManifold& manifold, const Hull& hull_a, const Hull& hull_b) const;

  /// Follows bodies that have moved together: turns the contacts' normal with the face that holds it.
  void Follow(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
              btPersistentManifold& manifold);

 private:
  struct Side {
    const btCollisionShape* shape;
    int type;
    int axis;  // Another shape of the same size may have taken the address.
    btVector3 size;
    btScalar offset;  // The margin; of a plane, its constant.
    btScalar reach;   // From the pose's origin to the body's farthest point.
    btTransform pose;
  };

  static Side SideOf(const btCollisionObjectWrapper& body);
  static bool IsSameShape(const Side& then, const btCollisionObjectWrapper& body, const Hull& hull);
  Since ComparePlaces(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                      const btPersistentManifold& manifold) const;

  std::array<Side, 2> sides_;
  btTransform between_;  // Pose of body B seen from body A.
  Footing footing_;
  btVector3 held_normal_;  // Of the contacts, in the holder's frame.
  int contacts_;
};

/// Notes a pair whose contacts have just been found, if it will be nearly as it is after the step.
/// @param resting  Made if there is none; without memory, there is none.
/// @return whether it is noted.
bool RememberRest(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                  const Footing& footing, const PairMotion& motion, const btPersistentManifold& manifold,
                  std::unique_ptr<RestingPair>& resting);

/// Brings the contacts of a pair up to date if it is as it was: distances, and what the bodies' materials make of them.
/// @param anchor_time_step  Seconds, for friction anchors; 0 without Options::friction_anchors.
/// @return whether it is.
bool KeepContacts(RestingPair& resting, const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                  const RestingPair::Hull& hull_a, const RestingPair::Hull& hull_b, double anchor_time_step,
                  btPersistentManifold& manifold, btManifoldResult& output);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
