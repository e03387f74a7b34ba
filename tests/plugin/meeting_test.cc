// Whether bodies that approach each other meet within the step, and where.
#include "ahead/meeting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plugin/rigid_body.h"

namespace dgd_test {
namespace {

using dgd_bullet::Vector3;

constexpr double kFlush = 1e-5;  // m

dgd_bullet::PosedShape BoxAt(const Vector3& half, const Vector3& place) {
  constexpr double kRadius = 1e-3;
  const Vector3 radii(kRadius, kRadius, kRadius);
  return {dgd::RoundedSet{dgd::Box<double>(half - radii), kRadius}, {Eigen::Matrix3d::Identity(), place}};
}

/// What comes of two bodies within a step.
struct Encounter {
  bool is_meeting;
  dgd_bullet::Contact contact;  // Where they meet.
};

Encounter EncounterOf(dgd_bullet::MovingPair& pair) {
  dgd::WarmStart<double> warm_start;
  const auto plane_between = [&](const dgd_bullet::Pose& pose_a, const dgd_bullet::Pose& pose_b) {
    return dgd::PlaneBetween(pair.a().set, pose_a, pair.b().set, pose_b, warm_start);
  };
  dgd_bullet::Contact contact = plane_between(pair.a().pose, pair.b().pose);
  const bool is_meeting = FindMeeting(pair, contact, kFlush, plane_between);
  EXPECT_TRUE(is_meeting || pair.time() == 1);
  return {is_meeting, contact};
}

/// A tile of 2 m whose top is z = 0, and a box of 50 cm that moves by `way` in the step; `edge` is how far its front is
/// before the tile.
Encounter Encountering(double height, double edge, const Vector3& way) {
  const dgd_bullet::PosedShape tile = BoxAt({1, 1, 1}, {2, 0, -1}),
                               box = BoxAt({0.25, 0.25, 0.25}, {0.75 - edge, 0, 0.25 + height});
  btBoxShape shape(Vec(0.25, 0.25, 0.25));
  const auto still = MakeRigidBody(shape, 0, btTransform::getIdentity());
  const auto moving = MakeRigidBody(shape, 1, btTransform(btQuaternion::getIdentity(), Vec(0.75 - edge, 0, 0.25)));
  moving->setLinearVelocity(Vec(way.x(), way.y(), way.z()));
  const dgd_bullet::PairMotion motion(dgd_bullet::BoundedBody(*still), dgd_bullet::BoundedBody(*moving), 1);
  dgd_bullet::MovingPair pair(tile, box, motion);
  return EncounterOf(pair);
}

TEST(FindMeeting, FlushBox_PassesOntoTheTile) { EXPECT_FALSE(Encountering(-1e-6, 0.05, {0.3, 0, 0}).is_meeting); }

TEST(FindMeeting, LowerBox_MeetsTheTilesSide) {
  const auto side = Encountering(-1e-2, 0.05, {0.3, 0, 0});
  EXPECT_TRUE(side.is_meeting);
  EXPECT_LT(side.contact.normal.x(), -0.99);
}

TEST(FindMeeting, FallingBox_MeetsTheTop) {
  const auto top = Encountering(0.02, 0.05, {0.3, 0, -0.05});
  EXPECT_TRUE(top.is_meeting);
  EXPECT_GT(top.contact.normal.z(), 0.99);
}

TEST(FindMeeting, BoxThatIsHigher_Passes) { EXPECT_FALSE(Encountering(0.02, 0.05, {0.3, 0, 0}).is_meeting); }

TEST(FindMeeting, BoxThatStopsShort_StaysApart) { EXPECT_FALSE(Encountering(-1e-2, 0.05, {0.04, 0, 0}).is_meeting); }

/// A ball above the tile's middle, which moves and spins.
class BallOverTile : public testing::Test {
 protected:
  static constexpr double kRadius = 0.3, kTime = 0.1;  // m, s
  static constexpr double kRoundoff = sizeof(btScalar) == sizeof(double) ? 1e-9 : 1e-6;

  /// The contact where they are at the step's end, as it is at its start. The ball is shape A, or B.
  dgd::ContactPoint<double> AtStart(double height, const Vector3& velocity, const Vector3& spin,
                                    bool is_ball_first = true) {
    start_ = {2, 0, kRadius + height};
    const dgd_bullet::PosedShape tile = BoxAt({1, 1, 1}, {2, 0, -1}),
                                 ball = {dgd::RoundedSet{dgd::Point<double>(), kRadius},
                                         {Eigen::Matrix3d::Identity(), start_}};
    btSphereShape shape{btScalar(kRadius)};
    const auto still = MakeRigidBody(shape, 0, btTransform::getIdentity());
    const auto moving =
        MakeRigidBody(shape, 1, btTransform(btQuaternion::getIdentity(), Vec(start_.x(), start_.y(), start_.z())));
    moving->setLinearVelocity(Vec(velocity.x(), velocity.y(), velocity.z()));
    moving->setAngularVelocity(Vec(spin.x(), spin.y(), spin.z()));
    const dgd_bullet::BoundedBody reach_of_tile(*still), reach_of_ball(*moving);
    const dgd_bullet::PairMotion motion = is_ball_first ? dgd_bullet::PairMotion(reach_of_ball, reach_of_tile, kTime)
                                                        : dgd_bullet::PairMotion(reach_of_tile, reach_of_ball, kTime);
    dgd_bullet::MovingPair pair =
        is_ball_first ? dgd_bullet::MovingPair(ball, tile, motion) : dgd_bullet::MovingPair(tile, ball, motion);
    pair.MoveTo(1);
    const auto contact =
        dgd::SignedDistance(pair.a().set, pair.a().pose, pair.b().set, pair.b().pose, dgd::Settings<double>());
    normal_ = contact.normal;
    dgd::ContactPatch<double> patch;
    patch.size = 1;
    patch.points[0] = {contact.witness_1, contact.witness_2, contact.separation};
    pair.MoveToStart(contact.normal, kFlush, patch);
    return patch.points[0];
  }

  Vector3 start_ = Vector3::Zero();  // The ball's centre.
  Vector3 normal_ = Vector3::Zero();
};

// The point that touches next is below the ball's centre. What has turned to where it will be comes from behind, with
// an arm that would brake the ball.
TEST_F(BallOverTile, SpinningBall_TouchesBelowItsCentre) {
  for (const Vector3& spin : {Vector3(0, 0, 0), Vector3(0, 3, 0), Vector3(-7, 2, 5)}) {
    const dgd::ContactPoint<double> contact = AtStart(1e-3, {0.9, 0.2, 0}, spin);
    const Vector3 below = start_ - kRadius * Vector3::UnitZ();
    EXPECT_LE((contact.on_1 - below).norm(), kRoundoff) << spin.transpose();
    EXPECT_NEAR(contact.on_2.z(), 0, kRoundoff) << "each place is on its own body";
  }
}

TEST_F(BallOverTile, Spin_IsNoApproach) {
  EXPECT_NEAR(AtStart(1e-3, {0.9, 0, 0}, {0, 3, 0}).separation, 1e-3, kRoundoff);
  EXPECT_NEAR(AtStart(1e-3, {0, 0, 0}, {-7, 20, 5}).separation, 1e-3, kRoundoff);
}

TEST_F(BallOverTile, FallingBall_IsAsFarAsItFalls) {
  EXPECT_NEAR(AtStart(0.02, {0.9, 0, -0.15}, {0, 3, 0}).separation, 0.02, kRoundoff);
}

TEST_F(BallOverTile, OtherOrder_SamePlaces) {
  const dgd::ContactPoint<double> contact = AtStart(0.02, {0.9, 0.2, -0.15}, {1, 3, 0});
  const Vector3 normal = normal_;
  const dgd::ContactPoint<double> mirrored = AtStart(0.02, {0.9, 0.2, -0.15}, {1, 3, 0}, false);
  EXPECT_LE((contact.on_1 - mirrored.on_2).norm(), kRoundoff);
  EXPECT_LE((normal + normal_).norm(), kRoundoff);
  EXPECT_NEAR(contact.separation, mirrored.separation, kRoundoff);
}

/// Whether a cube that stands on the tile's edge-to-edge diagonal, its lowest edge 2 mm clear, meets the tile's top as
/// it turns about its own axis by an angle and sinks.
bool TurningCubeMeets(double start, double angle, double sinks) {
  const double radius = 0.2 * std::sqrt(2);
  const dgd_bullet::PosedShape tile = BoxAt({1, 1, 1}, {0, 0, -1});
  dgd_bullet::PosedShape cube = BoxAt({0.2, 0.2, 0.2}, {0, 0, radius + 2e-3});
  cube.pose.rotation = Eigen::AngleAxisd(start, Vector3::UnitY()).toRotationMatrix();
  btBoxShape shape(Vec(0.2, 0.2, 0.2));
  const auto still = MakeRigidBody(shape, 0, btTransform::getIdentity());
  const auto moving =
      MakeRigidBody(shape, 1, btTransform(btQuaternion::getIdentity(), Vec(0, 0, cube.pose.translation.z())));
  moving->setLinearVelocity(Vec(0, 0, -sinks));
  moving->setAngularVelocity(Vec(0, angle, 0));
  const dgd_bullet::PairMotion motion(dgd_bullet::BoundedBody(*moving), dgd_bullet::BoundedBody(*still), 1);
  // Its corner is on its way down as fast as the rim turns: along a straight line it would be far below the top.
  const Vector3 corner = cube.pose * Vector3(0.2, 0, -0.2);
  EXPECT_GT(motion.Approach(corner, -Vector3::UnitZ()), 0.02);
  dgd_bullet::MovingPair pair(cube, tile, motion);
  return EncounterOf(pair).is_meeting;
}

TEST(FindMeeting, CubeThatTurnsClear_DoesNotMeet) {
  for (const double angle : {0.3, 0.8, 1.5}) EXPECT_FALSE(TurningCubeMeets(0.5, angle, 0)) << angle;
}

TEST(FindMeeting, CubeThatSinksAsItTurns_Meets) {
  // At the end of the step, and half way only: a face is down at the end.
  EXPECT_TRUE(TurningCubeMeets(0.5, 0.3, 0.01));
  EXPECT_TRUE(TurningCubeMeets(std::numbers::pi / 8, std::numbers::pi / 4, 0.006));
}

}  // namespace
}  // namespace dgd_test
