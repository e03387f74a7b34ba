// Memory that will be used soon.
#pragma once

#include <cstddef>

#include "dgd_bullet/linkage.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Prefetches it, also where there is nothing at the address any more.
inline void Prefetch(const void* begin, std::size_t bytes) {
  constexpr std::size_t kCacheLine = 64;
  for (std::size_t at = 0; at < bytes; at += kCacheLine) __builtin_prefetch(static_cast<const char*>(begin) + at);
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
