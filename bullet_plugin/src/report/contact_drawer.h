// Contacts as Bullet's debug drawers show them.
#pragma once

#include "dgd_bullet/linkage.h"

class btIDebugDraw;
class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Shows a drawer whose mode has them the contacts of a manifold as the solver is given them, however they were
/// found: drawing changes nothing. With DBG_DrawContactPoints in its mode the patch's outline on either body, and its
/// normal from each of its points, from B to A; with DBG_DrawText, too, the first point's separation in millimetres.
/// @param drawer  Or null.
void DrawContacts(const btPersistentManifold& manifold, btIDebugDraw* drawer);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
