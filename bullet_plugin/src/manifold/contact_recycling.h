// Contact recycling: bodies that lie still on each other keep their contacts (Options::keep_resting_contacts).
//
// A pile at rest is most of what most worlds query, and its contacts change by less than the solver's own tolerance.
// While neither body has moved by more than a small part of the breaking threshold since the contacts were found,
// Bullet's refresh makes their distances exact along their normals, as it does between any two steps.
//
// Bodies that sink, sway or are carried along together keep their contacts as well, where a face of one is the
// reference face or two faces meet: the normal turns with the face. The bodies may then have moved more against each
// other, which leaves the points where they are on the face; distances differ by that displacement times the angle
// between the surfaces. It is measured at the contacts, or as what the smaller body tilts by; about the normal it may
// turn. Between two turns of the normal nothing but distances changes: a change in each step makes bodies tremble.
//
// Physics: no distance is off by more than 10 micrometres for large bodies, no place by more than 1.6 mm, along the
// face. Bodies that may roll are never recycled while they do.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <LinearMath/btTransform.h>

#include <array>
#include <memory>

#include "dgd/contact/reference_face.h"
#include "dgd_bullet/linkage.h"
#include "shapes/hull_cache.h"
#include "shapes/shape_identity.h"

class btManifoldResult;
class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairManifold;
class PairMotion;
struct Options;

/// Whether the options let contacts be recycled, so that they come from other poses than this step's.
bool MayRecycle(const Options& options, const PairManifold& manifold);

/// The face that contacts lie on, if any.
struct ReferenceFace {
  dgd::ReferenceSide side =
      dgd::ReferenceSide::kNone;  ///< The body whose face it is; the contacts' normal turns with it.
  /// How far contacts may slide, and the smaller body's rim tilt by half as much, before they are found from scratch;
  /// metres.
  double max_drift = 0;
};

/// The least number of contacts that are recycled: on fewer a body rolls, and is pushed on by points that turn with it.
/// Polytopes do not roll: one stands on a face by a corner of its own as well.
int MinRecycledContacts(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b);

/// The reference face of a manifold's contacts; none with fewer than MinRecycledContacts(). Its drift is 1.6 mm for
/// large bodies, or less where the surfaces are not as good as parallel, so that no distance changes by more than 10
/// micrometres on the way.
/// @param side  The body that has a face across the normal, if any. Without one, three contacts or more are where edges
///              of two faces cross that are nearly parallel: the normal is neither's, and turns with both.
ReferenceFace ReferenceFaceOf(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                              dgd::ReferenceSide side, const btPersistentManifold& manifold);

/// A pair as it was when its contacts were found; the two bodies in the order that their shapes are solved in.
class RecycledContacts {
 public:
  using Hull = std::shared_ptr<const CachedHull>;

  /// A body now, and its shape's hull if it is a hull of points.
  struct Side {
    const btCollisionObjectWrapper& body;
    const Hull& hull;
  };

  /// Caches a pair whose contacts have just been found, if it will be nearly as it is after the step.
  /// @param motion    The bodies' motion in the step.
  /// @param recycled  Made if there is none; null without memory.
  /// @return whether it is cached.
  static bool Cache(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                    const ReferenceFace& face, const PairMotion& motion, const btPersistentManifold& manifold,
                    std::unique_ptr<RecycledContacts>& recycled);

  /// Updates the contacts of a pair that is as it was: their distances, and what the bodies' materials make of them.
  /// @param time_step  Seconds, for friction anchors.
  /// @param motion     The bodies' motion in the step, in the manifold's order, if they rebound.
  /// @return whether it is.
  bool Update(const Side& a, const Side& b, const Options& options, btScalar time_step, const PairMotion& motion,
              btPersistentManifold& manifold, btManifoldResult& output);

 private:
  /// The change of the poses.
  enum class PoseChange {
    kStill,          ///< Neither body has moved since the contacts were last found or updated.
    kMovedTogether,  ///< The bodies have moved, and are on the reference face as they were.
    kChanged,        ///< Anything else; also other shapes or contacts.
  };

  /// A body when its contacts were found.
  struct CachedSide {
    explicit CachedSide(const btCollisionObjectWrapper& body);

    ShapeIdentity shape;
    btTransform pose;
    btScalar radius;  // Distance of the body's farthest point from the pose's origin; metres.
  };

  RecycledContacts(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                   const btPersistentManifold& manifold, const ReferenceFace& face);

  bool IsSameShape(std::size_t side, const Side& now) const {
    return sides_[side].shape.Matches(*now.body.getCollisionShape(), now.hull);
  }
  PoseChange Compare(const Side& a, const Side& b, const btPersistentManifold& manifold) const;
  PoseChange ComparePoses(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                          const btPersistentManifold& manifold) const;
  const CachedSide& FaceSide() const { return sides_[face_.side == dgd::ReferenceSide::kSet1 ? 0 : 1]; }

  /// Turns the contacts' normal with the reference face of bodies that have moved together.
  void TurnNormals(const btCollisionObjectWrapper& body_a, const btCollisionObjectWrapper& body_b,
                   btPersistentManifold& manifold);

  std::array<CachedSide, 2> sides_;
  btTransform pose_ab_;  // Pose of body B in body A's frame.
  ReferenceFace face_;
  btVector3 normal_;  // Normal of the contacts, in the frame of the reference face's body.
  int contacts_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
