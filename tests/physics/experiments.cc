// The table of experiments: it drives the command line, --help, the output and the tests.
#include "physics/edges.h"
#include "physics/experiment.h"
#include "physics/friction.h"
#include "physics/moving_support.h"
#include "physics/near_miss.h"
#include "physics/resting.h"
#include "physics/restitution.h"
#include "physics/rolling_hulls.h"
#include "physics/solver_settings.h"
#include "physics/spin_rebound.h"
#include "physics/spinning.h"

namespace dgd_physics {

const std::vector<Experiment>& Experiments() {
  constexpr bool kRestitution = true;
  static const std::vector<Experiment> experiments = {
      {"head_on", "two bodies head on: speed at which they part, against e times that at which they met", MeasureHeadOn,
       kRestitution},
      {"gas", "elastic balls in a box: kinetic energy kept", MeasureGas, kRestitution},
      {"bounce", "dropped bodies: height of the rebound, against e^2 h", MeasureBounce, kRestitution},
      {"oblique_bounce", "balls against a wall at 20 to 70 degrees: speed along it and away from it",
       MeasureObliqueBounce, kRestitution},
      {"cradle", "Newton's cradle: velocities, over the first ball's; of impacts in one step momentum and energy",
       MeasureCradle, kRestitution},
      {"bat", "a bat that the app moves hits a body at rest: speed it leaves at, against (1 + e) times the bat's",
       MeasureBat, kRestitution},
      {"spin_rebound", "balls with a slip at walls with friction and restitution: velocity and spin, over the speed",
       MeasureSpinRebound, kRestitution},
      {"angular_momentum", "two bodies that meet with friction and restitution: angular momentum, over m v r",
       MeasureAngularMomentum},
      {"rebound_settings", "dropped balls under settings and solvers that apps choose: height of the third rebound",
       MeasureReboundSettings, kRestitution},
      {"slide", "a body set off once: way, against v^2 / (2 mu g)", MeasureSlide},
      {"swing_force", "a box under a swinging force of 1.5 mu m g: farthest and last way, against the integrated one",
       MeasureSwingForce},
      {"taps", "20 taps on a body at rest: way, against the sum of v^2 / (2 mu g)", MeasureTaps},
      {"belt", "a body on a surface that has a velocity and does not move: its speed, against the belt's", MeasureBelt},
      {"platform", "a load on a platform that shakes below slipping: amplitude, against the platform's, and phase",
       MeasurePlatform},
      {"feeder", "a load on a vibratory feeder: speed of transport, against the integrated one", MeasureFeeder},
      {"teleport", "a support put aside without a velocity: share of its way that the load is dragged",
       MeasureTeleport},
      {"incline",
       "slopes: creep in 5 s below the friction angle, over 1 cm; above it speed, against g (sin - mu cos) t",
       MeasureIncline},
      {"tiles", "tiles on each other on a slope that holds: way of the topmost in 4 s, over half a side", MeasureTiles},
      {"euler_disc", "a disc that precesses in place: energy kept in 5 s", MeasureEulerDisc},
      {"disc_circle", "a disc that rolls in a circle: energy kept in 3 s", MeasureDiscCircle},
      {"rolling", "balls and cylinders that roll on the level, fast and slowly: kinetic energy kept in 4 s",
       MeasureRolling},
      {"rolling_hulls", "wheels and balls given as hulls, thrown dice: way, against that from impact to impact",
       MeasureRollingHulls},
      {"torsion", "a box that spins about the vertical: angle until friction at its corners stops it", MeasureTorsion},
      {"near_rod", "a rod that spins half a millimetre clear of another: spin kept", MeasureNearRod},
      {"graze", "a body that a face passes, or it a face, 1 to 15 mm clear: change of velocity, over the speed",
       MeasureGraze},
      {"tumble", "a body that turns 1 to 10 mm clear of ground: change of velocity, over the speed of its corners",
       MeasureTumble},
      {"past_edge", "a body that flies past an edge, 2 to 30 mm clear: change of velocity, over the speed",
       MeasurePastEdge},
      {"over_ridge",
       "bodies that fly over a ridge, level or spinning, and clear it: change of velocity, over the speed",
       MeasureOverRidge},
      {"box_seams", "over flush boxes a box without friction, a ball or capsule that rolls: speed kept",
       MeasureBoxSeams},
      {"mesh_seams", "bodies without friction over flat meshes and heightfields: speed kept", MeasureMeshSeams},
      {"large_boxes", "small boxes on floors of 2 to 100 m: wrong falls from a ledge, sunk and speed lost at a seam",
       MeasureLargeBoxes},
      {"lines", "what comes down flat on a line of 5 to 100 mm: speed of its rolling over an end, over the drop's",
       MeasureLines},
      {"tip", "boxes that tip: force, slope, and share of wrong falls from a ledge", MeasureTip},
      {"rocking", "a slender block let go on an edge: greatest tilt on the other one, against Housner's",
       MeasureRocking},
      {"drop_dead", "dropped bodies without restitution: height of the rebound, over that of the drop",
       MeasureDropDead},
      {"rest", "bodies that have come to rest: speed, over 5 cm/s", MeasureRest},
      {"rest_settings", "dropped bodies under such settings: speed at rest, over 5 cm/s, and height, over the drop's",
       MeasureRestSettings},
      {"poles", "poles that stand where they were put: speed in the fourth second, over 5 cm/s", MeasurePoles},
      {"weight", "loads on two or four supports: forces, against statics", MeasureWeight},
      {"soft_contacts", "bodies at rest on contacts with a stiffness: dip, against m g / (n k)", MeasureSoftContacts},
      {"stack", "two to nine boxes on each other for 5 s: way of the topmost, over the height", MeasureStack},
      {"tunnel", "fast bodies at thin plates, and plates at bodies, without Bullet's CCD: share that goes through",
       MeasureTunnel},
  };
  return experiments;
}

}  // namespace dgd_physics
