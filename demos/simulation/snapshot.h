// The bodies at one moment, for a picture.
#pragma once

#include <vector>

#include "scene/pose.h"

namespace dgd_demos {

struct Snapshot {
  double time;                 ///< s
  std::vector<Pose> poses;     ///< Poses in the order of the bodies.
  std::vector<double> speeds;  ///< Speeds of the centres of mass, m/s.
};

}  // namespace dgd_demos
