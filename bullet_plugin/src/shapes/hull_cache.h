// Hulls of Bullet's point shapes: built once per shape, shared between its pairs, found again by address and content.
//
// Bullet reports to nobody when a shape changes or dies, and a new one may take its address. A hull is therefore only
// used after its shape has been compared with what the hull was made from, point by point, which costs less than one
// evaluation of the support function.
//
// A new hull has no facets: its first queries scan its points. Facets of 20 points take 70 us, as long as some hundred
// queries without them, and many hulls live no longer: debris, shapes of a query, casts. So they are built once a hull
// has been queried often enough, by whichever thread does so then. Results stay the same to the last bit. Above
// dgd::kMostScannedVertices points they change by roundoff: there only an app's own queries do without facets, since a
// step's pairs, which threads may share, must not depend on each other. Flat and long hulls have facets from the start,
// which say where their centre may be (dgd::IsElongated()).
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <unordered_map>
#include <vector>

#include "bullet_conversions.h"
#include "dgd/shapes/polytope.h"
#include "dgd_bullet/linkage.h"
#include "shapes/shape_points.h"

class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// Whose query a hull is for.
enum class HullUse {
  kStep,  ///< A step's, whose result is the same to the last bit regardless of earlier queries.
  kApp    ///< An app's own.
};

class CachedHull {
 public:
  /// @param scanned_queries  Number of queries that are solved without facets.
  /// Throws std::invalid_argument if the shape has no points or one is not finite.
  CachedHull(const btConvexShape& shape, int scanned_queries)
      : CachedHull(shape, ShapePoints(shape), scanned_queries) {}

  /// Whether this was made from the shape as it is now.
  bool Matches(const btConvexShape& shape) const;

  /// The core for one query, which this counts; valid as long as this is.
  const dgd::Polytope<double>& CoreForQuery(HullUse use) const {
    const dgd::Polytope<double>& core = *core_.load(std::memory_order_acquire);
    return HasFacets(core.Hull()) ? core : CoreOfNewHull(use);
  }

  /// Prefetches what a query of a small hull reads: to find the facet under a contact takes six reads, each of which
  /// gives the address of the next. A tenth of the narrowphase's time in a heap of 2000 hulls.
  void Prefetch() const;

 private:
  CachedHull(const btConvexShape& shape, const ShapePoints& points, int scanned_queries);
  const dgd::Polytope<double>& CoreOfNewHull(HullUse use) const;

  const btConvexShape* shape_;
  ShapePoints::Layout layout_;
  btVector3 scaling_;
  std::vector<unsigned char> bytes_;  // The points as they lie in memory.
  const dgd::Polytope<double> first_core_;
  const int scanned_queries_;
  mutable std::atomic<int> queries_ = 0;
  mutable std::once_flag facets_are_built_;
  mutable std::optional<const dgd::Polytope<double>> core_with_facets_;
  mutable std::atomic<const dgd::Polytope<double>*> core_ = &first_core_;
};

class HullCache {
 public:
  /// The hull of the shape as it is now. Thread-safe. Throws as CachedHull.
  std::shared_ptr<const CachedHull> Find(const btConvexShape& shape);

 private:
  /// Drops hulls that no pair holds once there are twice as many as after the last time: shapes that are gone cost
  /// memory for a while, never a wrong result.
  void Prune();

  std::shared_mutex mutex_;
  std::unordered_map<const btConvexShape*, std::shared_ptr<const CachedHull>> hulls_;
  std::size_t prune_at_ = 64;
  std::atomic<unsigned> hulls_made_ = 0;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
