// What one query of two convex shapes leaves for the next one.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "dgd/assert.h"
#include "dgd/contact/reference_face.h"
#include "dgd/query_types.h"
#include "dgd_bullet/linkage.h"
#include "shapes/hull_cache.h"
#include "shapes/solver_types.h"

namespace dgd_bullet {
inline namespace DGD_BULLET_PRECISION {

/// The feature that proved the last query's result, with its data, and the shapes' hulls; all in the order that the
/// shapes are solved in (ComesBefore()). A cache that does not fit the shapes any more costs time, and no result is
/// wrong.
class PairCache {
 public:
  using Hull = std::shared_ptr<const CachedHull>;

  /// Which stage of the pipeline is the next one to try first.
  enum class Kind : std::uint8_t {
    kNothing,         ///< A new pair, or one without a warm start.
    kSeparatingAxis,  ///< The last normal, along which the cores are, or may be, apart.
    kDistancePoints,  ///< The points that the last distance ended at, for UpdateDistance().
    kReferenceFace,   ///< The face of one shape that is across the last normal.
    kPortal,          ///< The growth distance's basis, of curved cores that overlap: no distance goes on from there.
  };

  Kind kind() const { return kind_; }
  /// The shape that has the reference face, if there is one.
  dgd::ReferenceSide ReferenceSide() const {
    DGD_ASSERT((side_ != dgd::ReferenceSide::kNone) == (kind_ == Kind::kReferenceFace));
    return side_;
  }
  /// Whether UpdateDistance() may go on from here.
  bool CanUpdateDistance() const { return kind_ != Kind::kPortal; }
  /// Whether the last normal may separate the shapes again. That of a reference face is updated with the face.
  bool HasAxis() const { return kind_ != Kind::kReferenceFace && dgd::HasNormal(warm_start_); }
  /// The last normal in shape A's frame; unit, if HasAxis().
  const Vector3& NormalInA() const {
    DGD_ASSERT(HasNormal());
    return warm_start_.normal_1;
  }
  bool HasNormal() const { return dgd::HasNormal(warm_start_); }
  dgd::WarmStart<double>& warm_start() { return warm_start_; }
  const dgd::WarmStart<double>& warm_start() const { return warm_start_; }

  /// @param kind  Any but kReferenceFace.
  void Set(Kind kind) {
    DGD_ASSERT(kind != Kind::kReferenceFace);
    kind_ = kind;
    side_ = dgd::ReferenceSide::kNone;
  }
  /// Sets the reference face to that of `side`.
  /// @param otherwise  The kind if that is no side.
  void SetReferenceFace(dgd::ReferenceSide side, Kind otherwise) {
    if (side == dgd::ReferenceSide::kNone) return Set(otherwise);
    kind_ = Kind::kReferenceFace;
    side_ = side;
  }
  /// Forgets everything but the hulls.
  void Clear() {
    Set(Kind::kNothing);
    warm_start_ = {};
  }

  /// Whether the shapes are solved in the other order than Bullet's.
  bool IsSwapped() const { return is_swapped_; }
  /// Exchanges the roles of A and B.
  /// @param pose_a, pose_b  Of the sets, in the new order.
  void SwapOrder(const Pose& pose_a, const Pose& pose_b) {
    is_swapped_ = !is_swapped_;
    std::swap(hull_a_, hull_b_);
    std::swap(warm_start_.features_1, warm_start_.features_2);
    warm_start_.normal_1 = (-pose_a.rotation.transpose() * (pose_b.rotation * warm_start_.normal_1)).normalized();
    side_ = Swapped(side_);
  }

  Hull& hull_a() { return hull_a_; }
  Hull& hull_b() { return hull_b_; }

 private:
  Kind kind_ = Kind::kNothing;
  dgd::ReferenceSide side_ = dgd::ReferenceSide::kNone;  // kNone unless kReferenceFace.
  bool is_swapped_ = false;
  Hull hull_a_, hull_b_;
  dgd::WarmStart<double> warm_start_;
};

}  // namespace DGD_BULLET_PRECISION
}  // namespace dgd_bullet
