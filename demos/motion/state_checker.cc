#include "motion/state_checker.h"

#include <dgd/any_set.h>

#include <cmath>

namespace dgd_demos {

std::optional<std::size_t> StateChecker::FindCollision(const Configuration& configuration) {
  model_.ComputePoses(configuration, poses_);
  return FindCollision(poses_);
}

std::optional<std::size_t> StateChecker::FindCollision(const CollisionModel::Poses& poses) {
  ++counts_.states;
  const std::size_t pairs = model_.pairs().size();
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    if (IsApart(pair, poses)) continue;
    counts_.pairs += static_cast<std::int64_t>(pair + 1);
    return pair;
  }
  counts_.pairs += static_cast<std::int64_t>(pairs);
  return std::nullopt;
}

bool StateChecker::IsApart(std::size_t pair, const CollisionModel::Poses& poses) {
  if (planes_.Separates(pair, poses, /*margin=*/0)) {
    ++counts_.pairs_by_plane;
    return true;
  }
  std::optional<Eigen::Vector3d> normal;
  if (shortcuts_ != Shortcuts::kNone) normal = NormalBetweenNearestPoints(pair, poses);
  if (!normal) {
    const auto [first, second] = model_.pairs()[pair];
    const dgd::CollisionResult<double> result = dgd::DetectCollision(model_.parts()[first].body.set(), poses[first],
                                                                     model_.parts()[second].body.set(), poses[second]);
    if (result.status != dgd::Status::kSeparated) return false;
    normal = result.normal;
  }
  if (shortcuts_ == Shortcuts::kCachedPlanes) planes_.Store(pair, poses, *normal);
  return true;
}

std::optional<Eigen::Vector3d> StateChecker::NormalBetweenNearestPoints(std::size_t pair,
                                                                        const CollisionModel::Poses& poses) const {
  const auto [first, second] = model_.pairs()[pair];
  const ConvexBody &body_1 = model_.parts()[first].body, &body_2 = model_.parts()[second].body;
  const Eigen::Vector3d point_2 = body_2.NearestInside(poses[second], poses[first].translation);
  const Eigen::Vector3d between = point_2 - body_1.NearestInside(poses[first], point_2);
  const double distance_sq = between.squaredNorm();
  if (!(distance_sq > 0)) return std::nullopt;
  const Eigen::Vector3d normal = between / std::sqrt(distance_sq);
  const double overlap = body_1.SupportValue(poses[first], normal) + body_2.SupportValue(poses[second], -normal);
  if (!(overlap < -PlaneCache::kRoundoff)) return std::nullopt;
  return normal;
}

}  // namespace dgd_demos
