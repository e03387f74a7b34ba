// Speeds as colours: blue for still, red for fast.
#pragma once

#include <Eigen/Core>

namespace dgd_demos {

/// A colour scale for speeds from 0 to `fastest`. It goes with the square root of the speed, so that the slow motions
/// of a settling heap can still be told from rest.
class SpeedScale {
 public:
  /// @param fastest  m/s, > 0.
  explicit SpeedScale(double fastest) : fastest_(fastest) {}

  double fastest() const { return fastest_; }
  /// Place on the scale, 0 to 1.
  double PlaceOf(double speed) const;
  /// Colour at a place of the scale, sRGB with components from 0 to 1.
  static Eigen::Vector3d ColourAt(double place);

 private:
  double fastest_;
};

}  // namespace dgd_demos
