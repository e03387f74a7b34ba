// Whether app, plugin and the process's Bullet library agree.
#pragma once

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Throws std::runtime_error, in one sentence, if the Bullet library of this process computes in another precision than
/// this plugin is compiled for, or if the app is compiled for another version. Nothing of Bullet's need exist yet.
/// @param app_version  BT_BULLET_VERSION of the headers that the app is compiled with.
void RequireMatchingBullet(int app_version);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
