// Whether bodies that approach each other meet within the step.
#include "pair_impact.h"

#include <gtest/gtest.h>

#include "pair_distance.h"
#include "pair_solver.h"
#include "plugin/rigid_body.h"

namespace dgd_test {
namespace {

using dgd_bullet::Encounter;
using dgd_bullet::Vector3;

constexpr double kFlush = 1e-5;  // m

dgd_bullet::PosedShape BoxAt(const Vector3& half, const Vector3& place) {
  constexpr double kRadius = 1e-3;
  const Vector3 radii(kRadius, kRadius, kRadius);
  return {dgd::RoundedSet{dgd::Box<double>(half - radii), kRadius}, {Eigen::Matrix3d::Identity(), place}};
}

/// A tile of 2 m whose top is z = 0, and a box of 50 cm that moves by `way` in the step; `edge` is how far its front is
/// before the tile.
dgd_bullet::PredictedEncounter Encountering(double height, double edge, const Vector3& way) {
  const dgd_bullet::PosedShape tile = BoxAt({1, 1, 1}, {2, 0, -1}),
                               box = BoxAt({0.25, 0.25, 0.25}, {0.75 - edge, 0, 0.25 + height});
  btBoxShape shape(Vec(0.25, 0.25, 0.25));
  const auto still = MakeRigidBody(shape, 0, btTransform::getIdentity());
  const auto moving = MakeRigidBody(shape, 1, btTransform(btQuaternion::getIdentity(), Vec(0.75 - edge, 0, 0.25)));
  moving->setLinearVelocity(Vec(way.x(), way.y(), way.z()));
  const dgd_bullet::PairMotion motion(dgd_bullet::BodyReach(*still), dgd_bullet::BodyReach(*moving), 1);

  dgd::Settings<double> settings;
  dgd::WarmStart<double> warm_start;
  dgd::Result<double> result = dgd_bullet::SolvePair(tile, box, settings, warm_start);
  const bool follows = dgd_bullet::TurnToLeastTranslation(tile, box, settings, warm_start, result);
  dgd_bullet::MovingPair pair(tile, box, motion);
  pair.MoveTo(1);
  const double at_end = pair.SeparationAlong(result.normal);
  EXPECT_LT(at_end, -kFlush) << "the plane between them does not keep them apart";
  return PredictEncounter(pair, settings, warm_start, follows, result, at_end, kFlush);
}

TEST(PredictEncounter, FlushBox_PassesOntoTheTile) {
  const auto onto = Encountering(-1e-6, 0.05, {0.3, 0, 0});
  EXPECT_EQ(onto.encounter, Encounter::kPass);
  EXPECT_NEAR(onto.contact.normal.z(), 1, 1e-6) << "along the tile's top";
}

TEST(PredictEncounter, LowerBox_MeetsTheTilesSide) {
  EXPECT_EQ(Encountering(-1e-2, 0.05, {0.3, 0, 0}).encounter, Encounter::kMeet);
}

TEST(PredictEncounter, FallingBox_MeetsTheTopAside) {
  const auto aside = Encountering(0.02, 0.05, {0.3, 0, -0.05});
  EXPECT_EQ(aside.encounter, Encounter::kMeetAside);
  EXPECT_GT(aside.contact.normal.z(), 0.9);
}

TEST(PredictEncounter, BoxThatIsHigher_Passes) {
  EXPECT_EQ(Encountering(0.02, 0.05, {0.3, 0, 0}).encounter, Encounter::kPass);
}

}  // namespace
}  // namespace dgd_test
