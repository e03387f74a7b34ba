#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "bench/hard_method.h"

namespace dgd_bench {
namespace {

using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;

btVector3 ToBullet(const Vector3d& v) { return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())}; }

btTransform ToBullet(const dgd_test::PoseNumbers& pose) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) basis[row] = ToBullet(Vector3d(pose.rotation.row(row).transpose()));
  return btTransform(basis, ToBullet(pose.translation));
}

std::unique_ptr<btConvexShape> HullOf(const std::vector<Vector3d>& points) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Vector3d& point : points) hull->addPoint(ToBullet(point), false);
  hull->recalcLocalAabb();
  return hull;
}

/// The core about the same origin, in its outer size where the margin is inside of it: so that the margin set after
/// leaves the core as it is. Null for a type that Bullet has not.
std::unique_ptr<btConvexShape> ShapeOf(const SetNumbers& set) {
  const Vector3d rounded = set.lengths + Vector3d::Constant(set.radius);
  switch (set.type) {
    case SetType::kPoint:
      return std::make_unique<btSphereShape>(btScalar(set.radius));
    case SetType::kSegment:
      return HullOf({set.lengths.x() * Vector3d::UnitZ(), -set.lengths.x() * Vector3d::UnitZ()});
    case SetType::kTriangle:
    case SetType::kPolytope:
    case SetType::kMesh:
      return HullOf(set.points);
    case SetType::kBox:
    case SetType::kPlainBox:
      return std::make_unique<btBoxShape>(ToBullet(rounded));
    case SetType::kCylinder:
      return std::make_unique<btCylinderShapeZ>(
          btVector3(btScalar(rounded[0]), btScalar(rounded[0]), btScalar(rounded[1])));
    case SetType::kCone:
      return std::make_unique<btConeShapeZ>(btScalar(set.lengths[0]), btScalar(set.lengths[1]));
    default:
      return nullptr;
  }
}

std::unique_ptr<btConvexShape> RoundedShapeOf(const SetNumbers& set) {
  std::unique_ptr<btConvexShape> shape = ShapeOf(set);
  if (shape != nullptr && set.type != SetType::kPoint) shape->setMargin(btScalar(set.radius));
  return shape;
}

struct LastContact : btDiscreteCollisionDetectorInterface::Result {
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3&, btScalar depth) override {
    answer.distance = double(depth);
    answer.normal = -Vector3d(double(normal_on_b.x()), double(normal_on_b.y()), double(normal_on_b.z()));
  }

  HardAnswer answer;
};

class BulletHardQuery : public HardQuery {
 public:
  BulletHardQuery(std::unique_ptr<btConvexShape> shape_1, std::unique_ptr<btConvexShape> shape_2,
                  const dgd_test::PairNumbers& pair)
      : shape_1_(std::move(shape_1)),
        shape_2_(std::move(shape_2)),
        pose_1_(ToBullet(pair.pose_1)),
        pose_2_(ToBullet(pair.pose_2)) {}

  HardAnswer Ask() const override {
    btVoronoiSimplexSolver simplex_solver;
    btGjkPairDetector detector(shape_1_.get(), shape_2_.get(), &simplex_solver, &penetration_solver_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pose_1_;
    input.m_transformB = pose_2_;
    LastContact contact;
    detector.getClosestPoints(input, contact, nullptr);
    return contact.answer;
  }

 private:
  std::unique_ptr<btConvexShape> shape_1_, shape_2_;
  btTransform pose_1_, pose_2_;
  mutable btGjkEpaPenetrationDepthSolver penetration_solver_;  // Stateless, but not const in Bullet.
};

}  // namespace

bool IsBulletInDouble() { return std::is_same_v<btScalar, double>; }

std::unique_ptr<HardQuery> MakeBulletHardQuery(const dgd_test::PairNumbers& pair) {
  std::unique_ptr<btConvexShape> shape_1 = RoundedShapeOf(pair.set_1), shape_2 = RoundedShapeOf(pair.set_2);
  if (shape_1 == nullptr || shape_2 == nullptr) return nullptr;
  return std::make_unique<BulletHardQuery>(std::move(shape_1), std::move(shape_2), pair);
}

}  // namespace dgd_bench
