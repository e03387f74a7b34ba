// From plain numbers to a core of the solver's: the one place to extend, beside set_type.h, for a new type of set.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dgd/shapes.h"
#include "support/pairs/plain_cores.h"
#include "support/pairs/set_numbers.h"

namespace dgd_test {
namespace core_internal {

template <class S, class Core>
auto Mapped(Core core, const SetNumbers& set) {
  return dgd::Transformed(std::move(core), dgd::Matrix3<S>(set.stretch.cast<S>()),
                          dgd::Vector3<S>(set.points.at(0).cast<S>()));
}

[[noreturn]] inline void RefuseType(SetType type, int dimension) {
  throw std::invalid_argument(std::string("no ") + InfoOf(type).name + " in " + std::to_string(dimension) +
                              " dimensions");
}

template <class S, class Use>
auto WithSolid(const SetNumbers& set, const Use& use) -> decltype(use(dgd::Point<S>())) {
  const dgd::Vector3<S> lengths = set.lengths.cast<S>();
  const auto point = [&set](std::size_t i) -> dgd::Vector3<S> { return set.points.at(i).cast<S>(); };
  switch (set.type) {
    case SetType::kPoint:
      return use(dgd::Point<S>());
    case SetType::kSegment:  // Half length.
      return use(dgd::Segment<S>(lengths[0]));
    case SetType::kTriangle:
      return use(dgd::Triangle<S>(point(0), point(1), point(2)));
    case SetType::kBox:  // Half extents.
      return use(dgd::Box<S>(lengths));
    case SetType::kCylinder:  // Radius, half height.
      return use(dgd::Cylinder<S>(lengths[0], lengths[1]));
    case SetType::kCone:  // Radius, height.
      return use(dgd::Cone<S>(lengths[0], lengths[1]));
    case SetType::kFrustum:  // Base radius, top radius, height.
      return use(dgd::Frustum<S>(lengths[0], lengths[1], lengths[2]));
    case SetType::kEllipsoid:  // Semi-axes.
      return use(dgd::Ellipsoid<S>(lengths));
    case SetType::kPolytope:  // The points' hull.
      return use(dgd::Polytope<S>(set.points));
    case SetType::kMesh:  // The points' hull.
      return use(dgd::Mesh<S>(set.points));
    case SetType::kDsf:
      return use(dgd::Dsf<S>(set.points, set.exponent));
    case SetType::kAffineBox:  // Half extents, map, offset.
      return use(Mapped<S>(dgd::Box<S>(lengths), set));
    case SetType::kAffineCylinder:  // Radius, half height, map, offset.
      return use(Mapped<S>(dgd::Cylinder<S>(lengths[0], lengths[1]), set));
    case SetType::kPlainBox:  // Half extents.
      return use(PlainBox<S>(lengths));
    case SetType::kSuperellipsoid:  // Semi-axes.
      return use(Superellipsoid<S, 3>(lengths, set.exponent));
    default:
      RefuseType(set.type, 3);
  }
}

template <class S, class Use>
auto WithFlat(const SetNumbers& set, const Use& use) -> decltype(use(dgd::Point<S, 2>())) {
  const dgd::Vector2<S> lengths = set.lengths.head<2>().cast<S>();
  switch (set.type) {
    case SetType::kCircle:
      return use(dgd::Point<S, 2>());
    case SetType::kStadium:  // Half length.
      return use(dgd::Segment<S, 2>(lengths[0]));
    case SetType::kRectangle:  // Half extents.
      return use(dgd::Box<S, 2>(lengths));
    case SetType::kEllipse:  // Semi-axes.
      return use(dgd::Ellipsoid<S, 2>(lengths));
    case SetType::kPolygon: {  // The points' hull.
      std::vector<Eigen::Vector2d> points;
      for (const Eigen::Vector3d& point : set.points) points.push_back(point.head<2>());
      return use(dgd::Polygon<S>(points));
    }
    case SetType::kSuperellipse:  // Semi-axes.
      return use(Superellipsoid<S, 2>(lengths, set.exponent));
    default:
      RefuseType(set.type, 2);
  }
}

}  // namespace core_internal

/// What `use` makes of the core, which is a template of any core: the radius is not in it.
/// Throws std::invalid_argument for a type of another dimension.
template <class S, int L, class Use>
auto WithCore(const SetNumbers& set, const Use& use) {
  if constexpr (L == 2) {
    return core_internal::WithFlat<S>(set, use);
  } else {
    return core_internal::WithSolid<S>(set, use);
  }
}

}  // namespace dgd_test
