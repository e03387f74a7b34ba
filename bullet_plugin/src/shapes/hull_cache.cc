#include "shapes/hull_cache.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <mutex>
#include <utility>

#include "dgd/assert.h"
#include "prefetch.h"
#include "shapes/shape_points.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {
namespace {

std::vector<unsigned char> CopyBytes(const ShapePoints& points) {
  if (points.Bytes() == nullptr) return {};
  return {points.Bytes(), points.Bytes() + points.ByteSize()};
}

std::vector<Vector3> CopyPoints(const ShapePoints& points) {
  std::vector<Vector3> copies;
  if (points.Bytes() != nullptr) return copies;
  for (int i = 0; i < points.Count(); ++i) copies.push_back(points[i]);
  return copies;
}

/// Without facets where that is enough.
dgd::ConvexHull FirstHullOf(const std::vector<Vector3>& points) {
  std::optional<dgd::ConvexHull> hull = dgd::HullWithoutFacets(points);
  return hull ? *std::move(hull) : dgd::BuildConvexHull(points);
}

/// Queries of a hull without facets, at least. With 64 on average, these and the facets cost a fall of the fifty
/// polytopes 1 % more than facets from the start (dispatcher_replay); with twice as many 3 %; with three quarters of
/// them, the facets of many come within the first frame of a fracture (first_query).
constexpr int kScannedQueries = 24;
/// Hulls that are made together, as the pieces of a fracture are, are queried equally often: their facets are spread
/// over so many queries more.
constexpr unsigned kSpread = 80;

/// Where this thread keeps the hull that it last found for the shape, or for another in its place. Of whichever cache:
/// a hull that matches a shape is the shape's.
std::weak_ptr<const CachedHull>& LastFound(const btConvexShape& shape) {
  constexpr std::size_t kPlaces = 64;  // A kilobyte a thread, for the shapes of a compound and what meets it.
  thread_local std::array<std::weak_ptr<const CachedHull>, kPlaces> places;
  // Shapes lie on the heap, some hundred bytes apart.
  const auto address = reinterpret_cast<std::uintptr_t>(&shape);
  return places[(address >> 4 ^ address >> 10) % kPlaces];
}

}  // namespace

CachedHull::CachedHull(const btConvexShape& shape, int scanned_queries)
    : shape_(&shape),
      count_(ShapePoints(shape).Count()),
      scaling_(ShapePoints(shape).Scaling()),
      bytes_(CopyBytes(ShapePoints(shape))),
      points_(CopyPoints(ShapePoints(shape))),
      first_core_(FirstHullOf(AllPoints(shape))),
      scanned_queries_(scanned_queries) {}

bool CachedHull::Matches(const btConvexShape& shape) const {
  if (&shape != shape_) return false;
  const ShapePoints points(shape);
  DGD_ASSERT(bytes_.empty() || points_.empty());
  if (points.Count() != count_ || !(points.Scaling() == scaling_)) return false;
  if (!bytes_.empty()) {
    // Another type of shape, which has no array, may have taken the address.
    return points.Bytes() != nullptr && points.ByteSize() == bytes_.size() &&
           std::memcmp(points.Bytes(), bytes_.data(), bytes_.size()) == 0;
  }
  for (int i = 0; i < count_; ++i) {
    // False for NaN: such a shape is never cached.
    if (!(points[i] == points_[static_cast<std::size_t>(i)])) return false;
  }
  return true;
}

const dgd::Polytope<double>& CachedHull::CoreOfNewHull(HullUse use) const {
  const auto build = [this] {
    try {
      core_with_facets_.emplace(dgd::WithFacets(first_core_.Hull()));
      core_.store(&*core_with_facets_, std::memory_order_release);
    } catch (const std::exception&) {
      // Without memory, or where Qhull fails, the points are scanned as before.
    }
  };
  const bool is_large = first_core_.VertexCount() > dgd::kMostScannedVertices;
  const bool is_full = queries_.fetch_add(1, std::memory_order_relaxed) == scanned_queries_;
  if (is_full || (is_large && use == HullUse::kStep)) std::call_once(facets_are_built_, build);
  return *core_.load(std::memory_order_acquire);
}

void CachedHull::Prefetch() const {
  const dgd::ConvexHull& hull = core_.load(std::memory_order_acquire)->Hull();
  // A query of a large hull reads little of it.
  if (hull.vertices.size() > dgd::kMostScannedVertices) return;
  const auto prefetch = [](const auto& array) { PrefetchToRead(array.data(), array.size() * sizeof(array[0])); };
  prefetch(hull.vertex_start);
  prefetch(hull.vertex_facets);
  prefetch(hull.normals);
  prefetch(hull.facet_start);
  prefetch(hull.facet_vertices);
  prefetch(hull.vertices);
}

std::shared_ptr<const CachedHull> HullCache::Find(const btConvexShape& shape) {
  std::weak_ptr<const CachedHull>& last_found = LastFound(shape);
  std::shared_ptr<const CachedHull> hull = last_found.lock();
  if (hull == nullptr || !hull->Matches(shape)) {
    hull = FindShared(shape);
    last_found = hull;
  }
  return hull;
}

std::shared_ptr<const CachedHull> HullCache::FindShared(const btConvexShape& shape) {
  {
    const std::shared_lock lock(mutex_);
    const auto found = hulls_.find(&shape);
    if (found != hulls_.end() && found->second->Matches(shape)) return found->second;
  }
  const unsigned later = hulls_made_.fetch_add(1, std::memory_order_relaxed) % kSpread;
  auto hull = std::make_shared<const CachedHull>(shape, kScannedQueries + static_cast<int>(later));
  const std::unique_lock lock(mutex_);
  DGD_ASSERT(hull->Matches(shape));
  hulls_[&shape] = hull;
  if (hulls_.size() >= prune_at_) Prune();
  return hull;
}

void HullCache::Prune() {
  std::erase_if(hulls_, [](const auto& entry) { return entry.second.use_count() == 1; });
  prune_at_ = std::max<std::size_t>(64, 2 * hulls_.size());
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
