#include "simulation/penetration_oracle.h"

#include <algorithm>

namespace dgd_demos {

using Eigen::Vector3d;

double TruePenetration(const RoundedPolyhedron& a, const Pose& pose_a, const RoundedPolyhedron& b, const Pose& pose_b) {
  const SignedDistance cores = ComputeSignedDistance(PosedPolyhedron(a.core, pose_a), PosedPolyhedron(b.core, pose_b));
  return std::max(0.0, a.radius + b.radius - cores.value);
}

PenetrationOracle::PenetrationOracle(const std::vector<Body>& bodies) {
  for (const Body& body : bodies) {
    shapes_.push_back({CoreOf(body.shape, body.margin), RoundingRadius(body.shape, body.margin)});
    bounding_radii_.push_back(BoundingRadius(shapes_.back().core) + shapes_.back().radius);
  }
}

double PenetrationOracle::DeepestPenetration(const CollisionInput& input) {
  std::vector<PosedPolyhedron> cores;
  for (std::size_t i = 0; i < shapes_.size(); ++i) cores.emplace_back(shapes_[i].core, input.poses[i]);

  // The most promising first: once the next bound is below the deepest so far, so are all after it.
  std::vector<Candidate> candidates = PairsThatMayOverlap(cores, input);
  std::ranges::sort(candidates, std::ranges::greater(), &Candidate::depth_bound);
  double deepest = 0;
  for (const Candidate& candidate : candidates) {
    if (candidate.depth_bound <= deepest) break;
    const auto [first, second] = candidate.pair;
    const SignedDistance distance = ComputeSignedDistance(cores[first], cores[second]);
    last_axes_[KeyOf(candidate.pair)] = distance.normal;
    deepest = std::max(deepest, shapes_[first].radius + shapes_[second].radius - distance.value);
  }
  return deepest;
}

std::vector<PenetrationOracle::Candidate> PenetrationOracle::PairsThatMayOverlap(
    const std::vector<PosedPolyhedron>& cores, const CollisionInput& input) const {
  std::vector<Candidate> candidates;
  for (const BodyPair& pair : input.pairs) {
    const auto [first, second] = pair;
    const double centre_distance = (input.poses[second].position - input.poses[first].position).norm();
    if (centre_distance >= bounding_radii_[first] + bounding_radii_[second]) continue;

    const double separation = SeparationAlong(LastAxis(pair, input.poses), cores[first], cores[second]);
    const double depth_bound = shapes_[first].radius + shapes_[second].radius - separation;
    if (depth_bound > 0) candidates.push_back({pair, depth_bound});
  }
  return candidates;
}

Vector3d PenetrationOracle::LastAxis(const BodyPair& pair, const std::vector<Pose>& poses) const {
  const auto known = last_axes_.find(KeyOf(pair));
  if (known != last_axes_.end()) return known->second;
  const Vector3d offset = poses[pair.second].position - poses[pair.first].position;
  const double length = offset.norm();
  return length > 0 ? Vector3d(offset / length) : Vector3d::UnitZ();
}

std::uint64_t PenetrationOracle::KeyOf(const BodyPair& pair) const {
  return static_cast<std::uint64_t>(pair.first) * shapes_.size() + static_cast<std::uint64_t>(pair.second);
}

}  // namespace dgd_demos
