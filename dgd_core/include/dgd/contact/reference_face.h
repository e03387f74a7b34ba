// The reference face of a contact: that of the set whose face is across the normal.
#pragma once

#include <cstdint>

#include "dgd/contact/facing_faces.h"

namespace dgd {

/// The set whose face is across the contact's normal.
enum class ReferenceSide : std::uint8_t { kNone, kSet1, kSet2 };

/// @param facing  With its overlap.
template <class S>
ReferenceSide ReferenceSideOf(const FacingFaces<S>& facing) {
  return facing.is_across_1 ? ReferenceSide::kSet1 : facing.is_across_2 ? ReferenceSide::kSet2 : ReferenceSide::kNone;
}

}  // namespace dgd
