// Contract: margins add to the cores' depth and come off their distance; the pruned search over a scene finds what the
// full computation over all pairs finds, step after step.
#include "simulation/penetration_oracle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scene/random.h"
#include "small_scenes.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

RoundedPolyhedron Rounded(const Shape& shape, double margin) {
  return {CoreOf(shape, margin), RoundingRadius(shape, margin)};
}

Pose At(double x, double y, double z) { return {Eigen::Matrix3d::Identity(), Vector3d(x, y, z)}; }

double Depth(const RoundedPolyhedron& a, const RoundedPolyhedron& b, const Pose& pose_b) {
  const double depth = TruePenetration(a, At(0, 0, 0), b, pose_b);
  EXPECT_NEAR(TruePenetration(b, pose_b, a, At(0, 0, 0)), depth, 1e-13);
  return depth;
}

TEST(TruePenetrationTest, Spheres_OverlapByTheirRadii) {
  const RoundedPolyhedron one = Rounded(Sphere{1}, 0.04), half = Rounded(Sphere{0.5}, 0.04);
  EXPECT_NEAR(Depth(one, half, At(1.2, 0, 0)), 0.3, 1e-15);
  EXPECT_EQ(Depth(one, half, At(1.6, 0, 0)), 0);
  EXPECT_NEAR(Depth(one, half, At(0, 0, 0)), 1.5, 1e-15);
}

TEST(TruePenetrationTest, Boxes_KeepTheirOuterSizeWhateverTheMargin) {
  for (const double margin : {0.0, 0.02, 0.04, 0.5}) {
    const RoundedPolyhedron box = Rounded(Box{Vector3d(1, 1, 1)}, margin);
    EXPECT_NEAR(Depth(box, box, At(1.9, 0.2, 0)), 0.1, 1e-14) << margin;  // The cores are apart or touch.
    EXPECT_NEAR(Depth(box, box, At(1.5, 0.2, 0)), 0.5, 1e-14) << margin;  // The cores overlap.
    EXPECT_EQ(Depth(box, box, At(2.01, 0.2, 0)), 0) << margin;
  }
}

TEST(TruePenetrationTest, RoundedEdgesOfBoxes_AreShorterThanSharpOnes) {
  const double r = 1.0 / 512;
  const RoundedPolyhedron box = Rounded(Box{Vector3d(1, 1, 1)}, 0.04);
  // Edge to edge across the diagonal: the cores' edges are 2 (1 - r) apart from the middles in x and y.
  const double offset = 1.998;
  const double core_distance = std::sqrt(2) * (offset - 2 * (1 - r));
  EXPECT_NEAR(Depth(box, box, At(offset, offset, 0)), 2 * r - core_distance, 1e-14);
}

TEST(TruePenetrationTest, Hulls_GrowByTheMargin) {
  const RoundedPolyhedron hull = Rounded(Hull{CoreOf(Box{Vector3d(1, 1, 1)}, 0)}, 0.04);
  EXPECT_NEAR(Depth(hull, hull, At(2.05, 0, 0)), 0.03, 1e-14);
  EXPECT_NEAR(Depth(hull, hull, At(1.95, 0, 0)), 0.13, 1e-14);
}

TEST(TruePenetrationTest, CapsuleOnBox_SideAndEnd) {
  const RoundedPolyhedron capsule = Rounded(Capsule{0.5, 2}, 0.04), box = Rounded(Box{Vector3d(1, 1, 1)}, 0.04);
  EXPECT_NEAR(Depth(box, capsule, At(1.4, 0, 0)), 0.1, 1e-14);
  EXPECT_NEAR(Depth(box, capsule, At(0, 0, 2.3)), 0.2, 1e-14);
}

TEST(TruePenetrationTest, CylinderOnBox_IsWithinThePolygonsError) {
  const double radius = 0.5;
  const RoundedPolyhedron cylinder = Rounded(Cylinder{radius, 1}, 0.04), box = Rounded(Box{Vector3d(1, 1, 1)}, 0.04);
  EXPECT_NEAR(Depth(box, cylinder, At(0, 0, 1.4)), 0.1, 1e-14);  // Standing: exact.
  Pose turned = At(1.4, 0, 0);
  for (int i = 0; i < 20; ++i) {
    turned.rotation = Eigen::AngleAxisd(0.01 * i, Vector3d::UnitZ()).toRotationMatrix();
    const double depth = Depth(box, cylinder, turned);
    EXPECT_LE(depth, 0.1 + 1e-14);
    EXPECT_GE(depth, 0.1 - 0.0013 * radius);
  }
}

TEST(TruePenetrationTest, ConeOnBox_BaseAndTip) {
  const double margin = 0.04;
  const RoundedPolyhedron cone = Rounded(Cone{0.5, 1}, margin), box = Rounded(Box{Vector3d(1, 1, 1)}, margin);
  EXPECT_NEAR(Depth(box, cone, At(0.1, 0, 1.4)), 0.1 + margin, 1e-14);
  Pose on_its_tip = At(0, 0, 1.48);
  on_its_tip.rotation = Eigen::AngleAxisd(std::acos(-1.0), Vector3d::UnitX()).toRotationMatrix();
  EXPECT_NEAR(Depth(box, cone, on_its_tip), 0.02 + margin, 1e-14);
}

// The deepest of all pairs by the full computation.
double DeepestOfAll(const std::vector<Body>& bodies, const CollisionInput& input) {
  double deepest = 0;
  for (const auto& [first, second] : input.pairs) {
    deepest =
        std::max(deepest, TruePenetration(Rounded(bodies[first].shape, bodies[first].margin), input.poses[first],
                                          Rounded(bodies[second].shape, bodies[second].margin), input.poses[second]));
  }
  return deepest;
}

TEST(PenetrationOracleTest, PolytopesPushedTogether_DeepestIsThatOfTheFullComputation) {
  const std::vector<Body> bodies = MakeBodies(SmallDropScene(), 3);
  PenetrationOracle oracle(bodies);
  CollisionInput input;
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    input.poses.push_back(bodies[i].pose);
    for (int j = 0; j < i; ++j) input.pairs.push_back({j, i});
  }
  Random random(31, 0);
  int touching = 0;
  for (int step = 0; step < 60; ++step) {
    const double expected = DeepestOfAll(bodies, input);
    EXPECT_NEAR(oracle.DeepestPenetration(input), expected, 1e-13) << "step " << step;
    if (expected > 0) ++touching;
    // Draw the bodies together and turn them a little; the ground stays.
    for (std::size_t i = kGroundIndex + 1; i < input.poses.size(); ++i) {
      Pose& pose = input.poses[i];
      pose.position -= 0.02 * (pose.position - Vector3d(0, 0, 1));
      pose.rotation = Eigen::AngleAxisd(0.02, random.UnitVector()).toRotationMatrix() * pose.rotation;
    }
  }
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 60);
}

TEST(PenetrationOracleTest, NoPairs_NoPenetration) {
  const std::vector<Body> bodies = MakeBodies(SmallDropScene(), 3);
  CollisionInput input;
  for (const Body& body : bodies) input.poses.push_back(body.pose);
  EXPECT_EQ(PenetrationOracle(bodies).DeepestPenetration(input), 0);
}

// Two balls of 0.5 m on a rod of 2 m, one of them 0.1 m deep in a box; and the rod's other end 0.2 m deep in a
// half-space.
TEST(PenetrationOracleTest, PartsAndHalfSpaces_DeepestOfAll) {
  OracleBody dumbbell;
  for (const double x : {-1.0, 1.0}) {
    Pose end;
    end.position.x() = x;
    dumbbell.parts.push_back({{PointPolyhedron(), 0.5}, end});
  }
  const OracleBody box{{{{CoreOf(Box{Eigen::Vector3d::Constant(1)}, 0), 0}}}};
  OracleBody plane;
  plane.half_space = HalfSpace{Eigen::Vector3d::UnitX(), 0};
  PenetrationOracle oracle({dumbbell, box, plane, OracleBody{}});
  Pose beside, below;
  beside.position.x() = 2.4;
  below.position.x() = -1.3;
  const std::vector<Pose> poses = {Pose{}, beside, below, Pose{}};
  EXPECT_NEAR(oracle.DeepestPenetration({poses, {{0, 1}}}), 0.1, 1e-12);
  EXPECT_NEAR(oracle.DeepestPenetration({poses, {{0, 1}, {0, 2}}}), 0.2, 1e-12);
  EXPECT_EQ(oracle.DeepestPenetration({poses, {{0, 3}, {2, 3}}}), 0);
  EXPECT_EQ(oracle.CountUnjudged({poses, {{0, 1}, {0, 2}, {0, 3}, {2, 3}}}), 2);
}

}  // namespace
}  // namespace dgd_demos
