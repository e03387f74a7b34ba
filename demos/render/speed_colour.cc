#include "render/speed_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dgd_demos {

double SpeedScale::PlaceOf(double speed) const { return std::sqrt(std::clamp(speed / fastest_, 0.0, 1.0)); }

Eigen::Vector3d SpeedScale::ColourAt(double place) {
  // By way of violet: whitish or yellowish middles look like the ground in the sun, and like mud in the shade.
  static const std::array<Eigen::Vector3d, 5> stops = {
      Eigen::Vector3d(0.24, 0.48, 0.85), Eigen::Vector3d(0.49, 0.49, 0.88), Eigen::Vector3d(0.72, 0.42, 0.72),
      Eigen::Vector3d(0.88, 0.36, 0.44), Eigen::Vector3d(0.87, 0.18, 0.12)};
  const double position = std::clamp(place, 0.0, 1.0) * (stops.size() - 1);
  const auto lower = std::min(static_cast<std::size_t>(position), stops.size() - 2);
  const double share = position - static_cast<double>(lower);
  return (1 - share) * stops[lower] + share * stops[lower + 1];
}

}  // namespace dgd_demos
