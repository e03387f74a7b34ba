// Contacts as Bullet's debug drawers show them.
#pragma once

#include "dgd/contact_patch.h"
#include "dgd/growth_distance.h"

class btIDebugDraw;

namespace dgd_bullet {

/// Whether a drawer, if there is one, wants to see contacts.
bool WantsContacts(const btIDebugDraw* drawer);

/// With DBG_DrawContactPoints in the drawer's mode: the patch's outline on either body, and its normal from each of its
/// points, from B to A as Bullet has it. With DBG_DrawText, too: the deepest point's separation in millimetres, and the
/// bounds on the growth distance where it was solved for. Nothing without points.
/// @param result  Of the two shapes, A first.
void DrawContacts(const dgd::ContactPatch<double>& patch, const dgd::Result<double>& result, btIDebugDraw& drawer);

}  // namespace dgd_bullet
