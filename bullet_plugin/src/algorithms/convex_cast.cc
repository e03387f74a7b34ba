#include "dgd_bullet/convex_cast.h"

#include "algorithms/shape_sweep.h"
#include "bullet_conversions.h"
#include "dgd/assert.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

struct ConvexCast::Hulls {
  HullCache cache;
  std::shared_ptr<const CachedHull> a, b;
};

ConvexCast::ConvexCast(const btConvexShape* shape_a, const btConvexShape* shape_b, GeometryMode geometry)
    : shape_a_(shape_a), shape_b_(shape_b), geometry_(geometry), hulls_(std::make_unique<Hulls>()) {}

ConvexCast::~ConvexCast() = default;

bool ConvexCast::calcTimeOfImpact(const btTransform& from_a, const btTransform& to_a, const btTransform& from_b,
                                  const btTransform& to_b, CastResult& result) {
  const MovingShape a{*shape_a_, from_a, to_a, hulls_->a}, b{*shape_b_, from_b, to_b, hulls_->b};
  const dgd::TimeOfImpactResult<double> impact = SweepShapes(a, b, geometry_, hulls_->cache, HullUse::kApp);
  if (!Meet(impact, a, b)) return false;
  DGD_ASSERT(impact.time >= 0 && impact.time <= 1 && IsUnit(impact.normal));
  result.m_fraction = RoundDown(impact.time);
  result.m_normal = ToBullet(-impact.normal);
  result.m_hitPoint = ToBullet(impact.witness_2);
  return true;
}

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
