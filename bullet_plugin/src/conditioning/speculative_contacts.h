// Contacts of bodies that are still apart but meet within the time step: Options::speculative_contacts.
//
// An impact that is met ahead of touching neither lets bodies overlap nor lets fast ones tunnel. Bullet's solver closes
// a gap within the step and keeps the bodies from going farther.
//
// Physics: a contact acts on bodies that would have passed each other, so a sweep over the step classifies the pair
// first; restitution is that of the moment of touching (restitution.h). What is left of the price: bodies that turn by
// more than about a tenth of a radian in the step are swept by a bound that is not rigorous.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"
#include "dgd/motion.h"
#include "dgd_bullet/linkage.h"
#include "pipeline/pair_motion.h"
#include "shapes/posed_shape.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct PairQuery;

/// Two shapes on their ways over the step.
class MovingPair {
 public:
  MovingPair(const PosedShape& shape_a, const PosedShape& shape_b, const PairMotion& motion)
      : a_(shape_a),
        b_(shape_b),
        way_a_(motion.MotionOfA(a_.pose)),
        way_b_(motion.MotionOfB(b_.pose)),
        share_of_a_(motion.ShareOfA()) {}

  /// @param time  From 0 to 1.
  void MoveTo(double time);

  /// Along a normal from A to B, where the shapes are; metres.
  double SeparationAlong(const Vector3& normal) const;

  /// The signed distance where the shapes are.
  /// @param can_update  Whether UpdateDistance() can start from the warm start.
  Contact Distance(const dgd::Settings<double>& settings, bool can_update, dgd::WarmStart<double>& warm_start) const;

  /// A contact where the shapes are, for a solver that takes the bodies to be where they are at the start of the step:
  /// it has the arms about the bodies' centres and the normal that it has here, and the separation that the bodies'
  /// velocities at it close until now. The point of a ball that is to touch next is not the one that has turned to
  /// where it will be, and no part of its spin is an approach.
  Contact AtStart(Contact contact) const;

 private:
  PosedShape a_, b_;
  const dgd::Motion<double> way_a_, way_b_;
  const double share_of_a_;
  double time_ = 0;
};

/// Whether turning takes the shapes clear of each other, which approach along straight lines: they are apart along
/// `normal` (unit, from A to B) half way through the step and at its end. Only if turning takes points off those lines
/// by more than `flush`, metres.
bool TurnsClear(const PosedShape& shape_a, const PosedShape& shape_b, const PairMotion& motion, const Vector3& normal,
                double flush);

/// Moves the points of a patch apart by as much as a straight motion brings them together, and `flush`: they have no
/// effect then unless other bodies' impacts change the motion.
/// @param normal  From A to B, unit.
void LetPass(dgd::ContactPatch<double>& patch, const Vector3& normal, const PairMotion& motion, double flush);

enum class Encounter {
  kMeet,       ///< They meet on about the plane that is between them now.
  kMeetAside,  ///< They meet on another plane.
  kPass,       ///< They do not meet.
};

struct PredictedEncounter {
  Encounter encounter;
  /// The contact at the start of the step. kMeet: the one that was given. kMeetAside: along the normal that the bodies
  /// meet on, of the two points that will touch. kPass: along the last normal that keeps them apart, of the two points
  /// that are nearest then.
  Contact contact;
};

/// Moves the shapes from plane to plane: each is the signed distance's where the last one lets them through, by
/// conservative advancement with a linear bound (Mirtich 1996; not rigorous where bodies turn by much more than a tenth
/// of a radian in the step). That bodies approach along the normal between them does not say that they meet: a body
/// that flies past an edge approaches it too, and a contact would deflect it.
/// @param pair        The shapes; they are moved.
/// @param flush       Metres: bodies that overlap by less than about this do not meet, so that one that slides over the
///                    seam of two others, flush but for roundoff, is not stopped by the second one's side.
/// @param settings, warm_start, can_update  Those of the last query of the pair.
/// @param start       The contact at the start of the step, apart or overlapping by less than `flush`.
/// @param at_end      The separation along its normal at the end of the step: an overlap by more than that; metres.
PredictedEncounter PredictEncounter(MovingPair& pair, const dgd::Settings<double>& settings,
                                    dgd::WarmStart<double> warm_start, bool can_update, const Contact& start,
                                    double at_end, double flush);

/// Which contacts bodies get that are apart, or overlap by less than counts.
enum class SpeculativeKind {
  kNone,
  kPatch,         ///< Those of their faces.
  kPassingPatch,  ///< Those of their faces, moved apart so that they have no effect (LetPass()).
  kPoint,         ///< One at the points that will meet.
};

/// Classifies a certified contact by the bodies' motion. For kPoint, the contact becomes that one.
SpeculativeKind ClassifySpeculative(PairQuery& query, Contact& contact);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
