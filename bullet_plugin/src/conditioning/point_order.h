// The order of a manifold's points: Options::order_points_by_impulse.
//
// Bullet's contact solver goes through the points one after the other, and what comes later is left more undone. Here
// the point that carried most in the last step comes first, and the others follow around the patch. Two opposite
// corners that come first would carry three quarters of the load between them and let stacks of small boxes rock (four
// of 0.2 m at 60 Hz: 23 mm away after 5 s, 7 with this order). A last point that carries much feeds the sway of high
// towers (scenes/tower_20.json in float: 120 mm/s with an order that does not depend on impulses, 2 with this; Bullet's
// narrowphase 42).
//
// Physics: points, forces and their sum are the same in a solver that converges; with few iterations, the solver's
// error is another. Links of multibodies, which another solver takes, keep their order: with this one, the gripper of
// tests/apps drops 41 of 126 boxes in double and 44 in float, 31 without (42 at 240, 480, 1000 Hz).
#pragma once

#include "dgd_bullet/linkage.h"

class btPersistentManifold;

namespace dgd_bullet::inline DGD_BULLET_PRECISION {

void OrderByImpulse(btPersistentManifold& manifold);

}  // namespace dgd_bullet::inline DGD_BULLET_PRECISION
