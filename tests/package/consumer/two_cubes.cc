// The solver alone, against the installed package: unit cubes two metres apart touch at twice their size.
#include <cmath>
#include <cstdio>
#include <vector>

#include "dgd/growth_distance.h"
#include "dgd/shapes/polytope.h"

int main() {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
  const dgd::RoundedSet cube{dgd::Polytope<double>(corners), 0.0};
  dgd::Pose<double> pose;
  pose.translation = {2, 0, 0};
  const dgd::Result<double> result = dgd::GrowthDistance(cube, dgd::Pose<double>(), cube, pose);
  std::printf("growth distance %.15f\n", result.GrowthDistance());
  return result.status == dgd::Status::kOptimal && std::abs(result.GrowthDistance() - 2) < 1e-9 ? 0 : 1;
}
