#include "bench/textbook/conic_set.h"

#include <utility>

namespace dgd_bench {
namespace {

using Eigen::Vector3d;

/// Turns constraints on a point of the core's frame into ones on its offset from the centre, where the scale is 1, and
/// adds the radius.
template <class Core>
std::optional<ConicSet> Completed(ConicSet set, const Core& core, double radius) {
  set.center = core.Center();
  set.core_inradius = core.Inradius();
  if (!(set.core_inradius > 0)) return std::nullopt;
  set.faces.col(3) += set.faces.leftCols<3>() * set.center;
  set.cone.col(3) += set.cone.leftCols<3>() * set.center;
  set.radius = radius;
  set.core_variables = radius > 0 ? 3 : 0;
  return set;
}

/// The face orthogonal to the z axis at z = height, its outside above it, at outward = 1, or below, at -1.
void AddCap(ConicSet& set, double height, double outward) {
  set.faces.conservativeResize(set.faces.rows() + 1, Eigen::NoChange);
  set.faces.bottomRows<1>() << 0, 0, -outward, outward * height;
}

/// |(x, y)| <= radius - slope * z.
void SetSide(ConicSet& set, double radius, double slope) {
  set.has_cone = true;
  set.cone.row(0) << 0, 0, -slope, radius;
  set.cone(1, 0) = set.cone(2, 1) = 1;
}

}  // namespace

std::optional<ConicSet> ConicSetOf(const dgd::Point<double>&, double radius) {
  if (!(radius > 0)) return std::nullopt;
  // The core is known: the ball's cone is the set's own.
  ConicSet set;
  set.has_cone = true;
  set.cone(0, 3) = radius;
  set.cone.bottomLeftCorner<3, 3>().setIdentity();
  set.core_inradius = radius;
  return set;
}

std::optional<ConicSet> ConicSetOf(const dgd::Segment<double>& core, double radius) {
  if (!(radius > 0)) return std::nullopt;
  ConicSet set;
  const double half_length = core.Vertex(0).z();
  if (!(half_length > 0)) return ConicSetOf(dgd::Point<double>(), radius);
  AddCap(set, half_length, 1);
  AddCap(set, -half_length, -1);
  set.center = core.Center();
  set.faces.col(3) += set.faces.leftCols<3>() * set.center;
  if (!(set.faces.col(3).minCoeff() > 0)) return std::nullopt;
  set.radius = radius;
  set.core_variables = 1;
  return set;
}

std::optional<ConicSet> ConicSetOf(const dgd::Box<double>& core, double radius) {
  ConicSet set;
  set.faces.setZero(6, 4);
  const Vector3d half_extents = core.Vertex(0);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      set.faces(2 * axis + side, axis) = side == 0 ? -1 : 1;
      set.faces(2 * axis + side, 3) = half_extents[axis];
    }
  }
  return Completed(std::move(set), core, radius);
}

std::optional<ConicSet> ConicSetOf(const dgd::Cylinder<double>& core, double radius) {
  ConicSet set;
  const double half_height = core.SupportValue(Vector3d::UnitZ());
  AddCap(set, half_height, 1);
  AddCap(set, -half_height, -1);
  SetSide(set, core.SupportValue(Vector3d::UnitX()), 0);
  return Completed(std::move(set), core, radius);
}

std::optional<ConicSet> ConicSetOf(const dgd::Cone<double>& core, double radius) {
  ConicSet set;
  const double half_height = core.SupportValue(Vector3d::UnitZ());
  AddCap(set, -half_height, -1);
  const double base_radius = core.PieceSupport(0, Vector3d::UnitX()).point.x();
  SetSide(set, base_radius / 2, base_radius / (2 * half_height));
  return Completed(std::move(set), core, radius);
}

std::optional<ConicSet> ConicSetOf(const dgd::Frustum<double>& core, double radius) {
  ConicSet set;
  const Vector3d base_rim = core.PieceSupport(0, Vector3d::UnitX()).point;
  const Vector3d top_rim = core.PieceSupport(1, Vector3d::UnitX()).point;
  AddCap(set, top_rim.z(), 1);
  AddCap(set, base_rim.z(), -1);
  SetSide(set, (base_rim.x() + top_rim.x()) / 2, (base_rim.x() - top_rim.x()) / (top_rim.z() - base_rim.z()));
  return Completed(std::move(set), core, radius);
}

std::optional<ConicSet> ConicSetOf(const dgd::Ellipsoid<double>& core, double radius) {
  ConicSet set;
  set.has_cone = true;
  // Scaled by its smallest semi-axis, so that the cone is of the other sets' size.
  const double unit = core.Inradius();
  set.cone(0, 3) = unit;
  for (int axis = 0; axis < 3; ++axis) set.cone(axis + 1, axis) = unit / core.SupportValue(Vector3d::Unit(axis));
  return Completed(std::move(set), core, radius);
}

std::optional<ConicSet> ConicSetOf(const dgd::ConvexHull& hull, double radius) {
  if (hull.dimension < 3 || hull.normals.size() > kMostConicFaces) return std::nullopt;
  ConicSet set;
  set.faces.resize(static_cast<Eigen::Index>(hull.normals.size()), 4);
  for (std::size_t facet = 0; facet < hull.normals.size(); ++facet) {
    const Vector3d& normal = hull.normals[facet];
    // Through the outermost of its vertices: merged facets are flat but for rounding.
    double height = -std::numeric_limits<double>::infinity();
    for (int i = hull.facet_start[facet]; i < hull.facet_start[facet + 1]; ++i) {
      height = std::max(height, normal.dot(hull.vertices[hull.facet_vertices[static_cast<std::size_t>(i)]]));
    }
    set.faces.row(static_cast<Eigen::Index>(facet)) << -normal.transpose(), height;
  }
  struct {
    const dgd::ConvexHull& hull;
    const Vector3d& Center() const { return hull.center; }
    double Inradius() const { return hull.inradius; }
  } core{hull};
  return Completed(std::move(set), core, radius);
}

}  // namespace dgd_bench
