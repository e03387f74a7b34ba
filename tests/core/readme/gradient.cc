// The program of the core's README for planners.
#include "dgd/gradient.h"

#include <cstdio>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"

int main() {
  // A link of 80 cm along z whose joint is at its lower end, and an obstacle next to its upper half. Metres.
  const dgd::RoundedSet link = dgd::Capsule(0.05, 0.35);
  const dgd::RoundedSet obstacle{dgd::Box<double>({0.2, 0.3, 0.1}), 0.01};
  const Eigen::Vector3d joint(0, 0, -0.35);
  dgd::Pose<double> link_pose, obstacle_pose;
  obstacle_pose.translation = {0.3, 0.05, 0.25};
  obstacle_pose.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();

  const dgd::CollisionResult<double> check = dgd::DetectCollision(link, link_pose, obstacle, obstacle_pose);
  if (check.status != dgd::Status::kSeparated) return 1;

  const dgd::Result<double> result =
      dgd::GrowthDistance(link, link_pose, obstacle, obstacle_pose, {.relative_tolerance = 1e-12});
  const dgd::Gradient<double> gradient = dgd::GrowthDistanceGradient(link, link_pose, obstacle, obstacle_pose, result);
  std::printf("growth distance %.3f, separation %.3f m\n", result.GrowthDistance(), result.separation);

  // The joint turns the link about its y axis at 1 rad/s, and moves the origin of the link's frame by that.
  const Eigen::Vector3d angular_velocity = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d velocity = angular_velocity.cross(-joint);
  std::printf("turning the joint changes it by %+.3f per radian%s\n", gradient.pose_1.Rate(velocity, angular_velocity),
              gradient.IsUnique() ? "" : ", on one side at least");
}
