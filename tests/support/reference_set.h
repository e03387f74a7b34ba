// A convex set as plain numbers, with its own support height: what the generators make, the cores are built from, and
// the answers are checked against. Shares no code with dgd_core.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace dgd_test {

enum class CoreType {
  kPoint,
  kSegment,
  kTriangle,
  kBox,
  kCylinder,
  kCone,
  kPolytope,
  kFrustum,
  kEllipsoid,
  kMesh,
  kDsf,
};
/// Those that a SolverPair is made of.
inline constexpr std::array<CoreType, 7> kCoreTypes = {CoreType::kPoint,   CoreType::kSegment,  CoreType::kTriangle,
                                                       CoreType::kBox,     CoreType::kCylinder, CoreType::kCone,
                                                       CoreType::kPolytope};
const char* Name(CoreType type);

/// core + ball(radius), in its own frame; metres.
struct ReferenceSet {
  CoreType type = CoreType::kPoint;
  /// Segment: half length in z. Box: half extents. Cylinder: radius, half height in z. Cone: base radius, height in z.
  /// Frustum: base radius, top radius, height in z. Ellipsoid: semi-axes.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  /// Triangle: its corners. Polytope, mesh: points whose hull it is. Dsf: its vertices, each extreme.
  std::vector<Eigen::Vector3d> points = {};
  double radius = 0;
  /// Dsf: the exponent, and the inner point that its support function is about.
  double exponent = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();

  /// Largest <direction, x> over the core plus radius, for a unit direction.
  double Height(const Eigen::Vector3d& direction) const;
  /// A point of the core.
  Eigen::Vector3d Middle() const;
  /// Largest distance of two points of the set, at least and at most twice that.
  double Extent() const;
  /// Whether the core alone has an interior. Triangles, segments and points have none.
  bool IsSolid() const { return type >= CoreType::kBox; }
};

/// World from local: x_world = rotation * x_local + translation.
struct ReferencePose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector3d& local) const { return rotation * local + translation; }
};

struct ReferencePair {
  ReferenceSet set_1, set_2;
  ReferencePose pose_1, pose_2;

  /// Largest extent of the two, metres: what tolerances on lengths are relative to.
  double Extent() const { return std::max(set_1.Extent(), set_2.Extent()); }
  /// Distance of the two sets' supporting planes along a unit vector from set 1 to set 2; metres.
  double SeparationAlong(const Eigen::Vector3d& normal) const;
  /// All numbers with 17 digits, to be pasted into a test.
  std::string Dump() const;
};

/// Largest <direction, x> of a posed set, world.
double Height(const ReferenceSet& set, const ReferencePose& pose, const Eigen::Vector3d& direction);

/// World coordinates of a triangle's or polytope's points, or a box's corners, a segment's ends, or a point.
std::vector<Eigen::Vector3d> WorldVertices(const ReferenceSet& set, const ReferencePose& pose);

/// The points of a span, moved and scaled: for exact copies of a case elsewhere.
ReferenceSet Scaled(const ReferenceSet& set, double scale);

}  // namespace dgd_test
