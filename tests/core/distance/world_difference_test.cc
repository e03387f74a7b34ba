// The difference in the axes of the world: the points of MinkowskiDifference, about the origin of the two positions.
#include "dgd/distance/world_difference.h"

#include <gtest/gtest.h>

#include "dgd/shapes/box.h"
#include "dgd/shapes/triangle.h"
#include "support/random.h"

namespace dgd_test {
namespace {

using Eigen::Vector3d;
using Box = dgd::RoundedSet<dgd::Box<double>>;
using Triangle = dgd::RoundedSet<dgd::Triangle<double>>;

class WorldDifferenceTest : public testing::Test {
 protected:
  Random random_{TestSeed()};
  // The triangle's centre is away from its origin.
  const Box box_{dgd::Box<double>(Vector3d(0.3, 0.2, 0.4)), 0.1};
  const Triangle triangle_{dgd::Triangle<double>(Vector3d(2, 0, 1), Vector3d(3, 0, 1), Vector3d(2, 1, 1)), 0.2};
  const dgd::Pose<double> pose_1_{random_.Rotation(), random_.InCube()}, pose_2_{random_.Rotation(), random_.InCube()};
  const dgd::distance_internal::WorldDifference<Box, Triangle> world_{box_, pose_1_, triangle_, pose_2_};
};

TEST_F(WorldDifferenceTest, SupportPoints_AreThoseInTheRaysFrame) {
  const dgd::MinkowskiDifference<Box, Triangle> in_ray_frame(box_, pose_1_, triangle_, pose_2_);
  for (int i = 0; i < 20; ++i) {
    const Vector3d normal = random_.UnitVector();
    const auto point = world_.Support(normal, normal, dgd::kNoFeature, dgd::kNoFeature);
    const Vector3d seen_along = in_ray_frame.DirectionFromWorld(normal);
    auto expected = in_ray_frame.Support(seen_along, seen_along);
    expected.point -= in_ray_frame.DistanceOrigin();
    EXPECT_TRUE(point.HasFeaturesOf(expected));
    EXPECT_LT((point.point - in_ray_frame.DirectionToWorld(expected.point)).norm(), 1e-14);
    EXPECT_EQ(world_.FromVertices(point.feature_1, point.feature_2).point, point.point);
    EXPECT_LT((world_.NormalOfSet1(normal) - in_ray_frame.NormalOfSet1(seen_along)).norm(), 1e-14);
    // Both say where the sets' own points are.
    const Vector3d on_2 = point.on_1 - point.point, expected_on_2 = expected.on_1 - expected.point;
    EXPECT_LT((world_.World1(point.on_1, normal) - in_ray_frame.World1(expected.on_1, seen_along)).norm(), 1e-14);
    EXPECT_LT(
        (world_.World2(on_2, normal) - in_ray_frame.World2(expected_on_2 - in_ray_frame.DistanceOrigin(), seen_along))
            .norm(),
        1e-14);
  }
}

TEST_F(WorldDifferenceTest, VerticesThatAreNoMore_AreNoFeatures) {
  EXPECT_TRUE(world_.HasFeatures(7, 2));
  EXPECT_FALSE(world_.HasFeatures(8, 2));
  EXPECT_FALSE(world_.HasFeatures(7, 3));
}

}  // namespace
}  // namespace dgd_test
