#include "bench/exact_growth_distance.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "support/lp_oracle.h"

namespace dgd_bench {
namespace {

using dgd_test::PoseNumbers;
using dgd_test::SetNumbers;
using dgd_test::SetType;
using Eigen::Vector3d;

bool IsSharpPolytope(const SetNumbers& set) {
  return (set.type == SetType::kPolytope || set.type == SetType::kMesh) && set.radius == 0;
}

std::vector<Vector3d> InWorld(const SetNumbers& set, const PoseNumbers& pose) {
  std::vector<Vector3d> points(set.points.size());
  std::ranges::transform(set.points, points.begin(),
                         [&](const Vector3d& point) -> Vector3d { return pose.rotation * point + pose.translation; });
  return points;
}

}  // namespace

std::optional<double> ExactGrowthDistance(const dgd_test::PairNumbers& pair, const Vector3d& center_1,
                                          const Vector3d& center_2) try {
  const auto& [set_1, set_2, pose_1, pose_2] = pair;
  if (set_1.type == SetType::kPoint && set_2.type == SetType::kPoint) {
    return (center_2 - center_1).norm() / (set_1.radius + set_2.radius);
  }
  if (!IsSharpPolytope(set_1) || !IsSharpPolytope(set_2)) return std::nullopt;
  return dgd_test::GrowthDistanceByLp(InWorld(set_1, pose_1), center_1, InWorld(set_2, pose_2), center_2);
} catch (const std::runtime_error&) {
  return std::nullopt;
}

}  // namespace dgd_bench
