// Contract of the execution's CSV: a named column for each figure of each joint, and numbers that read back.
#include "report/execution_csv.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "small_scenes.h"

namespace dgd_demos {
namespace {

TEST(ExecutionCsv, HasARowAStepAndFourColumnsAJoint) {
  Arm arm;
  arm.joints.push_back({"hip", {}, Eigen::Vector3d::UnitZ(), -1, 1, 1, 1});
  arm.joints.push_back({"knee", {}, Eigen::Vector3d::UnitZ(), -1, 1, 1, 1});
  ExecutionStep step;
  step.time = 0.25;
  step.planned = Eigen::Vector2d(1, 2);
  step.angles = Eigen::Vector2d(3, 4);
  step.velocities = Eigen::Vector2d(5, 6);
  step.efforts = Eigen::Vector2d(7, 8.5);
  step.flange = {0.5, -1, 1.5};
  step.tracking_error = 0.1;
  step.contacts = 2;
  const TestFolder folder;
  WriteExecutionCsv(folder.path() / "execution.csv", arm, {step, step});
  const std::string row = "0.25,0.1,0.5,-1,1.5,2,1,3,5,7,2,4,6,8.5\n";
  EXPECT_EQ(ReadFile(folder.path() / "execution.csv"),
            "time_s,tracking_error_m,flange_x_m,flange_y_m,flange_z_m,contacts,hip_planned_rad,hip_rad,hip_rad_s,"
            "hip_nm,knee_planned_rad,knee_rad,knee_rad_s,knee_nm\n" +
                row + row);
  EXPECT_THROW(WriteExecutionCsv(folder.path() / "none" / "execution.csv", arm, {}), std::runtime_error);
}

}  // namespace
}  // namespace dgd_demos
