// A path in joint space: straight from each configuration to the next.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/arm.h"

namespace dgd_demos {

using JointPath = std::vector<Configuration>;

/// Sum of the Euclidean distances from each configuration to the next, rad.
inline double Length(const JointPath& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

/// The same path with more configurations: each straight part in equal steps of at most `step`, in rad.
inline JointPath Subdivide(const JointPath& path, double step) {
  JointPath states = {path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = (path[i] - path[i - 1]).norm();
    const int parts = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int part = 1; part < parts; ++part) {
      states.push_back(path[i - 1] + (path[i] - path[i - 1]) * (static_cast<double>(part) / parts));
    }
    states.push_back(path[i]);
  }
  return states;
}

}  // namespace dgd_demos
