// The time of impact of two moving convex shapes, behind the interface of btContinuousConvexCollision, btGjkConvexCast
// and btSubsimplexConvexCast.
//
//     dgd_bullet::ConvexCast cast(&shape_a, &shape_b);
//     btConvexCast::CastResult result;
//     if (cast.calcTimeOfImpact(from_a, to_a, from_b, to_b, result)) ...  // at result.m_fraction
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btConvexCast.h>

#include <memory>

#include "dgd_bullet/linkage.h"
#include "dgd_bullet/options.h"

class btConvexShape;

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The sweep of two shapes, which may both move and turn, along the path that Bullet's integrator would take from one
/// pose to the other. The result is never late: a fraction is given at which the shapes are no nearer than a twentieth
/// of a nanometre, and no farther apart than a tenth (more only where their coordinates, or Bullet's support function
/// of a custom shape, are not that exact).
class DGD_BULLET_EXPORT ConvexCast : public btConvexCast {
 public:
  /// The shapes must outlive this, and may change between casts. Only one thread at a time may use this.
  /// @param geometry  What their surfaces are.
  ConvexCast(const btConvexShape* shape_a, const btConvexShape* shape_b, GeometryMode geometry = GeometryMode::kBullet);
  ~ConvexCast() override;

  /// @return whether the shapes meet. Shapes that touch from the start and move apart do not, nor do any if a shape or
  ///         a pose is not finite.
  /// @param result  m_fraction in [0, 1], m_normal from B to A, and m_hitPoint on B, all in the world at that fraction.
  ///                m_allowedPenetration is unused: shapes are stopped before they penetrate.
  bool calcTimeOfImpact(const btTransform& from_a, const btTransform& to_a, const btTransform& from_b,
                        const btTransform& to_b, CastResult& result) override;

 private:
  struct Hulls;

  const btConvexShape* shape_a_;
  const btConvexShape* shape_b_;
  GeometryMode geometry_;
  std::unique_ptr<Hulls> hulls_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
