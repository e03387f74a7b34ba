// The true penetration in a scene: what no narrowphase is asked, and all are judged by.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "checkpoint/state_archive.h"
#include "scene/bodies.h"
#include "scene/polyhedron.h"
#include "scene/pose.h"
#include "simulation/collision_input.h"
#include "simulation/signed_distance.h"

namespace dgd_demos {

/// A convex set as Bullet sees it: a polyhedral core and a ball around each of its points.
struct RoundedPolyhedron {
  Polyhedron core;
  double radius;  ///< Of the ball, m.
};

/// Least translation that parts the two sets, m; 0 if they do not overlap. Exact up to rounding: whether the cores
/// overlap or not, the balls add their radii to the cores' depth, or take them off the cores' distance.
double TruePenetration(const RoundedPolyhedron& a, const Pose& pose_a, const RoundedPolyhedron& b, const Pose& pose_b);

/// One convex part of a body.
struct OraclePart {
  RoundedPolyhedron shape;
  Pose pose = {};  ///< In the body's frame.
};

/// All below a plane: the points x with normal . x <= offset.
struct HalfSpace {
  Eigen::Vector3d normal;  ///< Unit.
  double offset;           ///< m
};

/// What a body is judged by: its parts, or a half-space. One with neither is not judged: a mesh, for instance.
struct OracleBody {
  std::vector<OraclePart> parts;
  std::optional<HalfSpace> half_space = std::nullopt;

  bool IsJudged() const { return half_space.has_value() || !parts.empty(); }
};

std::vector<OracleBody> OracleBodiesOf(const std::vector<Body>& bodies);

/// The deepest true penetration in a scene, step by step. Exact, yet fast enough for every step: one separation along
/// the pair's last known axis bounds its depth from above, which leaves a few pairs a step for the full computation.
///
/// Two remarks on what "true" means. Cylinders and cones are judged as the prisms and pyramids that CoreOf() gives, so
/// their depth may come out short by 0.12 % of their radius. Boxes are judged with the little rounding of their edges
/// that RoundingRadius() has, although Bullet's special box-box algorithm takes them as sharp.
class PenetrationOracle {
 public:
  explicit PenetrationOracle(const std::vector<Body>& bodies) : PenetrationOracle(OracleBodiesOf(bodies)) {}
  explicit PenetrationOracle(std::vector<OracleBody> bodies);
  PenetrationOracle(const PenetrationOracle&) = delete;  // It points into itself.
  PenetrationOracle& operator=(const PenetrationOracle&) = delete;

  /// Over the given pairs at the given poses, m; 0 if none overlaps. All true penetrations are among the pairs of
  /// overlapping bounding boxes, since these contain the margins.
  double DeepestPenetration(const CollisionInput& input);

  /// Those of the pairs that DeepestPenetration() leaves out, because a body of theirs is not judged.
  int CountUnjudged(const CollisionInput& input) const;

  /// The last axes. Depths do not depend on them but in their last bits.
  void Serialize(StateArchive& archive);

 private:
  // Of two parts; their indices count those of all bodies, in order.
  struct Candidate {
    BodyPair parts;
    double depth_bound;  // No less than the parts' depth.
  };

  std::vector<Candidate> PartsThatMayOverlap(const std::vector<PosedPolyhedron>& cores, const std::vector<Pose>& poses,
                                             const std::vector<BodyPair>& pairs) const;
  double DeepestInHalfSpaces(const std::vector<PosedPolyhedron>& cores, const CollisionInput& input) const;
  // A unit vector along which the parts were furthest apart when last computed; the line of centres before that.
  Eigen::Vector3d LastAxis(const BodyPair& parts, const std::vector<Pose>& poses) const;
  std::uint64_t KeyOf(const BodyPair& parts) const;

  std::vector<OracleBody> bodies_;
  std::vector<int> first_parts_;  // Of each body; and behind the last, the number of all parts.
  std::vector<const OraclePart*> parts_;
  std::vector<double> bounding_radii_;  // Of the parts.
  std::unordered_map<std::uint64_t, Eigen::Vector3d> last_axes_;
};

}  // namespace dgd_demos
