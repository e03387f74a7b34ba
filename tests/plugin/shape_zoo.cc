#include "plugin/shape_zoo.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btConvexPointCloudShape.h>
#include <BulletCollision/CollisionShapes/btConvexTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btMinkowskiSumShape.h>
#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTetrahedronShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>

#include <cmath>

#include "plugin/bullet_oracle.h"

namespace dgd_test {
namespace {

/// Builds the shapes one by one; `u` is the size of all.
class Zookeeper {
 public:
  explicit Zookeeper(double size) : u_(btScalar(size)) {}

  std::vector<ZooShape> Build() {
    AddRound();
    AddHulls();
    AddOthers();
    return std::move(zoo_);
  }

 private:
  template <class Shape>
  Shape& Add(const char* name, std::shared_ptr<Shape> shape, bool is_smooth = false) {
    zoo_.push_back({name, {}, shape, is_smooth});
    return *shape;
  }
  template <class Shape, class... Arguments>
  Shape& Make(const char* name, bool is_smooth, Arguments&&... arguments) {
    return Add(name, std::make_shared<Shape>(std::forward<Arguments>(arguments)...), is_smooth);
  }
  btVector3 Vec(double x, double y, double z) const { return u_ * btVector3(btScalar(x), btScalar(y), btScalar(z)); }
  btScalar Len(double length) const { return u_ * btScalar(length); }
  void KeepAlive(std::shared_ptr<void> resource) { zoo_.back().kept_alive.push_back(std::move(resource)); }

  void AddRound() {
    Make<btBoxShape>("Box", false, Vec(0.5, 0.3, 0.4));
    Make<btBoxShape>("BoxZeroMargin", false, Vec(0.3, 0.4, 0.2)).setMargin(0);
    Make<btSphereShape>("Sphere", false, Len(0.4));
    Make<btCapsuleShapeX>("CapsuleX", false, Len(0.2), Len(0.7));
    Make<btCapsuleShape>("CapsuleY", false, Len(0.3), Len(0.5));
    Make<btCapsuleShapeZ>("CapsuleZ", false, Len(0.15), Len(0.9));
    Make<btCylinderShapeX>("CylinderX", true, Vec(0.3, 0.5, 0.5));
    Make<btCylinderShape>("CylinderY", true, Vec(0.3, 0.5, 0.3));
    Make<btCylinderShapeZ>("CylinderZ", true, Vec(0.5, 0.5, 0.2));
    Make<btConeShapeX>("ConeX", true, Len(0.4), Len(0.6)).setMargin(Len(0.04));
    Make<btConeShape>("ConeY", true, Len(0.3), Len(0.9)).setMargin(Len(0.02));
    Make<btConeShapeZ>("ConeZ", true, Len(0.5), Len(0.5)).setMargin(Len(0.04));
  }

  void AddHulls() {
    Random random(7);
    Add("Hull", MakeRandomHull(random, 14, double(u_))).setMargin(Len(0.04));
    Add("HullZeroMargin", MakeRandomHull(random, 20, double(u_))).setMargin(0);
    auto& stretched = Add("HullStretched", MakeRandomHull(random, 10, double(u_)));
    stretched.setLocalScaling(btVector3(btScalar(0.4), btScalar(1.5), 1));
    stretched.setMargin(Len(0.03));
    auto& mirrored = Add("HullMirrored", MakeRandomHull(random, 12, double(u_)));
    mirrored.setLocalScaling(btVector3(-1, btScalar(0.6), btScalar(-1.3)));
    mirrored.setMargin(Len(0.03));
    Add("HullLarge", MakeRandomHull(random, 150, double(u_))).setMargin(Len(0.02));
    Add("HullPrism", MakePrism(6, 0.4 * double(u_), 0.3 * double(u_))).setMargin(Len(0.03));
    AddPointCloud();
    Make<btBU_Simplex1to4>("Tetrahedron", false, Vec(0.6, 0, -0.2), Vec(-0.3, 0.5, -0.2), Vec(-0.3, -0.5, -0.2),
                           Vec(0.1, 0, 0.5))
        .setMargin(Len(0.03));
    AddTriangleMesh();
    Make<btTriangleShape>("Triangle", false, Vec(0.6, 0, 0.1), Vec(-0.4, 0.5, 0), Vec(-0.3, -0.6, 0))
        .setMargin(Len(0.04));
  }

  void AddOthers() {
    const btVector3 positions[3] = {Vec(0.3, 0, 0), Vec(-0.2, 0.2, 0), Vec(0, -0.1, 0.3)};
    const btScalar equal[3] = {Len(0.2), Len(0.2), Len(0.2)};
    const btScalar unequal[3] = {Len(0.3), Len(0.15), Len(0.2)};
    Make<btMultiSphereShape>("MultiSphereEqual", true, positions, equal, 3).setMargin(Len(0.04));
    Make<btMultiSphereShape>("MultiSphereUnequal", true, positions, unequal, 3).setMargin(Len(0.04));

    auto child = std::make_shared<btConeShape>(Len(0.3), Len(0.5));
    child->setMargin(Len(0.03));
    Make<btUniformScalingShape>("UniformScaling", true, child.get(), btScalar(1.4));
    KeepAlive(child);

    auto first = std::make_shared<btBoxShape>(Vec(0.2, 0.3, 0.1));
    auto second = std::make_shared<btSphereShape>(Len(0.2));
    auto& sum = Make<btMinkowskiSumShape>("MinkowskiSum", false, first.get(), second.get());
    btTransform shift = btTransform::getIdentity();
    shift.setOrigin(Vec(0.1, 0, 0));
    sum.setTransformB(shift);
    KeepAlive(first);
    KeepAlive(second);

    Make<Ellipsoid>("CustomConvex", true, Vec(0.5, 0.3, 0.2)).setMargin(Len(0.04));
  }

  void AddPointCloud() {
    Random random(11);
    auto points = std::make_shared<std::vector<btVector3>>();
    for (int i = 0; i < 18; ++i) points->push_back(ToBullet(0.5 * double(u_) * random.UnitVector()));
    Make<btConvexPointCloudShape>("PointCloud", false, points->data(), static_cast<int>(points->size()),
                                  btVector3(1, btScalar(0.7), btScalar(1.2)))
        .setMargin(Len(0.04));
    KeepAlive(points);
  }

  void AddTriangleMesh() {
    // An octahedron, irregular, around a point away from the origin.
    auto mesh = std::make_shared<btTriangleMesh>();
    const btVector3 top = Vec(0.2, 0.1, 0.6), bottom = Vec(0.1, 0, -0.3);
    const btVector3 belt[4] = {Vec(0.6, 0, 0), Vec(0.1, 0.5, 0.1), Vec(-0.4, 0, 0), Vec(0, -0.4, 0)};
    for (int i = 0; i < 4; ++i) {
      mesh->addTriangle(top, belt[i], belt[(i + 1) % 4]);
      mesh->addTriangle(bottom, belt[(i + 1) % 4], belt[i]);
    }
    Make<btConvexTriangleMeshShape>("ConvexTriangleMesh", false, mesh.get(), true).setMargin(Len(0.04));
    KeepAlive(mesh);
  }

  btScalar u_;
  std::vector<ZooShape> zoo_;
};

}  // namespace

std::vector<ZooShape> MakeShapeZoo(double size) { return Zookeeper(size).Build(); }

const std::vector<std::string>& ShapeZooNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const ZooShape& shape : MakeShapeZoo(1)) all.push_back(shape.name);
    return all;
  }();
  return names;
}

std::shared_ptr<btConvexHullShape> MakeRandomHull(Random& random, int count, double diameter) {
  auto hull = std::make_shared<btConvexHullShape>();
  for (int i = 0; i < count; ++i) {
    hull->addPoint(ToBullet(diameter / 2 * random.Uniform(0.7, 1) * random.UnitVector()), false);
  }
  hull->recalcLocalAabb();
  return hull;
}

std::shared_ptr<btConvexHullShape> MakePrism(int sides, double radius, double half_height) {
  constexpr double kTurn = 6.283185307179586;
  auto hull = std::make_shared<btConvexHullShape>();
  for (int i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    for (const double z : {-half_height, half_height}) hull->addPoint(ToBullet({x, y, z}), false);
  }
  hull->recalcLocalAabb();
  return hull;
}

Ellipsoid::Ellipsoid(const btVector3& half_axes) : half_axes_(half_axes) { m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE; }

btVector3 Ellipsoid::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  const btVector3 scaled = half_axes_ * direction;
  const btScalar length = scaled.length();
  return length > 0 ? half_axes_ * scaled / length : btVector3(half_axes_.x(), 0, 0);
}

void Ellipsoid::batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* supports,
                                                                  int count) const {
  for (int i = 0; i < count; ++i) supports[i] = localGetSupportingVertexWithoutMargin(directions[i]);
}

void Ellipsoid::calculateLocalInertia(btScalar mass, btVector3& inertia) const {
  const btVector3 squares = half_axes_ * half_axes_;
  inertia = mass / 5 * btVector3(squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y());
}

}  // namespace dgd_test
