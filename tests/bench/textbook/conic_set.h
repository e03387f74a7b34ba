// A convex set as a conic solver has it: linear inequalities and second-order cones on a point and the set's scale.
#pragma once

#include <concepts>
#include <optional>

#include "dgd/shapes.h"

namespace dgd_bench {

/// The second-order cone of four dimensions: v[0] >= |v.tail<3>()|. One of fewer has zeros at its end.
///
/// The core scaled by alpha about its centre is the set of the points y, from the centre, in the core's frame and in
/// metres, for which
///   faces (y, alpha) >= 0  and, if it has one,  cone (y, alpha) is in the second-order cone;
/// the set, that of the points within alpha * radius of it. Tracy et al. 2023, Sec. III; their extra variables, the
/// place on a capsule's segment and the point of a polygon that has a cushion, are here those of the core's point,
/// which any core with a radius may have.
struct ConicSet {
  Eigen::MatrixX4d faces{0, 4};                    ///< A row each: inward unit normal, distance of the centre.
  Eigen::Matrix4d cone = Eigen::Matrix4d::Zero();  ///< In the last column metres, in the others none.
  bool has_cone = false;
  double radius = 0;       ///< Metres; above 0, the core's point is unknown as well as the set's.
  int core_variables = 0;  ///< 0; or, of the core's unknown point, the last 1 or 3 coordinates: the others are 0.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< In the set's frame, metres.
  double core_inradius = 0;                          ///< About the centre, metres.

  double Inradius() const { return core_inradius + radius; }
};

/// Hulls with more facets are no small primitives, and the solver keeps eight numbers of each facet on the stack.
inline constexpr int kMostConicFaces = 1024;

/// None for what has no conic form here: a set without an interior, flat cores, a segment about its end, a hull of more
/// than kMostConicFaces.
/// @param radius  Metres, >= 0.
std::optional<ConicSet> ConicSetOf(const dgd::Point<double>& core, double radius);
std::optional<ConicSet> ConicSetOf(const dgd::Segment<double>& core, double radius);
std::optional<ConicSet> ConicSetOf(const dgd::Box<double>& core, double radius);
std::optional<ConicSet> ConicSetOf(const dgd::Cylinder<double>& core, double radius);
std::optional<ConicSet> ConicSetOf(const dgd::Cone<double>& core, double radius);
std::optional<ConicSet> ConicSetOf(const dgd::Frustum<double>& core, double radius);
std::optional<ConicSet> ConicSetOf(const dgd::Ellipsoid<double>& core, double radius);
/// Also of what dgd::Polytope and dgd::Mesh are made of.
std::optional<ConicSet> ConicSetOf(const dgd::ConvexHull& hull, double radius);
template <dgd::VertexId kMostScanned>
std::optional<ConicSet> ConicSetOf(const dgd::Polytope<double, kMostScanned>& core, double radius) {
  return ConicSetOf(core.Hull(), radius);
}

/// Whether a type has a conic form at all.
template <class Core>
concept ConicCore = requires(const Core& core) {
  { ConicSetOf(core, 0.0) } -> std::same_as<std::optional<ConicSet>>;
};

}  // namespace dgd_bench
