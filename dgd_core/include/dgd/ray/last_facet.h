// The facet of the Minkowski difference that the ray left by in the last query, tried before any frame is made.
//
// From frame to frame most pairs of polytopes keep that facet, or leave by one nearby. So its corners are put where
// they are now, and it is told in the world's coordinates whether the ray still passes between them and no point of
// either set is beyond their plane: one evaluation of the support functions, and half of the work of a query from its
// start. If a support point is beyond, it takes the place of a corner (Alg. 2 of the paper, for a triangle); where the
// ray passes beside them, a point beyond the side that it crosses does. What is thin or steep, and what leaves by a
// rounded edge, is the query's, which weighs it with care.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "dgd/query_types.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class LastFacet {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using S = typename Difference::S;
  using Point = Vector3<S>;
  static_assert(Difference::kIsPolytope && Difference::L == 3);

  /// Evaluations of the support functions at most. By measurement: with half as many, warm queries of hulls of 2000
  /// vertices take 1.4 times as long on average.
  static constexpr int kMostIterations = 8;

  LastFacet(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      : set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2),
        offset_1_(pose_1.rotation * set_1.core.Center()),
        offset_2_(pose_2.rotation * set_2.core.Center()),
        // Far from the world's origin, the centres have lost digits that this has.
        ray_((pose_2.translation - pose_1.translation) + (offset_2_ - offset_1_)),
        radius_(set_1.radius + set_2.radius) {}

  /// @param state  In and out. If this fails, it names three points to start from all the same.
  /// @return whether the result is optimal; if not, it is of no use.
  bool Solve(const Settings<S>& settings, WarmStart<S>& state, Result<S>& result) {
    if (!IsInRange() || !TakeCorners(state)) return false;
    if (!HasCertainInterior(set_1_, set_2_, corners_[0].on_1, corners_[0].on_2)) return false;
    while (iterations_ < kMostIterations) {
      FindPlane();
      if (!IsSound()) return false;
      if (const int across = CornerAcross(); across >= 0) {
        // Of rounded sets, the ray mostly leaves by the edge itself.
        if (radius_ > 0 || !StepOver(static_cast<std::size_t>(across), state)) return false;
        continue;
      }
      const Corner farthest = CornerAlong(normal_);
      const S top = normal_.dot(farthest.point) + radius_ * length_;
      if (top <= height_ * (1 + settings.relative_tolerance)) {
        if (along_ - top > settings.separation_limit * length_ || !Report(top, result)) return false;
        state.normal_1 = (pose_1_.rotation.transpose() * normal_).normalized();
        return true;
      }
      if (!Exchange(farthest, state)) return false;
    }
    return false;
  }

  int Iterations() const { return iterations_; }

 private:
  struct Corner {
    Point on_1, on_2;  ///< From the centres; world, metres.
    Point point;       ///< on_1 - on_2.
    FeatureId feature_1, feature_2;
  };

  bool IsInRange() const {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius() + radius_, length = ray_.norm();
    return inradius > 0 && length > kCoincidence<S> * inradius && dgd::IsInRange(length, inradius);
  }

  Corner MakeCorner(const Point& point_1, FeatureId feature_1, const Point& point_2, FeatureId feature_2) const {
    Corner corner{pose_1_.rotation * (point_1 - set_1_.core.Center()),
                  pose_2_.rotation * (point_2 - set_2_.core.Center()), Point(), feature_1, feature_2};
    corner.point = corner.on_1 - corner.on_2;
    return corner;
  }

  bool TakeCorners(const WarmStart<S>& state) {
    for (std::size_t i = 0; i < 3; ++i) {
      const FeatureId feature_1 = state.features_1[i], feature_2 = state.features_2[i];
      if (feature_1 >= set_1_.core.VertexCount() || feature_2 >= set_2_.core.VertexCount()) return false;
      corners_[i] = MakeCorner(set_1_.core.Vertex(feature_1), feature_1, set_2_.core.Vertex(feature_2), feature_2);
    }
    return true;
  }

  Corner CornerAlong(const Point& direction) {
    ++iterations_;
    const SupportPoint<S> support_1 =
        SupportNear(set_1_.core, Point(pose_1_.rotation.transpose() * direction), corners_[0].feature_1);
    const SupportPoint<S> support_2 =
        SupportNear(set_2_.core, Point(pose_2_.rotation.transpose() * -direction), corners_[0].feature_2);
    return MakeCorner(support_1.point, support_1.feature, support_2.point, support_2.feature);
  }

  /// Of the corners, towards the ray.
  void FindPlane() {
    side_1_ = corners_[1].point - corners_[0].point;
    side_2_ = corners_[2].point - corners_[0].point;
    normal_ = side_1_.cross(side_2_);
    along_ = normal_.dot(ray_);
    if (along_ < 0) {
      std::swap(corners_[1], corners_[2]);
      std::swap(side_1_, side_2_);
      normal_ = -normal_;
      along_ = -along_;
    }
    length_sq_ = normal_.squaredNorm();
    length_ = std::sqrt(length_sq_);
    height_ = normal_.dot(corners_[0].point) + radius_ * length_;
  }

  /// Whether plain products keep the digits of the plane, and of weights on it. False for NaN.
  bool IsSound() const {
    const S longest_sq = std::max({side_1_.squaredNorm(), side_2_.squaredNorm(), (side_2_ - side_1_).squaredNorm()});
    const bool is_fat = length_sq_ > kFat * kFat * longest_sq * longest_sq;
    const bool is_flat = along_ * along_ > kFlat * kFlat * length_sq_ * ray_.squaredNorm();
    return is_fat && is_flat && height_ > 0;
  }

  /// Finds where the ray meets the plane, by the corners' weights.
  /// @return -1 if it leaves between them, else the corner across the side that it passes beyond.
  int CornerAcross() {
    const Point from_first = height_ / along_ * ray_ - radius_ / length_ * normal_ - corners_[0].point;
    weights_[1] = normal_.dot(from_first.cross(side_2_)) / length_sq_;
    weights_[2] = normal_.dot(side_1_.cross(from_first)) / length_sq_;
    weights_[0] = 1 - weights_[1] - weights_[2];
    const auto least = std::ranges::min_element(weights_);
    return *least >= 0 ? -1 : static_cast<int>(least - weights_.begin());
  }

  /// To a triangle beyond the side across from a corner: of the side, and a point that is farthest along the normal
  /// tilted towards there.
  bool StepOver(std::size_t corner, WarmStart<S>& state) {
    const Point &a = corners_[(corner + 1) % 3].point, &b = corners_[(corner + 2) % 3].point;
    const Point outwards = b.cross(a);
    const Point side = b - a;
    const S width = length_ / side.norm();
    const S tilt = kTilt * width / std::sqrt(std::min(a.squaredNorm(), b.squaredNorm()));
    const Corner added = CornerAlong(normal_ / length_ + tilt / outwards.norm() * outwards);
    if (!(outwards.dot(added.point) > 0)) return false;
    Replace(corner, added, state);
    return true;
  }

  void Replace(std::size_t corner, const Corner& added, WarmStart<S>& state) {
    corners_[corner] = added;
    for (std::size_t i = 0; i < 3; ++i) {
      state.features_1[i] = corners_[i].feature_1;
      state.features_2[i] = corners_[i].feature_2;
    }
  }

  /// Of the triangles that the new corner makes with two of the old ones, takes the one that the ray passes through.
  bool Exchange(const Corner& added, WarmStart<S>& state) {
    const Point across = ray_.cross(added.point);
    std::array<S, 3> sides;
    for (std::size_t i = 0; i < 3; ++i) sides[i] = across.dot(corners_[i].point);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(sides[(i + 1) % 3] >= 0 && sides[(i + 2) % 3] <= 0)) continue;
      Replace(i, added, state);
      return true;
    }
    return false;
  }

  /// @param top  The support value along the normal, times its length.
  bool Report(S top, Result<S>& result) const {
    const Point normal = normal_ / length_;
    Point on_1 = set_1_.radius * normal, on_2 = -set_2_.radius * normal;
    for (std::size_t i = 0; i < 3; ++i) {
      on_1 += weights_[i] * corners_[i].on_1;
      on_2 += weights_[i] * corners_[i].on_2;
    }
    result.normal = normal;
    result.separation = (along_ - top) / length_;
    result.upper_bound = along_ / height_;
    result.lower_bound = along_ / std::max(top, height_);
    result.witness_1 = pose_1_.translation + offset_1_ + on_1;
    result.witness_2 = pose_2_.translation + offset_2_ + on_2;
    result.iterations = iterations_;
    result.status = Status::kOptimal;
    return IsFinite(result);
  }

  /// Twice the area over the longest side's square, and the normal's cosine to the ray. By their inverses, rounding is
  /// magnified.
  static constexpr S kFat = S(0.05), kFlat = S(0.05);
  /// Of the angle under which the facet's width is seen from the centre. By measurement: with 1, 2, 3 and 4 times as
  /// much, warm queries of hulls of 2000 vertices take 444, 370, 361 and 426 ns on average, of 241 240, 227, 234, 246.
  static constexpr S kTilt = S(2);

  const Set1& set_1_;
  const Pose<S>& pose_1_;
  const Set2& set_2_;
  const Pose<S>& pose_2_;
  const Point offset_1_, offset_2_;  // From the poses' origins to the centres, world.
  const Point ray_;                  // From centre 1 to centre 2.
  const S radius_;
  std::array<Corner, 3> corners_;
  Point side_1_, side_2_, normal_;  // The normal is as long as twice the triangle's area, and so are ...
  S along_, height_;                // ... its product with the ray, and its height over the centre; with the radius.
  S length_sq_, length_;
  std::array<S, 3> weights_;
  int iterations_ = 0;
};

}  // namespace dgd
