// The reduction of a mesh's contacts to as many as Bullet's manifolds may have.
#pragma once

#include <array>
#include <span>

#include "dgd/contact_patch.h"
#include "dgd_bullet/linkage.h"
#include "manifold/manifold_writer.h"
#include "mesh/mesh_contacts.h"

class btPersistentManifold;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

class PairMotion;

/// The chosen contacts, the most important first.
struct ReducedContacts {
  std::array<MeshContact, MANIFOLD_CACHE_SIZE> contacts;
  int size = 0;
};

/// Chooses up to settings.max_points contacts. Those that touch, or will by the end of the step, come before all
/// others; among them the deepest of each direction, so that a body in a groove keeps both sides, then what spans most.
/// Among those that are as good within a tolerance, points are chosen that the manifold has already: else contacts take
/// turns, and with them the impulses that the solver begins with, and what lies on a mesh trembles.
/// @param contacts  Their members for the reduction are set.
/// @param settings  Its spacing, equal depth and number of points count.
/// @param motion    Motion of body A, the manifold's first, and the mesh.
ReducedContacts ReduceContacts(std::span<MeshContact> contacts, const dgd::PatchSettings<double>& settings,
                               const PairMotion& motion, const btPersistentManifold& manifold);

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
