// What the tests of motion planning share: the shipped scene, random states, and an oracle that has no code in common
// with the core.
#pragma once

#include <algorithm>
#include <filesystem>
#include <limits>
#include <vector>

#include "motion/collision_model.h"
#include "motion/motion_scene.h"
#include "scene/polyhedron.h"
#include "scene/random.h"
#include "scene/shape.h"
#include "simulation/signed_distance.h"

namespace dgd_demos {

inline MotionScene ShippedMotionScene() {
  return LoadMotionScene(std::filesystem::path(DGD_TEST_SCENES) / "ur5e_five_obstacles.json");
}

/// Anywhere within the limits.
inline Configuration RandomState(const Arm& arm, Random& random) {
  Configuration state(static_cast<Eigen::Index>(arm.joints.size()));
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    state[static_cast<Eigen::Index>(i)] = random.Uniform(arm.joints[i].lower, arm.joints[i].upper);
  }
  return state;
}

/// The polyhedra that stand for cylinders lie inside them by up to 0.12 % of the radius, so distances of these come out
/// too long by up to as much for each; m, for radii up to 6 cm.
inline constexpr double kOracleError = 2 * 0.0012 * 0.06;

/// Distances by brute force over the features of polyhedra; m, negative for penetration.
class MotionOracle {
 public:
  explicit MotionOracle(const CollisionModel& model) : model_(model) {
    for (const CollisionModel::Part& part : model.parts()) {
      cores_.push_back(CoreOf(part.body.shape(), 0));
      radii_.push_back(RoundingRadius(part.body.shape(), 0));
      bounds_.push_back(BoundingRadius(part.body.shape(), 0));
    }
  }

  double Distance(const CheckedPair& pair, const CollisionModel::Poses& poses) const {
    const auto posed = [&](std::size_t part) {
      return PosedPolyhedron(cores_[part], {poses[part].rotation, poses[part].translation});
    };
    return ComputeSignedDistance(posed(pair.first), posed(pair.second)).value - radii_[pair.first] -
           radii_[pair.second];
  }

  /// Of all pairs.
  double LeastDistance(const Configuration& state) const {
    CollisionModel::Poses poses;
    model_.ComputePoses(state, poses);
    double least = std::numeric_limits<double>::infinity();
    for (const CheckedPair& pair : model_.pairs()) {
      const double between = (poses[pair.second].translation - poses[pair.first].translation).norm();
      if (between - bounds_[pair.first] - bounds_[pair.second] >= least) continue;
      least = std::min(least, Distance(pair, poses));
    }
    return least;
  }

 private:
  const CollisionModel& model_;
  std::vector<Polyhedron> cores_;
  std::vector<double> radii_, bounds_;
};

}  // namespace dgd_demos
