// A rigid convex polyhedron that rolls, tumbles or slides over a plane, integrated from impact to impact,
// independent of Bullet.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace dgd_physics {

/// The hull of points, and all within the margin of it. The centre of mass is the origin.
struct Solid {
  std::vector<Eigen::Vector3d> corners;  ///< m
  double margin = 0;                     ///< m
  Eigen::Vector3d inertia;               ///< About its own axes, per mass, m^2.
};

/// In a frame in which the plane is z = 0.
struct SolidMotion {
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();  ///< rad/s
};

/// On its lowest corner, about which it turns without slip; the centre's height over that speed is the spin.
/// @param heading  Unit, along the plane.
SolidMotion RollOnLowestCorner(const Solid& solid, const Eigen::Quaterniond& rotation, const Eigen::Vector3d& heading,
                               double speed);

/// Newton and Euler between impacts, in steps of `dt` that end where a corner comes down. Corners that touch do not
/// rebound (Moreau's impact: all impulses of one moment together), and stick or slip by Coulomb's law. Of a polygon
/// that goes over from corner to corner without slip this is Housner's impact: the angular velocity is multiplied by
/// (k^2 + a . b) / (k^2 + R^2), for the radius of gyration k and the corners a and b, both at a distance R.
/// @param gravity      m/s^2
/// @param friction     Coulomb's coefficient.
/// @param seconds, dt  s
SolidMotion Integrate(const Solid& solid, SolidMotion motion, const Eigen::Vector3d& gravity, double friction,
                      double seconds, double dt = 1e-4);

}  // namespace dgd_physics
