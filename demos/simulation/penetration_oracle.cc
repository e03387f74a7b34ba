#include "simulation/penetration_oracle.h"

#include <algorithm>
#include <utility>

namespace dgd_demos {

using Eigen::Vector3d;

double TruePenetration(const RoundedPolyhedron& a, const Pose& pose_a, const RoundedPolyhedron& b, const Pose& pose_b) {
  const SignedDistance cores = ComputeSignedDistance(PosedPolyhedron(a.core, pose_a), PosedPolyhedron(b.core, pose_b));
  return std::max(0.0, a.radius + b.radius - cores.value);
}

std::vector<OracleBody> OracleBodiesOf(const std::vector<Body>& bodies) {
  std::vector<OracleBody> oracle_bodies;
  for (const Body& body : bodies) {
    oracle_bodies.push_back({{{{CoreOf(body.shape, body.margin), RoundingRadius(body.shape, body.margin)}}}});
  }
  return oracle_bodies;
}

PenetrationOracle::PenetrationOracle(std::vector<OracleBody> bodies) : bodies_(std::move(bodies)) {
  for (const OracleBody& body : bodies_) {
    first_parts_.push_back(static_cast<int>(parts_.size()));
    for (const OraclePart& part : body.parts) {
      parts_.push_back(&part);
      bounding_radii_.push_back(BoundingRadius(part.shape.core) + part.shape.radius);
    }
  }
  first_parts_.push_back(static_cast<int>(parts_.size()));
}

double PenetrationOracle::DeepestPenetration(const CollisionInput& input) {
  std::vector<Pose> poses;
  std::vector<PosedPolyhedron> cores;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (const OraclePart& part : bodies_[i].parts) {
      poses.push_back(input.poses[i] * part.pose);
      cores.emplace_back(part.shape.core, poses.back());
    }
  }

  // The most promising first: once the next bound is below the deepest so far, so are all after it.
  std::vector<Candidate> candidates = PartsThatMayOverlap(cores, poses, input.pairs);
  std::ranges::sort(candidates, std::ranges::greater(), &Candidate::depth_bound);
  double deepest = DeepestInHalfSpaces(cores, input);
  for (const Candidate& candidate : candidates) {
    if (candidate.depth_bound <= deepest) break;
    const auto [first, second] = candidate.parts;
    const SignedDistance distance = ComputeSignedDistance(cores[first], cores[second]);
    last_axes_[KeyOf(candidate.parts)] = distance.normal;
    deepest = std::max(deepest, parts_[first]->shape.radius + parts_[second]->shape.radius - distance.value);
  }
  return deepest;
}

int PenetrationOracle::CountUnjudged(const CollisionInput& input) const {
  return static_cast<int>(std::ranges::count_if(input.pairs, [&](const BodyPair& pair) {
    const OracleBody &first = bodies_[pair.first], &second = bodies_[pair.second];
    return !first.IsJudged() || !second.IsJudged() || (first.half_space && second.half_space);
  }));
}

std::vector<PenetrationOracle::Candidate> PenetrationOracle::PartsThatMayOverlap(
    const std::vector<PosedPolyhedron>& cores, const std::vector<Pose>& poses,
    const std::vector<BodyPair>& pairs) const {
  std::vector<Candidate> candidates;
  for (const BodyPair& pair : pairs) {
    for (int first = first_parts_[pair.first]; first < first_parts_[pair.first + 1]; ++first) {
      for (int second = first_parts_[pair.second]; second < first_parts_[pair.second + 1]; ++second) {
        const double centre_distance = (poses[second].position - poses[first].position).norm();
        if (centre_distance >= bounding_radii_[first] + bounding_radii_[second]) continue;

        const double separation = SeparationAlong(LastAxis({first, second}, poses), cores[first], cores[second]);
        const double depth_bound = parts_[first]->shape.radius + parts_[second]->shape.radius - separation;
        if (depth_bound > 0) candidates.push_back({{first, second}, depth_bound});
      }
    }
  }
  return candidates;
}

// Exact by the lowest vertex of each part.
double PenetrationOracle::DeepestInHalfSpaces(const std::vector<PosedPolyhedron>& cores,
                                              const CollisionInput& input) const {
  double deepest = 0;
  for (const BodyPair& pair : input.pairs) {
    const bool is_first = bodies_[pair.first].half_space.has_value();
    const int plane = is_first ? pair.first : pair.second;
    const int other = is_first ? pair.second : pair.first;
    if (!bodies_[plane].half_space) continue;
    const HalfSpace& half_space = *bodies_[plane].half_space;
    const Vector3d normal = input.poses[plane].rotation * half_space.normal;
    const double offset = half_space.offset + normal.dot(input.poses[plane].position);
    for (int part = first_parts_[other]; part < first_parts_[other + 1]; ++part) {
      for (const Vector3d& vertex : cores[part].vertices) {
        deepest = std::max(deepest, offset + parts_[part]->shape.radius - normal.dot(vertex));
      }
    }
  }
  return deepest;
}

Vector3d PenetrationOracle::LastAxis(const BodyPair& parts, const std::vector<Pose>& poses) const {
  const auto known = last_axes_.find(KeyOf(parts));
  if (known != last_axes_.end()) return known->second;
  const Vector3d offset = poses[parts.second].position - poses[parts.first].position;
  const double length = offset.norm();
  return length > 0 ? Vector3d(offset / length) : Vector3d::UnitZ();
}

std::uint64_t PenetrationOracle::KeyOf(const BodyPair& parts) const {
  return static_cast<std::uint64_t>(parts.first) * parts_.size() + static_cast<std::uint64_t>(parts.second);
}

void PenetrationOracle::Serialize(StateArchive& archive) {
  std::vector<std::pair<std::uint64_t, Vector3d>> axes(last_axes_.begin(), last_axes_.end());
  archive.Serialize(axes, [&](auto& axis) {
    archive.Serialize(axis.first);
    archive.Serialize(axis.second);
  });
  last_axes_ = {axes.begin(), axes.end()};
}

}  // namespace dgd_demos
