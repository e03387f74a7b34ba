// Sweeps through Bullet's interfaces: a cast of two shapes, and an algorithm's time of impact.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd_bullet/convex_cast.h"
#include "plugin/pair_query.h"
#include "plugin/shape_zoo.h"
#include "plugin/test_world.h"

namespace dgd_test {
namespace {

/// Of fractions: the rounding of Bullet's poses, and the tolerance of the sweep.
constexpr double kFraction = sizeof(btScalar) == 8 ? 1e-9 : 1e-6;

btTransform Turned(double angle, const Vector& axis, const Vector& at) {
  return MakeTransform(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), at);
}

TEST(ConvexCast, BallOntoBox_StopsWhereItTouches) {
  btSphereShape ball(btScalar(0.5));
  btBoxShape box(Vec(1, 1, 1));
  dgd_bullet::ConvexCast cast(&ball, &box);
  btConvexCast::CastResult result;
  ASSERT_TRUE(cast.calcTimeOfImpact(At(0.2, 0, 4), At(0.2, 0, 0), At(0, 0, 0), At(0, 0, 0), result));
  EXPECT_NEAR(double(result.m_fraction), 2.5 / 4, kFraction);
  EXPECT_LE(double(result.m_fraction), 2.5 / 4);
  EXPECT_NEAR((ToEigen(result.m_normal) - Vector::UnitZ()).norm(), 0, 1e-6);
  EXPECT_NEAR((ToEigen(result.m_hitPoint) - Vector(0.2, 0, 1)).norm(), 0, 1e-6);
}

TEST(ConvexCast, Miss_SaysSoAndLeavesTheResult) {
  btSphereShape ball(btScalar(0.5));
  btBoxShape box(Vec(1, 1, 1));
  dgd_bullet::ConvexCast cast(&ball, &box);
  btConvexCast::CastResult result;
  const btScalar fraction = result.m_fraction;
  EXPECT_FALSE(cast.calcTimeOfImpact(At(1.501, 0, 4), At(1.501, 0, -4), At(0, 0, 0), At(0, 0, 0), result));
  EXPECT_EQ(result.m_fraction, fraction);
}

TEST(ConvexCast, BothTurnAndMove_AsTheIntegratorWould) {
  // A rod that turns by a quarter about z meets a ball; both move with the same carrier.
  btCapsuleShapeX rod(btScalar(0.1), 2);
  btSphereShape ball(btScalar(0.2));
  dgd_bullet::ConvexCast cast(&rod, &ball);
  btConvexCast::CastResult result;
  const double radius = 0.8;
  const Vector way(3, -2, 1);
  ASSERT_TRUE(cast.calcTimeOfImpact(At(0, 0, 0), Turned(std::numbers::pi / 2, {0, 0, 1}, way), At(0, radius, 0),
                                    At(way.x(), way.y() + radius, way.z()), result));
  const double impact = std::numbers::pi / 2 - std::asin(0.3 / radius);
  EXPECT_NEAR(double(result.m_fraction), impact / (std::numbers::pi / 2), kFraction);
}

TEST(ConvexCast, ShapesThatTouch_MeetOnlyIfTheyApproach) {
  btBoxShape box(Vec(0.5, 0.5, 0.5));
  dgd_bullet::ConvexCast cast(&box, &box);
  btConvexCast::CastResult result;
  const btTransform still = At(0, 0, 0), touching = At(0, 0, 1);
  EXPECT_FALSE(cast.calcTimeOfImpact(touching, At(0, 0, 2), still, still, result));
  ASSERT_TRUE(cast.calcTimeOfImpact(touching, At(0, 0, 0.5), still, still, result));
  EXPECT_EQ(result.m_fraction, btScalar(0));
}

TEST(ConvexCast, BadInput_IsNoHit) {
  btSphereShape ball(btScalar(0.5));
  btConvexHullShape empty;
  btConvexCast::CastResult result;
  dgd_bullet::ConvexCast of_nothing(&ball, &empty);
  EXPECT_FALSE(of_nothing.calcTimeOfImpact(At(0, 0, 4), At(0, 0, 0), At(0, 0, 0), At(0, 0, 0), result));
  dgd_bullet::ConvexCast of_balls(&ball, &ball);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(of_balls.calcTimeOfImpact(At(0, 0, 4), At(0, nan, 0), At(0, 0, 0), At(0, 0, 0), result));
}

/// Of two shapes in poses on the way, by the certified planes of Bullet's own support functions.
double DistanceAt(const btConvexShape& a, const btTransform& pose_a, const btConvexShape& b,
                  const btTransform& pose_b) {
  return DistanceOfShapes({a, pose_a}, {b, pose_b}).value;
}

/// In double, whatever Bullet's precision: its integrator, which takes quaternions of that, is off by more than the
/// sweep.
btTransform Between(const btTransform& from, const btTransform& to, double part) {
  const auto matrix = [](const btTransform& pose) {
    Eigen::Matrix3d rotation;
    for (int row = 0; row < 3; ++row) rotation.row(row) = ToEigen(pose.getBasis()[row]).transpose();
    return rotation;
  };
  const Eigen::AngleAxisd turn(matrix(to) * matrix(from).transpose());
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(part * turn.angle(), turn.axis()) * matrix(from);
  const Vector way = ToEigen(to.getOrigin()) - ToEigen(from.getOrigin());
  return MakeTransform(rotation, ToEigen(from.getOrigin()) + part * way);
}

TEST(ConvexCast, ZooOfShapes_NeverLateAndAtMostATouchEarly) {
  const std::vector<ZooShape> zoo = MakeShapeZoo(0.5);
  const double length = sizeof(btScalar) == 8 ? 1e-7 : 2e-5;
  Random random(TestSeed());
  int hits = 0, misses = 0;
  for (const ZooShape& a : zoo) {
    for (const ZooShape& b : zoo) {
      SCOPED_TRACE(a.name + " and " + b.name);
      const btTransform from_a = MakeTransform(random.Rotation(), {0, 0, 0});
      const btTransform to_a = MakeTransform(random.Rotation(), {0, 0, 0});
      const btTransform from_b = MakeTransform(random.Rotation(), 1.5 * random.UnitVector());
      const Vector way = -random.Uniform(0.5, 2) * ToEigen(from_b.getOrigin()) + 0.4 * random.UnitVector();
      btTransform to_b = from_b;
      to_b.setOrigin(from_b.getOrigin() + ToBullet(way));
      dgd_bullet::ConvexCast cast(a.shape.get(), b.shape.get());
      btConvexCast::CastResult result;
      const bool hit = cast.calcTimeOfImpact(from_a, to_a, from_b, to_b, result);
      (hit ? hits : misses) += 1;
      const double end = hit ? double(result.m_fraction) : 1;
      constexpr int kSteps = 20;
      for (int i = 0; i <= kSteps; ++i) {
        const double part = end * i / kSteps;
        const double distance =
            DistanceAt(*a.shape, Between(from_a, to_a, part), *b.shape, Between(from_b, to_b, part));
        EXPECT_GE(distance, -length) << "at " << part;
        if (hit && i == kSteps) {
          EXPECT_LE(distance, length);
        }
      }
    }
  }
  EXPECT_GT(hits, int(zoo.size() * zoo.size() / 5));
  EXPECT_GT(misses, int(zoo.size() * zoo.size() / 10));
}

TEST(ConvexCast, BuiltinsFraction_IsTheSameOrNearlySo) {
  btBoxShape box(Vec(0.4, 0.3, 0.2));
  btConeShape cone(btScalar(0.3), btScalar(0.6));
  Random random(TestSeed());
  int hits = 0;
  for (int i = 0; i < 100; ++i) {
    const btTransform from_a = MakeTransform(random.Rotation(), {0, 0, 0});
    const btTransform from_b = MakeTransform(random.Rotation(), 1.5 * random.UnitVector());
    btTransform to_b = from_b;
    to_b.setOrigin(-from_b.getOrigin());
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver penetration;
    btContinuousConvexCollision builtin(&box, &cone, &simplex, &penetration);
    dgd_bullet::ConvexCast ours(&box, &cone);
    btConvexCast::CastResult theirs, result;
    ASSERT_TRUE(ours.calcTimeOfImpact(from_a, from_a, from_b, to_b, result));
    if (!builtin.calcTimeOfImpact(from_a, from_a, from_b, to_b, theirs)) continue;
    ++hits;
    // It stops a millimetre off.
    EXPECT_NEAR(double(result.m_fraction), double(theirs.m_fraction), 0.01);
  }
  EXPECT_GE(hits, 90);
}

class TimeOfImpact : public testing::Test {
 protected:
  TimeOfImpact() { query_.SetPoses(At(0, 0, 3), At(0, 0, 0)); }

  void MoveA(const btTransform& to) { query_.body_a().setInterpolationWorldTransform(to); }
  double Ask() {
    query_.Step();
    btManifoldResult output;
    return double(
        query_.algorithm()->calculateTimeOfImpact(&query_.body_a(), &query_.body_b(), btDispatcherInfo(), &output));
  }

  Dispatching dispatching_{Route::kConfiguration};
  btSphereShape ball_{btScalar(0.5)};
  btBoxShape box_{Vec(0.5, 0.5, 0.5)};
  PairQuery query_{dispatching_.dispatcher(), ball_, box_};
};

TEST_F(TimeOfImpact, OfTheBodiesWays_AlsoAsTheirHitFractions) {
  query_.body_b().setInterpolationWorldTransform(At(0, 0, 0));
  MoveA(At(0, 0, -1));
  EXPECT_NEAR(Ask(), 0.5, kFraction);
  EXPECT_NEAR(double(query_.body_a().getHitFraction()), 0.5, kFraction);
  EXPECT_NEAR(double(query_.body_b().getHitFraction()), 0.5, kFraction);
}

TEST_F(TimeOfImpact, NoImpact_IsOne) {
  query_.body_b().setInterpolationWorldTransform(At(0, 0, 0));
  MoveA(At(0, 0, 1.01));
  EXPECT_EQ(Ask(), 1);
  EXPECT_EQ(double(query_.body_a().getHitFraction()), 1);
}

TEST_F(TimeOfImpact, BelowTheMotionThresholds_IsNotAsked) {
  query_.body_b().setInterpolationWorldTransform(At(0, 0, 0));
  query_.body_a().setCcdMotionThreshold(5);
  query_.body_b().setCcdMotionThreshold(5);
  MoveA(At(0, 0, -1));
  EXPECT_EQ(Ask(), 1);
  query_.body_a().setCcdMotionThreshold(3);
  EXPECT_LT(Ask(), 1);
}

TEST_F(TimeOfImpact, OfACompoundsChild_IsNotKnown) {
  query_.body_b().setInterpolationWorldTransform(At(0, 0, 0));
  MoveA(At(0, 0, -1));
  ASSERT_LT(Ask(), 1);
  btCompoundShape compound;
  compound.addChildShape(At(0, 0, 0), &ball_);
  query_.body_a().setCollisionShape(&compound);
  btManifoldResult output;
  EXPECT_EQ(query_.algorithm()->calculateTimeOfImpact(&query_.body_a(), &query_.body_b(), btDispatcherInfo(), &output),
            btScalar(1));
  query_.body_a().setCollisionShape(&ball_);
}

TEST_F(TimeOfImpact, InADispatchOfContinuousKind_ReachesTheApp) {
  query_.body_b().setInterpolationWorldTransform(At(0, 0, 0));
  MoveA(At(0, 0, -1));
  btDispatcherInfo info;
  info.m_dispatchFunc = btDispatcherInfo::DISPATCH_CONTINUOUS;
  info.m_timeOfImpact = 1;
  btBroadphaseProxy proxy_a, proxy_b;
  proxy_a.m_clientObject = &query_.body_a();
  proxy_a.m_uniqueId = 1;
  proxy_b.m_clientObject = &query_.body_b();
  proxy_b.m_uniqueId = 2;
  btBroadphasePair pair(proxy_a, proxy_b);
  dispatching_.dispatcher().defaultNearCallback(pair, dispatching_.dispatcher(), info);
  EXPECT_NEAR(double(info.m_timeOfImpact), 0.5, kFraction);
  pair.m_algorithm->~btCollisionAlgorithm();
  dispatching_.dispatcher().freeCollisionAlgorithm(pair.m_algorithm);
}

}  // namespace
}  // namespace dgd_test
