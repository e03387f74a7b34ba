#include "motion/convex_body.h"

#include <dgd/shapes.h>

#include <utility>

#include "scene/overloaded.h"

namespace dgd_demos {
namespace {

dgd::AnySet MakeSet(const Shape& shape, const dgd::Polytope<double>* polytope) {
  return std::visit(
      Overloaded{
          [](const Sphere& sphere) -> dgd::AnySet { return dgd::Sphere(sphere.radius); },
          [](const Capsule& capsule) -> dgd::AnySet { return dgd::Capsule(capsule.radius, capsule.length / 2); },
          [](const Box& box) -> dgd::AnySet { return dgd::RoundedSet{dgd::Box<double>(box.half_extents)}; },
          [](const Cylinder& cylinder) -> dgd::AnySet {
            return dgd::RoundedSet{dgd::Cylinder<double>(cylinder.radius, cylinder.height / 2)};
          },
          [](const Cone& cone) -> dgd::AnySet { return dgd::RoundedSet{dgd::Cone<double>(cone.radius, cone.height)}; },
          [=](const Hull&) -> dgd::AnySet {
            return dgd::RoundedSet{dgd::CoreReference<dgd::Polytope<double>>(*polytope)};
          }},
      shape);
}

std::unique_ptr<dgd::Polytope<double>> MakePolytope(const Shape& shape) {
  const auto* hull = std::get_if<Hull>(&shape);
  return hull == nullptr ? nullptr : std::make_unique<dgd::Polytope<double>>(hull->polyhedron.vertices);
}

}  // namespace

ConvexBody::ConvexBody(std::string name, const Shape& shape)
    : name_(std::move(name)), shape_(shape), polytope_(MakePolytope(shape)), set_(MakeSet(shape, polytope_.get())) {
  radius_ = set_.Radius();
  if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    kind_ = Kind::kSegment;
    half_extents_.z() = capsule->length / 2;
  } else if (std::holds_alternative<Sphere>(shape)) {
    kind_ = Kind::kSegment;  // Of length 0.
  } else if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    kind_ = Kind::kCylinder;
    half_extents_ = {cylinder->radius, cylinder->radius, cylinder->height / 2};
  } else if (const auto* box = std::get_if<Box>(&shape)) {
    kind_ = Kind::kBox;
    half_extents_ = box->half_extents;
  } else if (polytope_ != nullptr) {
    kind_ = Kind::kHull;
  }
}

}  // namespace dgd_demos
