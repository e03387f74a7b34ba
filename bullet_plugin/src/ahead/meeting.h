// Contacts ahead of touching (Options::speculative_contacts), by one rule for pairs, triangles of meshes and planes.
//
// An impact that is met ahead of touching neither lets bodies overlap nor lets fast ones tunnel: Bullet's solver closes
// a gap within the step and keeps the bodies from going farther. The rule: both bodies are moved to where they meet
// within the step, the contacts are found there, and moved back to the step's beginning. Bodies that do not meet have
// none, however fast one approaches the other's plane: a contact would deflect what flies past an edge.
//
// Bodies move at the velocities that they have now. Weight is left out: what supports a body takes it up, and a body
// that slides over a seam would seem to sink into it.
//
// Physics: a sweep proves by planes how long the bodies stay apart (dgd/time_of_impact.h), so that no impact is missed;
// restitution is that of the moment of touching (manifold/restitution.h).
#pragma once

#include <algorithm>
#include <utility>

#include "dgd/any_set.h"
#include "dgd/assert.h"
#include "dgd/contact_patch.h"
#include "dgd/motion.h"
#include "dgd/time_of_impact.h"
#include "dgd_bullet/linkage.h"
#include "pair_motion.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Two shapes on their ways over the step.
class MovingPair {
 public:
  MovingPair(const PosedShape& shape_a, const PosedShape& shape_b, const PairMotion& motion)
      : a_(shape_a),
        b_(shape_b),
        way_a_(motion.WithoutForces().MotionOfA(a_.pose)),
        way_b_(motion.WithoutForces().MotionOfB(b_.pose)) {}

  /// Moves both shapes to where they are at a time from 0, the step's beginning, to 1, its end.
  void MoveTo(double time);

  const PosedShape& a() const { return a_; }
  const PosedShape& b() const { return b_; }
  double time() const { return time_; }
  const dgd::Motion<double>& way_a() const { return way_a_; }
  const dgd::Motion<double>& way_b() const { return way_b_; }

  /// Moves a patch from where the shapes are to the step's beginning, for a solver that takes the bodies to be there:
  /// each of a point's two places goes with its body and keeps its arm about the body's centre, and the separation is
  /// what the bodies' velocities at it close until now. The point of a ball that is to touch next is not the one that
  /// has turned to where it will be, and no part of its spin is an approach.
  /// @param normal  From A to B, unit, world.
  void MoveToStart(const Vector3& normal, dgd::ContactPatch<double>& patch) const;

 private:
  PosedShape a_, b_;
  const dgd::Motion<double> way_a_, way_b_;
  double time_ = 0;
};

/// What comes of two bodies that are apart, or overlap by less than counts.
enum class Encounter {
  kApart,  ///< The plane between them keeps them apart all step.
  kPass,   ///< They stay apart, though one reaches the other's plane.
  kMeet,   ///< They meet within the step.
};

struct Meeting {
  Encounter encounter = Encounter::kApart;
  Contact contact;  ///< Where they meet, if they do; its growth distance stays unknown.
};

/// Finds out whether two shapes meet, and moves them to where they do.
/// @param start          The contact at the beginning of the step.
/// @param flush          Metres: bodies that overlap by no more than this do not meet, so that one that slides over the
///                       seam of two others, flush but for roundoff, is not stopped by the second one's side.
/// @param plane_between  Contact(const Pose& a, const Pose& b): a plane between the shapes in other poses.
template <class PlaneBetween>
Meeting FindMeeting(MovingPair& pair, const Contact& start, double flush, const PlaneBetween& plane_between);

// Definitions

namespace ahead_internal {

/// A shape as the sweep evaluates it.
struct SweptCore {
  dgd::SupportPoint<double> Support(const Vector3& direction) const { return {set.CoreSupport(direction), 0}; }

  const dgd::AnySet& set;
};
struct SweptSet {
  using Scalar = double;

  explicit SweptSet(const dgd::AnySet& set) : core{set}, radius(set.Radius()) {}

  SweptCore core;
  double radius;
};

/// Planes after which bodies count as meeting: two are usual.
inline constexpr int kMaxPlanes = 8;

}  // namespace ahead_internal

template <class PlaneBetween>
Meeting FindMeeting(MovingPair& pair, const Contact& start, double flush, const PlaneBetween& plane_between) {
  using ahead_internal::SweptSet;
  DGD_ASSERT(!(flush < 0) && pair.time() == 0);
  dgd::SweepSettings<double> settings;
  settings.allowed_overlap = flush;
  settings.tolerance = std::max(settings.tolerance, flush / 2);
  settings.max_planes = ahead_internal::kMaxPlanes;
  bool is_start = true;
  const dgd::TimeOfImpactResult<double> impact =
      dgd::TimeOfImpact(SweptSet(pair.a().set), pair.way_a(), SweptSet(pair.b().set), pair.way_b(), settings,
                        [&](const Pose& pose_a, const Pose& pose_b) {
                          return std::exchange(is_start, false) ? start : plane_between(pose_a, pose_b);
                        });
  Meeting meeting;
  if (impact.status == dgd::Status::kSeparated) {
    meeting.encounter = impact.planes == 1 ? Encounter::kApart : Encounter::kPass;
    return meeting;
  }
  // Where no plane is found any more, they count as meeting: a contact too many is better than one that is missed.
  meeting.encounter = Encounter::kMeet;
  meeting.contact.status = dgd::Status::kOptimal;
  meeting.contact.normal = impact.normal;
  meeting.contact.separation = impact.separation;
  meeting.contact.witness_1 = impact.witness_1;
  meeting.contact.witness_2 = impact.witness_2;
  pair.MoveTo(impact.time);
  return meeting;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
