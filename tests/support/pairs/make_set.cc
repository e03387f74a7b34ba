#include "support/pairs/make_set.h"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "dgd/shapes.h"
#include "support/pairs/plain_cores.h"

namespace dgd_test {
namespace {

template <class S, class Core>
typename AnyPair<S, dgd::kDimension<Core>>::Set Rounded(Core core, double radius) {
  return dgd::RoundedSet{Erase(std::move(core)), static_cast<S>(radius)};
}

template <class S, class Core>
auto Mapped(Core core, const SetNumbers& set) {
  return dgd::Transformed(std::move(core), dgd::Matrix3<S>(set.stretch.cast<S>()),
                          dgd::Vector3<S>(set.points.at(0).cast<S>()));
}

[[noreturn]] void RefuseType(SetType type, int dimension) {
  throw std::invalid_argument(std::string("no ") + InfoOf(type).name + " in " + std::to_string(dimension) +
                              " dimensions");
}

template <class S>
typename AnyPair<S, 3>::Set MakeSolid(const SetNumbers& set) {
  const dgd::Vector3<S> lengths = set.lengths.cast<S>();
  const auto point = [&set](std::size_t i) -> dgd::Vector3<S> { return set.points.at(i).cast<S>(); };
  switch (set.type) {
    case SetType::kPoint:
      return Rounded<S>(dgd::Point<S>(), set.radius);
    case SetType::kSegment:  // Half length.
      return Rounded<S>(dgd::Segment<S>(lengths[0]), set.radius);
    case SetType::kTriangle:
      return Rounded<S>(dgd::Triangle<S>(point(0), point(1), point(2)), set.radius);
    case SetType::kBox:  // Half extents.
      return Rounded<S>(dgd::Box<S>(lengths), set.radius);
    case SetType::kCylinder:  // Radius, half height.
      return Rounded<S>(dgd::Cylinder<S>(lengths[0], lengths[1]), set.radius);
    case SetType::kCone:  // Radius, height.
      return Rounded<S>(dgd::Cone<S>(lengths[0], lengths[1]), set.radius);
    case SetType::kFrustum:  // Base radius, top radius, height.
      return Rounded<S>(dgd::Frustum<S>(lengths[0], lengths[1], lengths[2]), set.radius);
    case SetType::kEllipsoid:  // Semi-axes.
      return Rounded<S>(dgd::Ellipsoid<S>(lengths), set.radius);
    case SetType::kPolytope:  // The points' hull.
      return Rounded<S>(dgd::Polytope<S>(set.points), set.radius);
    case SetType::kMesh:  // The points' hull.
      return Rounded<S>(dgd::Mesh<S>(set.points), set.radius);
    case SetType::kDsf:
      return Rounded<S>(dgd::Dsf<S>(set.points, set.exponent), set.radius);
    case SetType::kAffineBox:  // Half extents, map, offset.
      return Rounded<S>(Mapped<S>(dgd::Box<S>(lengths), set), set.radius);
    case SetType::kAffineCylinder:  // Radius, half height, map, offset.
      return Rounded<S>(Mapped<S>(dgd::Cylinder<S>(lengths[0], lengths[1]), set), set.radius);
    case SetType::kPlainBox:  // Half extents.
      return Rounded<S>(PlainBox<S>(lengths), set.radius);
    case SetType::kSuperellipsoid:  // Semi-axes.
      return Rounded<S>(Superellipsoid<S, 3>(lengths, set.exponent), set.radius);
    default:
      RefuseType(set.type, 3);
  }
}

template <class S>
typename AnyPair<S, 2>::Set MakeFlat(const SetNumbers& set) {
  const dgd::Vector2<S> lengths = set.lengths.head<2>().cast<S>();
  switch (set.type) {
    case SetType::kCircle:
      return Rounded<S>(dgd::Point<S, 2>(), set.radius);
    case SetType::kStadium:  // Half length.
      return Rounded<S>(dgd::Segment<S, 2>(lengths[0]), set.radius);
    case SetType::kRectangle:  // Half extents.
      return Rounded<S>(dgd::Box<S, 2>(lengths), set.radius);
    case SetType::kEllipse:  // Semi-axes.
      return Rounded<S>(dgd::Ellipsoid<S, 2>(lengths), set.radius);
    case SetType::kPolygon: {  // The points' hull.
      std::vector<Eigen::Vector2d> points;
      for (const Eigen::Vector3d& point : set.points) points.push_back(point.head<2>());
      return Rounded<S>(dgd::Polygon<S>(points), set.radius);
    }
    case SetType::kSuperellipse:  // Semi-axes.
      return Rounded<S>(Superellipsoid<S, 2>(lengths, set.exponent), set.radius);
    default:
      RefuseType(set.type, 2);
  }
}

}  // namespace

template <class S, int L>
typename AnyPair<S, L>::Set MakeSet(const SetNumbers& set) {
  if constexpr (L == 2) {
    return MakeFlat<S>(set);
  } else {
    return MakeSolid<S>(set);
  }
}

template AnyPair<double, 3>::Set MakeSet<double, 3>(const SetNumbers& set);
template AnyPair<float, 3>::Set MakeSet<float, 3>(const SetNumbers& set);
template AnyPair<double, 2>::Set MakeSet<double, 2>(const SetNumbers& set);
template AnyPair<float, 2>::Set MakeSet<float, 2>(const SetNumbers& set);

}  // namespace dgd_test
