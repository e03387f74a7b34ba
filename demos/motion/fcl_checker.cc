#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <vector>

#include "motion/pair_checker.h"
#include "scene/overloaded.h"

namespace dgd_demos {
namespace {

using Geometry = std::unique_ptr<fcl::CollisionGeometryd>;

Geometry MakeConvex(const Polyhedron& polyhedron) {
  const auto faces = std::make_shared<std::vector<int>>();
  for (const Polyhedron::Face& face : polyhedron.faces) {
    faces->push_back(3);
    faces->insert(faces->end(), face.vertices.begin(), face.vertices.end());
  }
  return std::make_unique<fcl::Convexd>(std::make_shared<std::vector<Eigen::Vector3d>>(polyhedron.vertices),
                                        static_cast<int>(polyhedron.faces.size()), faces);
}

Geometry MakeGeometry(const Shape& shape) {
  return std::visit(
      Overloaded{[](const Sphere& sphere) -> Geometry { return std::make_unique<fcl::Sphered>(sphere.radius); },
                 [](const Capsule& capsule) -> Geometry {
                   return std::make_unique<fcl::Capsuled>(capsule.radius, capsule.length);
                 },
                 [](const Box& box) -> Geometry { return std::make_unique<fcl::Boxd>(2 * box.half_extents); },
                 [](const Cylinder& cylinder) -> Geometry {
                   return std::make_unique<fcl::Cylinderd>(cylinder.radius, cylinder.height);
                 },
                 [](const Cone& cone) -> Geometry { return std::make_unique<fcl::Coned>(cone.radius, cone.height); },
                 [](const Hull& hull) { return MakeConvex(hull.polyhedron); }},
      shape);
}

class FclChecker : public PairChecker {
 public:
  explicit FclChecker(const CollisionModel& model) : model_(model), transforms_(model.parts().size()) {
    for (const CollisionModel::Part& part : model.parts()) geometries_.push_back(MakeGeometry(part.body.shape()));
  }

  std::string Name() const override { return "FCL collide"; }

  void SetPoses(const CollisionModel::Poses& poses) override {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      transforms_[i].linear() = poses[i].rotation;
      transforms_[i].translation() = poses[i].translation;
    }
  }

  bool Collides(std::size_t pair) override {
    const auto [first, second] = model_.pairs()[pair];
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(geometries_[first].get(), transforms_[first], geometries_[second].get(), transforms_[second],
                        request, result) > 0;
  }

 private:
  const CollisionModel& model_;
  std::vector<Geometry> geometries_;
  std::vector<fcl::Transform3d> transforms_;
};

}  // namespace

std::unique_ptr<PairChecker> MakeFclChecker(const CollisionModel& model) { return std::make_unique<FclChecker>(model); }

}  // namespace dgd_demos
