// The stages that all kinds of pairs share: recycled contacts are the first one, Bullet's own algorithm the last.
#pragma once

#include <exception>
#include <new>
#include <optional>

#include "dgd/contact/reference_face.h"
#include "dgd_bullet/linkage.h"
#include "manifold/contact_recycling.h"
#include "pair/pair_patch.h"
#include "pair/pair_state.h"
#include "pair_outcome.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whether an app's own result gets the nearest point of a pair alone, as from Bullet's own algorithm. Polyhedra whose
/// features it has initialized have more, and so does the contact table of a world that steps.
bool GetsNearestOnly(const PairCall& call, bool is_for_step);

/// @return whether the cached contacts are still those of the pair, and up to date.
bool UpdateRecycledContacts(PairState& pair, const RecycledContacts::Side& a, const RecycledContacts::Side& b,
                            const PairCall& call);

/// Updates the contacts of the last steps, if neither body has moved since they were found, or both have together, and
/// nothing else that they depend on has changed. A user's own query never gets them.
/// @param a, b  The bodies in the order that their shapes are solved in.
inline std::optional<PairOutcome> TryRecycledContacts(PairState& pair, const RecycledContacts::Side& a,
                                                      const RecycledContacts::Side& b, const PairCall& call) {
  if (!pair.is_recyclable) return std::nullopt;
  pair.is_recyclable = UpdateRecycledContacts(pair, a, b, call);
  if (!pair.is_recyclable) return std::nullopt;
  const auto points = static_cast<std::uint8_t>(pair.manifold->getNumContacts());
  return PairOutcome{.patch_size = points, .stage = PairOutcome::Stage::kRecycled};
}

/// Makes the manifold's points those of the patch, and caches them for the first stage of the next step.
/// @param is_swapped  Whether the shapes are solved in the other order than the manifold's.
/// @param outcome     That of the stage that has found the contacts.
/// @return it, or that there is no memory.
PairOutcome WriteContacts(PairState& pair, const PairCall& call, const PairContacts& contacts, bool is_swapped,
                          const PairOutcome& outcome);

/// Solves a pair by Bullet's own algorithm if that has a result, and else leaves the pair without contacts.
/// @return the reason why no other stage has solved it, or that there is no memory.
PairOutcome SolveByBullet(PairState& pair, const PairCall& call, Fallback reason);

/// What `solve`, PairOutcome(), returns; or the reason if it throws, without memory for a hull, or for a shape that is
/// none: with sizes that are not finite, or without points.
template <class Solve>
PairOutcome CatchFailures(const Solve& solve) try {
  return solve();
} catch (const std::bad_alloc&) {
  return {.fallback = Fallback::kNoMemory};
} catch (const std::exception&) {
  return {.fallback = Fallback::kInvalid};
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
