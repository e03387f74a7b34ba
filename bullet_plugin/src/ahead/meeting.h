// Contacts ahead of touching (Options::speculative_contacts), by one rule for pairs, triangles of meshes and planes.
//
// An impact that is met ahead of touching neither lets bodies overlap nor lets fast ones tunnel: Bullet's solver closes
// a gap within the step and keeps the bodies from going farther. The rule: both bodies are moved to where they meet
// within the step, the contacts are found there, and moved back to the step's beginning. Bodies that do not meet have
// none there, however fast one approaches the other's plane: it would deflect what flies past an edge. If they touch
// all the same, their contacts are those of the step's end, moved back: they do nothing unless others push the bodies.
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

/// The moment of a step at which contacts are found.
struct Moment {
  double time = 0;         ///< From 0, the step's beginning, to 1, its end.
  bool is_impact = false;  ///< Whether it is that at which the bodies meet.
};

/// Two shapes on their ways over the step.
class MovingPair {
 public:
  MovingPair(const PosedShape& shape_a, const PosedShape& shape_b, const PairMotion& motion)
      : a_(shape_a),
        b_(shape_b),
        motion_(motion),
        way_a_(motion_.MotionOfA(a_.pose)),
        way_b_(motion_.MotionOfB(b_.pose)) {}

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
  /// has turned to where it will be, and no part of its spin is an approach. Points where the bodies part are left out
  /// if they overlap so: the bodies are not yet in front of each other there.
  /// @param normal  From A to B, unit, world.
  /// @param flush   Metres: less overlap does not count.
  void MoveToStart(const Vector3& normal, double flush, dgd::ContactPatch<double>& patch) const;

 private:
  PosedShape a_, b_;
  const PairMotion motion_;
  const dgd::Motion<double> way_a_, way_b_;
  double time_ = 0;
};

/// Finds out whether two shapes that are apart, or overlap by less than counts, meet within the step, and moves them to
/// where they do, or else to the step's end. Returns whether they meet.
/// @param contact        In: at the beginning of the step. Out: where they meet, if they do; its growth distance stays
///                       unknown.
/// @param flush          Metres: bodies that overlap by no more than this do not meet, so that one that slides over the
///                       seam of two others, flush but for roundoff, is not stopped by the second one's side.
/// @param plane_between  Contact(const Pose& a, const Pose& b): a plane between the shapes in other poses.
template <class PlaneBetween>
bool FindMeeting(MovingPair& pair, Contact& contact, double flush, const PlaneBetween& plane_between);

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
bool FindMeeting(MovingPair& pair, Contact& contact, double flush, const PlaneBetween& plane_between) {
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
                          return std::exchange(is_start, false) ? contact : plane_between(pose_a, pose_b);
                        });
  // Where no plane is found any more, they count as meeting: a contact too many is better than one that is missed.
  const bool is_meeting = impact.status != dgd::Status::kSeparated;
  pair.MoveTo(is_meeting ? impact.time : 1);
  if (!is_meeting) return false;
  contact = Contact();
  contact.status = dgd::Status::kOptimal;
  contact.normal = impact.normal;
  contact.separation = impact.separation;
  contact.witness_1 = impact.witness_1;
  contact.witness_2 = impact.witness_2;
  return true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
