// Between what is stored in a picture (sRGB) and amounts of light (linear).
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace dgd_demos {

inline double LinearFromSrgb(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

inline double SrgbFromLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

inline Eigen::Vector3d LinearFromSrgb(const Eigen::Vector3d& srgb) {
  return srgb.unaryExpr([](double component) { return LinearFromSrgb(component); });
}

}  // namespace dgd_demos
