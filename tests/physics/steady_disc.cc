#include "physics/steady_disc.h"

#include <cmath>

namespace dgd_physics {
namespace {

constexpr double kGravity = 9.81;  // m/s^2

/// Contact point from the centre: x and z.
struct Contact {
  double x, z;
};

Contact ContactOf(const Disc& disc, double tilt) {
  const double radius = disc.radius - disc.margin, half_thickness = disc.half_thickness - disc.margin;
  return {radius * std::cos(tilt) - half_thickness * std::sin(tilt),
          -radius * std::sin(tilt) - half_thickness * std::cos(tilt) - disc.margin};
}

// With the precession W about z, and the spin s about the axis e = (sin, 0, cos) on top of it, the angular velocity is
// (s sin, 0, W + s cos). The contact point at (a, 0, b) is at rest: the centre moves along y at v = s sin b - (W + s
// cos) a, on a circle of radius v / W. The ground's force is (-m W v, 0, m g), its moment about the centre -(b m W v +
// a m g) along y, and that is the rate of change of the angular momentum: W sin (I3 w3 - I1 W cos), w3 = W cos + s.
SteadyMotion MotionOf(const Disc& disc, double tilt, double precession, double spin) {
  const Contact contact = ContactOf(disc, tilt);
  const double spin_x = spin * std::sin(tilt), spin_z = precession + spin * std::cos(tilt);
  const double speed = spin_x * contact.z - spin_z * contact.x;
  return {-contact.z, speed, spin_x, spin_z, std::abs(precession * speed) / kGravity};
}

}  // namespace

SteadyMotion RollInCircle(const Disc& disc, double tilt, double precession) {
  const double sine = std::sin(tilt), cosine = std::cos(tilt);
  const auto [a, b] = ContactOf(disc, tilt);
  // The balance of moments is linear in the spin.
  const double of_spin = precession * sine * disc.axial_inertia + disc.mass * b * precession * (sine * b - cosine * a);
  const double rest = precession * precession * sine * cosine * (disc.axial_inertia - disc.transverse_inertia) -
                      disc.mass * a * b * precession * precession + disc.mass * kGravity * a;
  return MotionOf(disc, tilt, precession, -rest / of_spin);
}

SteadyMotion RollInPlace(const Disc& disc, double tilt) {
  const double sine = std::sin(tilt), cosine = std::cos(tilt);
  const auto [a, b] = ContactOf(disc, tilt);
  // The centre's speed is 0: the spin is this share of the precession.
  const double spin = a / (sine * b - cosine * a);
  const double squared =
      disc.mass * kGravity * a / (sine * (disc.transverse_inertia * cosine - disc.axial_inertia * (cosine + spin)));
  const double precession = std::sqrt(squared);
  return MotionOf(disc, tilt, precession, spin * precession);
}

}  // namespace dgd_physics
