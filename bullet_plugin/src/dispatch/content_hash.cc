#include "dispatch/content_hash.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

#include "pair/separating_axis.h"
#include "shapes/shape_identity.h"
#include "shapes/shape_points.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

/// FNV-1a by words of eight bytes, whose upper bits are also mixed into the lower ones: the signs of two coordinates
/// would cancel else.
std::uint64_t Mix(std::uint64_t hash, std::span<const unsigned char> bytes) {
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof(word), bytes.size() - at));
    hash = (hash ^ word) * 0x100000001b3U;
    hash ^= hash >> 32;
  }
  return hash;
}

template <class Numbers>
std::uint64_t MixNumbers(std::uint64_t hash, const Numbers& numbers) {
  return Mix(hash, {reinterpret_cast<const unsigned char*>(&numbers), sizeof(numbers)});
}

}  // namespace

std::uint64_t ContentHash(const btCollisionShape& shape) {
  if (!shape.isConvex() || !ShapeIdentity::IsComparable(shape)) return 0;
  std::uint64_t hash = MixNumbers(0xcbf29ce484222325U, ShapeIdentity(shape).numbers());
  const auto& convex = static_cast<const btConvexShape&>(shape);
  if (IsHullOfPoints(convex)) {
    const ShapePoints points(convex);
    if (points.Count() < 1 || points.Count() > kMaxScannedPoints) return 0;
    hash = MixNumbers(Mix(hash, points.Bytes()), points.Scaling());
  }
  return hash != 0 ? hash : 1;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
