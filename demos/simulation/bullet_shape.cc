#include "simulation/bullet_shape.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>

#include "scene/overloaded.h"
#include "simulation/bullet_math.h"

namespace dgd_demos {
namespace {

std::unique_ptr<btConvexShape> MakeHull(const Polyhedron& polyhedron) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Eigen::Vector3d& vertex : polyhedron.vertices) {
    hull->addPoint(ToBullet(vertex), /*recalculateLocalAabb=*/false);
  }
  hull->recalcLocalAabb();
  return hull;
}

}  // namespace

std::unique_ptr<btConvexShape> MakeBulletShape(const Shape& shape, double margin) {
  std::unique_ptr<btConvexShape> bullet = std::visit(
      Overloaded{[](const Sphere& sphere) -> std::unique_ptr<btConvexShape> {
                   return std::make_unique<btSphereShape>(ToBullet(sphere.radius));
                 },
                 [](const Capsule& capsule) -> std::unique_ptr<btConvexShape> {
                   return std::make_unique<btCapsuleShapeZ>(ToBullet(capsule.radius), ToBullet(capsule.length));
                 },
                 [](const Box& box) -> std::unique_ptr<btConvexShape> {
                   return std::make_unique<btBoxShape>(ToBullet(box.half_extents));
                 },
                 [](const Cylinder& cylinder) -> std::unique_ptr<btConvexShape> {
                   const btScalar radius = ToBullet(cylinder.radius);
                   return std::make_unique<btCylinderShapeZ>(btVector3(radius, radius, ToBullet(cylinder.height / 2)));
                 },
                 [](const Cone& cone) -> std::unique_ptr<btConvexShape> {
                   return std::make_unique<btConeShapeZ>(ToBullet(cone.radius), ToBullet(cone.height));
                 },
                 [](const Hull& hull) { return MakeHull(hull.polyhedron); }},
      shape);
  // Without effect on spheres and capsules, whose radius is their margin. Boxes and cylinders keep their outer size.
  const bool radius_is_margin = std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape);
  if (!radius_is_margin) bullet->setMargin(ToBullet(BulletMargin(shape, margin)));
  return bullet;
}

}  // namespace dgd_demos
