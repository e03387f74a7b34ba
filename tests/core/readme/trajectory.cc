// The program of the core's README.
#include <cstdio>
#include <numbers>

#include "dgd/growth_distance.h"
#include "dgd/shapes.h"

int main() {
  // A link of 60 x 10 x 10 cm with edges rounded by 2 cm more, and a bar of 20 cm diameter that lies along x.
  const dgd::RoundedSet link{dgd::Box<double>({0.3, 0.05, 0.05}), 0.02};
  const dgd::RoundedSet bar = dgd::Capsule(0.1, 0.5);
  dgd::Pose<double> bar_pose;
  bar_pose.rotation = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();

  dgd::Settings<double> settings;
  settings.relative_tolerance = 1e-6;
  dgd::WarmStart<double> warm_start;  // Of this pair alone, from each query to the next.
  for (int step = 0; step <= 4; ++step) {
    dgd::Pose<double> link_pose;
    link_pose.translation = {0.1, 0.5 - 0.1 * step, 0};
    const dgd::Result<double> result = dgd::GrowthDistance(link, link_pose, bar, bar_pose, settings, &warm_start);
    if (result.status != dgd::Status::kOptimal) return 1;
    std::printf("y %.1f  growth distance %.3f  separation %+.3f\n", link_pose.translation.y(), result.GrowthDistance(),
                result.separation);
  }
}
