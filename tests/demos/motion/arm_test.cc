// Contract of the arm's kinematics: the shipped UR5e is where its maker's Denavit-Hartenberg table says.
#include "motion/arm.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "motion/motion_scene.h"

namespace dgd_demos {
namespace {

using Eigen::Vector3d;

Arm ShippedArm() {
  return LoadMotionScene(std::filesystem::path(DGD_TEST_SCENES) / "ur5e_five_obstacles.json").PlannedArm();
}

Configuration Angles(const std::array<double, 6>& angles) {
  return Eigen::Map<const Eigen::VectorXd>(angles.data(), 6);
}

Eigen::Matrix3d AboutZ(double angle) { return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix(); }

// Two tables of the same arm's flange: by the maker's lengths in the frame of the Denavit-Hartenberg table, and by
// MuJoCo Menagerie's model, which has rounded lengths and another world frame.
struct CheckValue {
  std::array<double, 6> angles;
  Vector3d denavit_hartenberg, menagerie;
};
const std::array<CheckValue, 4> kCheckValues = {
    {{{0, 0, 0, 0, 0, 0}, {-0.8172, -0.2329, 0.0628}, {-0.234, 0.817, 0.063}},
     {{-1.5708, -1.5708, 1.5708, -1.5708, -1.5708, 0}, {-0.133298, 0.491899, 0.487900}, {0.491999, 0.133998, 0.488000}},
     {{0.3, -1.1, 1.7, -0.9, 0.6, 0.4}, {-0.509196, -0.383091, 0.241183}, {-0.384117, 0.509025, 0.241576}},
     {{0, -1.2, 2.7, -1.5, -1.57, 0}, {-0.082145, -0.133379, 0.067699}, {-0.134080, 0.081731, 0.068099}}}};

// The scene's arm stands as ROS's base_link does: half a turn about z from the table's base.
TEST(ArmTest, FlangeOfUr5e_IsWhereDenavitHartenbergTableSays) {
  Arm arm = ShippedArm();
  arm.base.rotation = AboutZ(std::numbers::pi);
  for (const CheckValue& check : kCheckValues) {
    const Vector3d error = FlangePose(arm, Angles(check.angles)).position - check.denavit_hartenberg;
    EXPECT_LE(error.cwiseAbs().maxCoeff(), 1e-6) << error.transpose();
  }
}

// The product of Rz(angle) Tz(d) Tx(a) Rx(alpha) over the table's rows, which shares no code with the arm.
TEST(ArmTest, FlangeOfUr5e_IsTurnedAsDenavitHartenbergTableSays) {
  constexpr double kHalfPi = std::numbers::pi / 2;
  const std::array<Vector3d, 6> rows = {Vector3d(0, 0.1625, kHalfPi),  Vector3d(-0.425, 0, 0),
                                        Vector3d(-0.3922, 0, 0),       Vector3d(0, 0.1333, kHalfPi),
                                        Vector3d(0, 0.0997, -kHalfPi), Vector3d(0, 0.0996, 0)};  // a, d, alpha
  Arm arm = ShippedArm();
  arm.base.rotation = AboutZ(std::numbers::pi);
  for (const CheckValue& check : kCheckValues) {
    Eigen::Isometry3d expected = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i < 6; ++i) {
      expected = expected * Eigen::AngleAxisd(check.angles[i], Vector3d::UnitZ()) *
                 Eigen::Translation3d(rows[i].x(), 0, rows[i].y()) * Eigen::AngleAxisd(rows[i].z(), Vector3d::UnitX());
    }
    const Pose flange = FlangePose(arm, Angles(check.angles));
    EXPECT_LE((flange.rotation - expected.linear()).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((flange.position - expected.translation()).norm(), 1e-12);
  }
}

TEST(ArmTest, MenagerieLengths_GiveMenagerieFlange) {
  Arm arm = ShippedArm();
  arm.base.rotation = AboutZ(std::numbers::pi / 2);
  const std::array<Vector3d, 6> origins = {Vector3d(0, 0, 0.163), Vector3d(0, 0.138, 0), Vector3d(0, -0.131, 0.425),
                                           Vector3d(0, 0, 0.392), Vector3d(0, 0.127, 0), Vector3d(0, 0, 0.1)};
  for (std::size_t i = 0; i < 6; ++i) arm.joints[i].origin.position = origins[i];
  arm.flange.position = {0, 0.1, 0};
  for (const CheckValue& check : kCheckValues) {
    const Vector3d error = FlangePose(arm, Angles(check.angles)).position - check.menagerie;
    EXPECT_LE(error.cwiseAbs().maxCoeff(), 1e-6) << error.transpose();
  }
}

TEST(ArmTest, FindJointBeyondLimits_NamesTheFirstOne) {
  const Arm arm = ShippedArm();
  EXPECT_EQ(FindJointBeyondLimits(arm, Angles({0, 0, 0, 0, 0, 0})), std::nullopt);
  EXPECT_EQ(FindJointBeyondLimits(arm, Angles({6.28, 0, 3.14, 0, 0, -6.28})), std::nullopt);
  EXPECT_EQ(FindJointBeyondLimits(arm, Angles({0, 0, 3.15, 0, 7, 0})), std::size_t(2));
  EXPECT_EQ(FindJointBeyondLimits(arm, Angles({0, -7, 0, 0, 0, 0})), std::size_t(1));
  EXPECT_EQ(FindJointBeyondLimits(arm, Angles({0, 0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN()})),
            std::size_t(5));
}

}  // namespace
}  // namespace dgd_demos
