// Contacts as Bullet's debug drawers show them.
#pragma once

#include "dgd_bullet/linkage.h"

class btIDebugDraw;
class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Draws a manifold's contacts as the solver is given them, and changes nothing. With DBG_DrawContactPoints in the
/// drawer's mode: the patch's outline on either body, and its normal from B to A at each point; with DBG_DrawText: the
/// first point's separation in millimetres.
/// @param drawer  Or null.
void DrawContacts(const btPersistentManifold& manifold, btIDebugDraw* drawer);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
