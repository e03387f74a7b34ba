// Prefetching what will be used soon. There may be nothing at the address any more.
#pragma once

#include <cstddef>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet::inline DGD_BULLET_PRECISION {

namespace prefetch_internal {

/// @tparam kToWrite  Whether to use the processor's instruction for writing.
template <bool kToWrite>
void PrefetchLines(const void* begin, std::size_t bytes) {
  constexpr std::size_t kLine = 64;
  for (std::size_t at = 0; at < bytes; at += kLine) {
    __builtin_prefetch(static_cast<const char*>(begin) + at, kToWrite ? 1 : 0);
  }
}

}  // namespace prefetch_internal

/// Prefetches what will most likely be written to.
inline void PrefetchToWrite(const void* begin, std::size_t bytes) {
  prefetch_internal::PrefetchLines<true>(begin, bytes);
}

/// Prefetches what other threads may read as well.
inline void PrefetchToRead(const void* begin, std::size_t bytes) {
  prefetch_internal::PrefetchLines<false>(begin, bytes);
}

}  // namespace dgd_bullet::inline DGD_BULLET_PRECISION
