#include "bench/peers/bullet_peers.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btMprPenetration.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <type_traits>
#include <utility>

#include "bench/stopwatch.h"
#include "simulation/bullet_math.h"

namespace dgd_bench {
namespace {

using dgd_demos::FromBullet;
using dgd_demos::ToBullet;
using dgd_test::SetNumbers;
using dgd_test::SetType;

/// Of the geometry core + ball(radius) as GJK sees it; null for what Bullet has no shape for. Boxes and cylinders keep
/// their size as their margin grows.
std::unique_ptr<btConvexShape> MakeShape(const SetNumbers& set) {
  const auto& lengths = set.lengths;
  const btScalar radius = ToBullet(set.radius);
  std::unique_ptr<btConvexShape> shape;
  switch (set.type) {
    case SetType::kPoint:
      return std::make_unique<btSphereShape>(radius);
    case SetType::kSegment:
      return std::make_unique<btCapsuleShapeZ>(radius, ToBullet(2 * lengths[0]));
    case SetType::kTriangle:
      shape =
          std::make_unique<btTriangleShape>(ToBullet(set.points[0]), ToBullet(set.points[1]), ToBullet(set.points[2]));
      break;
    case SetType::kBox:
    case SetType::kPlainBox:
      shape = std::make_unique<btBoxShape>(ToBullet(lengths) + btVector3(radius, radius, radius));
      break;
    case SetType::kCylinder:
      shape = std::make_unique<btCylinderShapeZ>(
          btVector3(ToBullet(lengths[0]) + radius, ToBullet(lengths[0]) + radius, ToBullet(lengths[1]) + radius));
      break;
    case SetType::kCone:
      shape = std::make_unique<btConeShapeZ>(ToBullet(lengths[0]), ToBullet(lengths[1]));
      break;
    case SetType::kPolytope:
    case SetType::kMesh: {
      auto hull = std::make_unique<btConvexHullShape>();
      constexpr bool kUpdateBoundingBox = false;  // At every point; once is enough.
      for (const Eigen::Vector3d& point : set.points) hull->addPoint(ToBullet(point), kUpdateBoundingBox);
      hull->recalcLocalAabb();
      shape = std::move(hull);
      break;
    }
    default:
      return nullptr;
  }
  shape->setMargin(radius);
  return shape;
}

btTransform ToTransform(const dgd_test::PoseNumbers& pose) {
  return ToBullet(dgd_demos::Pose{pose.rotation, pose.translation});
}

/// The shapes in their poses, and a way to ask.
class BulletPeer : public Peer {
 public:
  BulletPeer(std::unique_ptr<btConvexShape> shape_1, std::unique_ptr<btConvexShape> shape_2)
      : shape_1_(std::move(shape_1)), shape_2_(std::move(shape_2)) {}

  void MoveTo(const PairTurn& turn) override {
    pose_1_ = ToTransform(turn.pose_1);
    pose_2_ = ToTransform(turn.pose_2);
  }

 protected:
  std::unique_ptr<btConvexShape> shape_1_, shape_2_;
  btTransform pose_1_, pose_2_;
};

/// The last contact; Bullet reports one or none.
struct LastContact : btDiscreteCollisionDetectorInterface::Result {
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3& point_on_b, btScalar depth) override {
    is_missing = false;
    normal_b_to_a = normal_on_b;
    on_b = point_on_b;
    separation = depth;
  }

  bool is_missing = true;
  btVector3 normal_b_to_a{0, 0, 0}, on_b{0, 0, 0};
  btScalar separation = 0;
};

class GjkEpa : public BulletPeer {
 public:
  using BulletPeer::BulletPeer;

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Detect()); });
  }

  std::optional<SeparationAnswer> Ask() const override {
    const LastContact contact = Detect();
    if (contact.is_missing) return std::nullopt;
    const Eigen::Vector3d normal = -FromBullet(contact.normal_b_to_a), on_2 = FromBullet(contact.on_b);
    const double separation = double(contact.separation);
    return SeparationAnswer{normal.stableNormalized(), separation, on_2 - separation * normal, on_2};
  }

 private:
  LastContact Detect() const {
    btVoronoiSimplexSolver simplex_solver;
    btGjkPairDetector detector(shape_1_.get(), shape_2_.get(), &simplex_solver, &penetration_solver_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = pose_1_;
    input.m_transformB = pose_2_;
    LastContact contact;
    detector.getClosestPoints(input, contact, nullptr);
    return contact;
  }

  mutable btGjkEpaPenetrationDepthSolver penetration_solver_;  // Stateless, but not const in Bullet.
};

/// What btComputeMprPenetration() asks of a shape.
class MprShape {
 public:
  MprShape(const btConvexShape& shape, const btTransform& pose) : shape_(shape), pose_(pose) {}

  btVector3 getLocalSupportWithMargin(const btVector3& direction) const {
    return shape_.localGetSupportingVertex(direction);
  }
  btVector3 getLocalSupportWithoutMargin(const btVector3& direction) const {
    return shape_.localGetSupportVertexWithoutMarginNonVirtual(direction);
  }
  btVector3 getObjectCenterInWorld() const { return pose_.getOrigin(); }
  const btTransform& getWorldTransform() const { return pose_; }
  btScalar getMargin() const { return shape_.getMarginNonVirtual(); }

 private:
  const btConvexShape& shape_;
  const btTransform& pose_;
};

class Mpr : public BulletPeer {
 public:
  using BulletPeer::BulletPeer;

  double Time(int repeats) const override {
    return MeanMicroseconds(repeats, [this] { Keep(Detect()); });
  }

  std::optional<SeparationAnswer> Ask() const override {
    const std::optional<btMprDistanceInfo> info = Detect();
    if (!info) return std::nullopt;
    return SeparationAnswer{-FromBullet(info->m_normalBtoA).stableNormalized(), double(info->m_distance),
                            FromBullet(info->m_pointOnA), FromBullet(info->m_pointOnB)};
  }

 private:
  std::optional<btMprDistanceInfo> Detect() const {
    btMprCollisionDescription description;
    btMprDistanceInfo info;
    const int failure =
        btComputeMprPenetration(MprShape(*shape_1_, pose_1_), MprShape(*shape_2_, pose_2_), description, &info);
    if (failure != 0) return std::nullopt;
    return info;
  }
};

template <class Solver>
std::unique_ptr<Peer> MakeSolver(const SetNumbers& set_1, const SetNumbers& set_2) {
  auto shape_1 = MakeShape(set_1), shape_2 = MakeShape(set_2);
  if (shape_1 == nullptr || shape_2 == nullptr) return nullptr;
  return std::make_unique<Solver>(std::move(shape_1), std::move(shape_2));
}

}  // namespace

const char* BulletPrecision() { return std::is_same_v<btScalar, double> ? "double" : "float"; }

std::unique_ptr<Peer> MakeBulletGjkEpa(const SetNumbers& set_1, const SetNumbers& set_2) {
  return MakeSolver<GjkEpa>(set_1, set_2);
}

std::unique_ptr<Peer> MakeBulletMpr(const SetNumbers& set_1, const SetNumbers& set_2) {
  return MakeSolver<Mpr>(set_1, set_2);
}

}  // namespace dgd_bench
