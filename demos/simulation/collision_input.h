// What a narrowphase is given in one step, free of Bullet: which bodies may touch, and where they are.
#pragma once

#include <vector>

#include "scene/pose.h"

namespace dgd_demos {

/// Indices of two bodies with overlapping bounding boxes; first < second.
struct BodyPair {
  int first, second;
};

struct CollisionInput {
  std::vector<Pose> poses;
  std::vector<BodyPair> pairs;
};

}  // namespace dgd_demos
