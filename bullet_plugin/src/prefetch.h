// Prefetching what will be used soon. There may be nothing at the address any more.
#pragma once

#include <cstddef>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

constexpr std::size_t kCacheLine = 64;

/// Prefetches what will most likely be written to.
inline void PrefetchToWrite(const void* begin, std::size_t bytes) {
  for (std::size_t at = 0; at < bytes; at += kCacheLine) {
    __builtin_prefetch(static_cast<const char*>(begin) + at, 1);
  }
}

/// Prefetches what other threads may read as well.
inline void PrefetchToRead(const void* begin, std::size_t bytes) {
  for (std::size_t at = 0; at < bytes; at += kCacheLine) {
    __builtin_prefetch(static_cast<const char*>(begin) + at, 0);
  }
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
