// What the tests of motion planning share: the shipped scene, random states, and an oracle that has no code in common
// with the core.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
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

/// An arm of two links in the horizontal plane that has to fold to get past a post. The tests break it in one place
/// each.
inline std::string SmallMotionSceneText() {
  return R"({
  "about": "SI units, z up",
  "gravity": [0, 0, -9.81],
  "arms": [
    {
      "name": "planar",
      "base": { "position": [0, 0, 0] },
      "links": [
        { "name": "base" },
        {
          "name": "upper", "mass": 1, "centre_of_mass": [0.2, 0, 0],
          "joint": { "name": "shoulder", "position": [0, 0, 0.1], "axis": [0, 0, 1], "lower": -3, "upper": 3, "max_velocity": 1, "max_effort": 10 },
          "shapes": [{ "type": "capsule", "radius": 0.03, "length": 0.3, "position": [0.2, 0, 0], "rotation": [0, 1.5707963, 0] }]
        },
        {
          "name": "lower", "mass": 1, "centre_of_mass": [0.2, 0, 0], "inertia": [0.01, 0.02, 0.02],
          "joint": { "name": "elbow", "position": [0.4, 0, 0], "axis": [0, 0, 1], "lower": -2.5, "upper": 2.5, "max_velocity": 2, "max_effort": 5 },
          "shapes": [{ "type": "capsule", "radius": 0.03, "length": 0.3, "position": [0.2, 0, 0], "rotation": [0, 1.5707963, 0] }]
        }
      ],
      "flange": { "position": [0.4, 0, 0] }
    }
  ],
  "obstacles": [
    { "name": "post", "type": "cylinder", "radius": 0.05, "height": 0.4, "position": [0.5, 0.3, 0.1] }
  ],
  "plan": {
    "arm": "planar",
    "start": { "shoulder": -0.5, "elbow": 0.1 },
    "goal": { "shoulder": 1.5, "elbow": 0.1 }
  }
})";
}

/// With one part of the text replaced, which must be in it.
inline std::string With(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t place = text.find(old_part);
  EXPECT_NE(place, std::string::npos) << old_part;
  return text.replace(place, old_part.size(), new_part);
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
