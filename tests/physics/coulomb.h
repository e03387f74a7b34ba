// Dry friction on a point mass along a line, integrated by steps so short that they do not matter. Knows no Bullet.
#pragma once

#include <cmath>

namespace dgd_physics {

/// Slip of a body on its support.
struct Slip {
  double velocity = 0;  ///< Relative to the support, m/s.
  double way = 0;       ///< Relative to the support, m.
};

/// Step of the reference solutions, seconds: a hundredth of the shortest Bullet step.
inline constexpr double kReferenceStep = 1e-5;

/// One step of Coulomb's law: sticks if friction can stop it within the step, else friction opposes the slip.
/// @param drive     Acceleration without friction, relative to the support, m/s^2.
/// @param friction  Largest acceleration by friction, m/s^2, >= 0.
inline void AdvanceSlip(Slip& slip, double drive, double friction, double dt) {
  const double before = slip.velocity;
  const double free = before + drive * dt;
  slip.velocity = std::abs(free) <= friction * dt ? 0 : free - std::copysign(friction * dt, free);
  slip.way += 0.5 * (before + slip.velocity) * dt;
}

/// Integrates from rest.
/// @param drive, friction  double(double time): as for AdvanceSlip().
/// @param visit            void(double time, const Slip&): called after each step.
template <class Drive, class Friction, class Visit>
Slip IntegrateSlip(double duration, const Drive& drive, const Friction& friction, const Visit& visit) {
  Slip slip;
  const long steps = std::lround(duration / kReferenceStep);
  for (long step = 0; step < steps; ++step) {
    const double middle = (double(step) + 0.5) * kReferenceStep;
    AdvanceSlip(slip, drive(middle), friction(middle), kReferenceStep);
    visit(double(step + 1) * kReferenceStep, slip);
  }
  return slip;
}

}  // namespace dgd_physics
