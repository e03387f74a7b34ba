// From plain numbers to a core of the solver's: the one place to extend, beside set_type.h, for a new type of set.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dgd/shapes.h"
#include "support/pairs/plain_cores.h"
#include "support/pairs/set_numbers.h"
#include "support/sets/dsf.h"
#include "support/sets/transformed.h"

namespace dgd_test {
namespace core_internal {

template <class S, SetType kType>
struct Wanted {};

template <class S>
dgd::Vector3<S> PointOf(const SetNumbers& set, std::size_t i) {
  return set.points.at(i).cast<S>();
}

template <class S, class Core>
Transformed<Core> Mapped(const Core& core, const SetNumbers& set) {
  return Transformed(core, dgd::Matrix3<S>(set.stretch.cast<S>()), PointOf<S>(set, 0));
}

template <class S>
dgd::Point<S> Make(Wanted<S, SetType::kPoint>, const SetNumbers&) {
  return {};
}
/// Half length.
template <class S>
dgd::Segment<S> Make(Wanted<S, SetType::kSegment>, const SetNumbers& set) {
  return dgd::Segment<S>(static_cast<S>(set.lengths[0]));
}
template <class S>
dgd::Triangle<S> Make(Wanted<S, SetType::kTriangle>, const SetNumbers& set) {
  return {PointOf<S>(set, 0), PointOf<S>(set, 1), PointOf<S>(set, 2)};
}
/// Half extents.
template <class S>
dgd::Box<S> Make(Wanted<S, SetType::kBox>, const SetNumbers& set) {
  return dgd::Box<S>(set.lengths.cast<S>());
}
/// Radius, half height.
template <class S>
dgd::Cylinder<S> Make(Wanted<S, SetType::kCylinder>, const SetNumbers& set) {
  return {static_cast<S>(set.lengths[0]), static_cast<S>(set.lengths[1])};
}
/// Radius, height.
template <class S>
dgd::Cone<S> Make(Wanted<S, SetType::kCone>, const SetNumbers& set) {
  return {static_cast<S>(set.lengths[0]), static_cast<S>(set.lengths[1])};
}
/// Base radius, top radius, height.
template <class S>
dgd::Frustum<S> Make(Wanted<S, SetType::kFrustum>, const SetNumbers& set) {
  return {static_cast<S>(set.lengths[0]), static_cast<S>(set.lengths[1]), static_cast<S>(set.lengths[2])};
}
/// Semi-axes.
template <class S>
dgd::Ellipsoid<S> Make(Wanted<S, SetType::kEllipsoid>, const SetNumbers& set) {
  return dgd::Ellipsoid<S>(set.lengths.cast<S>());
}
/// The points' hull.
template <class S>
dgd::Polytope<S> Make(Wanted<S, SetType::kPolytope>, const SetNumbers& set) {
  return dgd::Polytope<S>(set.points);
}
/// The points' hull.
template <class S>
dgd::Mesh<S> Make(Wanted<S, SetType::kMesh>, const SetNumbers& set) {
  return dgd::Mesh<S>(set.points);
}
template <class S>
Dsf<S> Make(Wanted<S, SetType::kDsf>, const SetNumbers& set) {
  return Dsf<S>(set.points, set.exponent);
}
/// Half extents, map, offset.
template <class S>
Transformed<dgd::Box<S>> Make(Wanted<S, SetType::kAffineBox>, const SetNumbers& set) {
  return Mapped<S>(Make(Wanted<S, SetType::kBox>(), set), set);
}
/// Radius, half height, map, offset.
template <class S>
Transformed<dgd::Cylinder<S>> Make(Wanted<S, SetType::kAffineCylinder>, const SetNumbers& set) {
  return Mapped<S>(Make(Wanted<S, SetType::kCylinder>(), set), set);
}
/// Half extents.
template <class S>
PlainBox<S> Make(Wanted<S, SetType::kPlainBox>, const SetNumbers& set) {
  return PlainBox<S>(set.lengths.cast<S>());
}
/// Semi-axes.
template <class S>
Superellipsoid<S, 3> Make(Wanted<S, SetType::kSuperellipsoid>, const SetNumbers& set) {
  return {set.lengths.cast<S>(), set.exponent};
}

template <class S>
dgd::Point<S, 2> Make(Wanted<S, SetType::kCircle>, const SetNumbers&) {
  return {};
}
/// Half length.
template <class S>
dgd::Segment<S, 2> Make(Wanted<S, SetType::kStadium>, const SetNumbers& set) {
  return dgd::Segment<S, 2>(static_cast<S>(set.lengths[0]));
}
/// Half extents.
template <class S>
dgd::Box<S, 2> Make(Wanted<S, SetType::kRectangle>, const SetNumbers& set) {
  return dgd::Box<S, 2>(set.lengths.head<2>().cast<S>());
}
/// Semi-axes.
template <class S>
dgd::Ellipsoid<S, 2> Make(Wanted<S, SetType::kEllipse>, const SetNumbers& set) {
  return dgd::Ellipsoid<S, 2>(set.lengths.head<2>().cast<S>());
}
/// The points' hull.
template <class S>
dgd::Polygon<S> Make(Wanted<S, SetType::kPolygon>, const SetNumbers& set) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& point : set.points) points.push_back(point.head<2>());
  return dgd::Polygon<S>(points);
}
/// Semi-axes.
template <class S>
Superellipsoid<S, 2> Make(Wanted<S, SetType::kSuperellipse>, const SetNumbers& set) {
  return {set.lengths.head<2>().cast<S>(), set.exponent};
}

[[noreturn]] inline void RefuseType(SetType type, int dimension) {
  throw std::invalid_argument(std::string("no ") + InfoOf(type).name + " in " + std::to_string(dimension) +
                              " dimensions");
}

}  // namespace core_internal

template <class S, SetType kType>
using CoreOf = decltype(core_internal::Make(core_internal::Wanted<S, kType>(), std::declval<const SetNumbers&>()));

/// The core that the numbers say; their type is kType.
template <class S, SetType kType>
CoreOf<S, kType> MakeCore(const SetNumbers& set) {
  return core_internal::Make(core_internal::Wanted<S, kType>(), set);
}

/// What `use` makes of the type, its template argument.
/// @tparam kPlace  Where in kSetTypes to look from.
/// Throws std::invalid_argument for a type of another dimension.
template <int L, std::size_t kPlace = 0, class Use>
auto WithType(SetType type, const Use& use) {
  constexpr SetTypeInfo kInfo = kSetTypes[kPlace];
  if constexpr (kInfo.dimension != L) {
    return WithType<L, kPlace + 1>(type, use);
  } else {
    if (type == kInfo.type) return use.template operator()<kInfo.type>();
    if constexpr (kPlace + 1 < kSetTypeCount && kSetTypes[kPlace + 1].dimension == L) {
      return WithType<L, kPlace + 1>(type, use);
    } else {
      core_internal::RefuseType(type, L);
    }
  }
}

/// What `use` makes of the core, which is a template of any core: the radius is not in it.
/// Throws as WithType() does.
template <class S, int L, class Use>
auto WithCore(const SetNumbers& set, const Use& use) {
  return WithType<L>(set.type, [&]<SetType kType> { return use(MakeCore<S, kType>(set)); });
}

}  // namespace dgd_test
