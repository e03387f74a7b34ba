// Options of the narrowphase. One value per dispatcher; copied when the narrowphase is made, never read again.
#pragma once

namespace dgd_bullet {

struct Options {
  /// Relative gap between the two bounds of the growth distance at which a query stops; dimensionless, > 0. The depth
  /// that a contact reports is certified whatever this is: it only bounds how far the normal and the witness points
  /// are from the optimum. Polytopes end at rounding error regardless.
  double relative_tolerance = 1e-8;

  /// Iterations of the solver before the pair is handed to Bullet's own GJK/EPA (counted as a fallback); >= 1.
  int max_iterations = 100;

  /// Hand over all points of the touching features in one step (at most four), and drop cached points which that patch
  /// no longer has. Off: one point a step, and Bullet's own accumulation over several steps.
  bool contact_patch = true;

  /// In a dynamics world, also hand over points that are still farther apart than Bullet's contact breaking threshold
  /// if the bodies' velocities make them touch within the time step: fast impacts are then met, not found when the
  /// bodies already overlap. Needs contact_patch. Bodies that rebound (combined restitution above 0) are not met early,
  /// so that they rebound as high as with Bullet; contactTest() and its like never see such points.
  bool speculative_contacts = true;
};

}  // namespace dgd_bullet
