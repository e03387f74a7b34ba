// Steady precession of a disc that rolls on level ground. Knows no Bullet.
#pragma once

namespace dgd_physics {

/// A cylinder with rounded rims: a core, and all within the margin of it. Bullet's cylinders are like that outside of
/// box-like pairs.
struct Disc {
  double radius, half_thickness;             ///< Margin included, m.
  double margin;                             ///< m
  double mass;                               ///< kg
  double axial_inertia, transverse_inertia;  ///< kg m^2
};

/// A motion in which the axis keeps its tilt from the vertical and turns about it at a constant rate, and the disc
/// rolls without slip. The frame turns along: z up, the lowest rim towards x, the axis leaning to x too.
struct SteadyMotion {
  double height;          ///< Of the centre, m.
  double center_speed;    ///< Along y, m/s.
  double spin_x, spin_z;  ///< Angular velocity, rad/s; none about y.
  double friction;        ///< Least friction coefficient for it.
};

/// The motion whose centre goes round a circle, at a given rate of precession, rad/s.
/// @param tilt  Of the axis from the vertical, radians, in (0, pi/2).
SteadyMotion RollInCircle(const Disc& disc, double tilt, double precession);

/// Euler's disc: the motion whose centre stands still. For a thin disc the precession is sqrt(4 g / (R sin(tilt))).
SteadyMotion RollInPlace(const Disc& disc, double tilt);

}  // namespace dgd_physics
