#include "hull_cache.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <cstring>
#include <mutex>

#include "shape_points.h"

namespace dgd_bullet {
namespace {

/// Hulls up to this size, in bytes of their points, are compared whole, in about 20 ns.
constexpr std::size_t kComparedBytes = 1024;
/// Points compared of larger ones.
constexpr int kSamples = 16;

bool IsComparedWhole(const ShapePoints& points) {
  return points.Bytes() != nullptr && points.ByteSize() <= kComparedBytes;
}

/// Index of the i-th sample out of `count` points.
int SampleIndex(int i, int count) { return static_cast<int>(static_cast<long long>(i) * count / kSamples); }

std::vector<unsigned char> CopyBytes(const ShapePoints& points) {
  if (!IsComparedWhole(points)) return {};
  return {points.Bytes(), points.Bytes() + points.ByteSize()};
}

std::vector<Vector3> CopySamples(const ShapePoints& points) {
  std::vector<Vector3> samples;
  if (IsComparedWhole(points) || points.Count() == 0) return samples;
  for (int i = 0; i < kSamples; ++i) samples.push_back(points[SampleIndex(i, points.Count())]);
  return samples;
}

}  // namespace

CachedHull::CachedHull(const btConvexShape& shape)
    : shape_(&shape),
      count_(ShapePoints(shape).Count()),
      scaling_(ShapePoints(shape).Scaling()),
      bytes_(CopyBytes(ShapePoints(shape))),
      samples_(CopySamples(ShapePoints(shape))),
      core_(AllPoints(shape)) {}

bool CachedHull::Matches(const btConvexShape& shape) const {
  if (&shape != shape_) return false;
  const ShapePoints points(shape);
  if (points.Count() != count_ || !(points.Scaling() == scaling_)) return false;
  if (!bytes_.empty()) {
    return points.ByteSize() == bytes_.size() && std::memcmp(points.Bytes(), bytes_.data(), bytes_.size()) == 0;
  }
  for (int i = 0; i < static_cast<int>(samples_.size()); ++i) {
    // False for NaN: such a shape is never cached.
    if (!(points[SampleIndex(i, count_)] == samples_[static_cast<std::size_t>(i)])) return false;
  }
  return true;
}

std::shared_ptr<const CachedHull> HullCache::Find(const btConvexShape& shape) {
  {
    const std::shared_lock lock(mutex_);
    const auto found = hulls_.find(&shape);
    if (found != hulls_.end() && found->second->Matches(shape)) return found->second;
  }
  auto hull = std::make_shared<const CachedHull>(shape);
  const std::unique_lock lock(mutex_);
  hulls_[&shape] = hull;
  if (hulls_.size() >= prune_at_) Prune();
  return hull;
}

void HullCache::Prune() {
  std::erase_if(hulls_, [](const auto& entry) { return entry.second.use_count() == 1; });
  prune_at_ = std::max<std::size_t>(64, 2 * hulls_.size());
}

}  // namespace dgd_bullet
