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

/// The hull, without facets where that is enough.
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

}  // namespace

CachedHull::CachedHull(const btConvexShape& shape, const ShapePoints& points, int scanned_queries)
    : shape_(&shape),
      layout_(points.layout()),
      scaling_(points.Scaling()),
      bytes_(points.Bytes().begin(), points.Bytes().end()),
      first_core_(FirstHullOf(AllPoints(shape))),
      scanned_queries_(scanned_queries) {}

bool CachedHull::Matches(const btConvexShape& shape) const {
  if (&shape != shape_) return false;
  const ShapePoints points(shape);
  return points.layout() == layout_ && points.Scaling() == scaling_ &&
         std::memcmp(points.Bytes().data(), bytes_.data(), bytes_.size()) == 0;
}

const dgd::Polytope<double>& CachedHull::CoreOfNewHull(HullUse use) const {
  const auto build = [this] {
    try {
      core_with_facets_.emplace(dgd::WithFacets(first_core_.Hull()));
      core_.store(&*core_with_facets_, std::memory_order_release);
    } catch (const std::exception&) {
      // The points are scanned as before without memory, or where Qhull fails.
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
  const auto prefetch = [](const auto& array) { dgd_bullet::Prefetch(array.data(), array.size() * sizeof(array[0])); };
  prefetch(hull.vertex_start);
  prefetch(hull.vertex_facets);
  prefetch(hull.normals);
  prefetch(hull.facet_start);
  prefetch(hull.facet_vertices);
  prefetch(hull.vertices);
}

std::shared_ptr<const CachedHull> HullCache::Find(const btConvexShape& shape) {
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
