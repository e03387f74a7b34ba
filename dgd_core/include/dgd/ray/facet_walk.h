// Polytopes' queries without a frame: from a triangle that the ray passes through to the facet that it leaves by.
//
// It is the paper's simplex method (Alg. 2) with nothing kept but the three corners of the inner approximation, in the
// world's coordinates. A step takes the corners' plane, a support point beyond it, and the one of three triangles with
// that point that the ray passes through: 0.6 of the time of a step of RayIntersection, which bounds, weighs and
// remembers as it goes, and takes fewer steps for that (tests/bench/iterations). Where the walk ends is weighed once.
// What is thin or steep there, or leaves by a rounded edge, is RayIntersection's, which weighs with care.
//
// Two ways to begin:
//  * Where the last query ended. From frame to frame most pairs keep their facet, or leave by one nearby; where the ray
//    passes beside it, a point beyond the side that it crosses takes a corner's place.
//  * Anew, without a radius, in the ball about the centre that is inside the difference (Alg. 1), and from three
//    directions about the ray: of large hulls, in a metric in which they are about as long as wide.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dgd/query_types.h"
#include "dgd/ray/inner_approximation.h"
#include "dgd/ray/minkowski_difference.h"
#include "dgd/ray/tolerances.h"

namespace dgd {

template <class Set1, class Set2>
class FacetWalk {
 public:
  using Difference = MinkowskiDifference<Set1, Set2>;
  using S = typename Difference::S;
  using Point = Vector3<S>;
  static_assert(Difference::kIsPolytope && Difference::L == 3);

  /// Evaluations of the support functions at most. From the last facet, by measurement: with half as many, warm queries
  /// of hulls of 2000 vertices take 1.4 times as long on average. Anew, meshes of up to 4516 vertices take 27 in one of
  /// a hundred queries.
  static constexpr int kMostFromLast = 8;
  static constexpr int kMostAnew = 32;

  FacetWalk(const Set1& set_1, const Pose<S>& pose_1, const Set2& set_2, const Pose<S>& pose_2)
      : set_1_(set_1),
        pose_1_(pose_1),
        set_2_(set_2),
        pose_2_(pose_2),
        // Far from the world's origin, the centres have lost digits that this has.
        ray_((pose_2.translation - pose_1.translation) +
             (pose_2.rotation * set_2.core.Center() - pose_1.rotation * set_1.core.Center())),
        radius_(set_1.radius + set_2.radius) {}

  /// @param state  In and out: three points of a last query. If this fails, it names three to start from all the same.
  /// @return whether the result is optimal; if not, it is of no use.
  bool SolveFromLast(const Settings<S>& settings, WarmStart<S>& state, Result<S>& result) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius() + radius_;
    if (!IsInRange(ray_.norm(), inradius) || !TakeCorners(state)) return false;
    const bool is_solved = StepOntoRay() && Walk(settings, kMostFromLast, result);
    RememberCorners(state);
    if (is_solved) state.normal_1 = Normal1(result);
    return is_solved;
  }

  /// Without a radius, and for a distance: sets that may be apart by more than is asked for are most often known to be
  /// after one direction, which RayIntersection bounds from both sides.
  /// @param state  Out, if there is one.
  /// @return as above.
  bool SolveAnew(const Settings<S>& settings, WarmStart<S>* state, Result<S>& result) {
    const S inradius = set_1_.core.Inradius() + set_2_.core.Inradius(), length = ray_.norm();
    const bool may_end_apart = settings.separation_limit < std::numeric_limits<S>::infinity();
    if (radius_ != 0 || may_end_apart || !IsInRange(length, inradius)) return false;
    const Point axis = ray_ / length;
    PutCornersInBall(inradius, axis);
    const bool is_skewed = settings.likely_start && (IsLargeAndSkewed(set_1_.core) || IsLargeAndSkewed(set_2_.core));
    if (!(is_skewed ? SurroundRayStretched(axis) : SurroundRay(axis, NoStretch()))) return false;
    normal_ = NormalOfCorners();
    if (!Walk(settings, kMostAnew, result)) return false;
    if (state != nullptr) {
      RememberCorners(*state);
      state->normal_1 = Normal1(result);
      state->size = 3;
      state->known_size = 0;
    }
    return true;
  }

  int Iterations() const { return iterations_; }

 private:
  struct Corner {
    Point point;  ///< Of the cores' difference about its centre; world, metres.
    FeatureId feature_1, feature_2;
  };

  static bool IsInRange(S length, S inradius) {
    return inradius > 0 && length > kCoincidence<S> * inradius && dgd::IsInRange(length, inradius);
  }

  Point FromCenter1(FeatureId feature) const {
    return pose_1_.rotation * (set_1_.core.Vertex(feature) - set_1_.core.Center());
  }
  Point FromCenter2(FeatureId feature) const {
    return pose_2_.rotation * (set_2_.core.Vertex(feature) - set_2_.core.Center());
  }

  bool TakeCorners(const WarmStart<S>& state) {
    for (std::size_t i = 0; i < 3; ++i) {
      const FeatureId feature_1 = state.features_1[i], feature_2 = state.features_2[i];
      if (feature_1 >= set_1_.core.VertexCount() || feature_2 >= set_2_.core.VertexCount()) return false;
      corners_[i] = {FromCenter1(feature_1) - FromCenter2(feature_2), feature_1, feature_2};
    }
    hint_1_ = corners_[0].feature_1;
    hint_2_ = corners_[0].feature_2;
    return true;
  }

  void PutCornersInBall(S inradius, const Point& axis) {
    constexpr S kShare1 = 1;  // Of no account: corners that are no vertices are not reported.
    const auto facet = InnerApproximation<S, 3>::FromInradius(inradius, kShare1);
    const Matrix3<S> frame = FrameAlong<S>(axis);
    for (int i = 0; i < 3; ++i) {
      corners_[static_cast<std::size_t>(i)] = {frame * facet[i].point, kNoFeature, kNoFeature};
    }
  }

  Corner CornerAlong(const Point& direction) {
    ++iterations_;
    const SupportPoint<S> support_1 =
        SupportNear(set_1_.core, Point(pose_1_.rotation.transpose() * direction), hint_1_);
    const SupportPoint<S> support_2 =
        SupportNear(set_2_.core, Point(pose_2_.rotation.transpose() * -direction), hint_2_);
    Corner corner;
    corner.point.noalias() = pose_1_.rotation * (support_1.point - set_1_.core.Center());
    corner.point.noalias() -= pose_2_.rotation * (support_2.point - set_2_.core.Center());
    corner.feature_1 = support_1.feature;
    corner.feature_2 = support_2.feature;
    return corner;
  }

  Point NormalOfCorners() const {
    return (corners_[1].point - corners_[0].point).cross(corners_[2].point - corners_[0].point);
  }

  /// From a triangle that the ray may pass beside to one that it passes through.
  bool StepOntoRay() {
    for (;;) {
      FindPlane();
      if (!IsSound()) return false;
      const int across = CornerAcross();
      if (across < 0) return is_weighed_ = true;
      // Of rounded sets, the ray mostly leaves by the edge itself.
      if (radius_ > 0 || iterations_ >= kMostFromLast || !StepOver(static_cast<std::size_t>(across))) return false;
    }
  }

  /// The metric in which a set's spread is a ball: lengths are those of T x, where T T is the inverse of the spread.
  class Stretch {
   public:
    explicit Stretch(const Matrix3<S>& spread) : spread_(spread) {
      const auto x = spread.col(0), y = spread.col(1), z = spread.col(2);
      inverse_ << y.cross(z), z.cross(x), x.cross(y);
      volume_sq_ = x.dot(inverse_.col(0));
      inverse_ /= volume_sq_;
    }

    Point Inverse(const Point& vector) const { return inverse_ * vector; }
    Point Spread(const Point& vector) const { return spread_ * vector; }
    /// Of a vector and Inverse() of it.
    S LengthSq(const Point& vector, const Point& inverse) const { return vector.dot(inverse); }
    /// By which a cross product grows, if one factor has unit length there.
    S Turn(S length_sq) const { return 1 / std::sqrt(volume_sq_ * length_sq); }

   private:
    Matrix3<S> spread_, inverse_;
    S volume_sq_;
  };

  /// Of a set that is a ball.
  struct NoStretch {
    Point Inverse(const Point& vector) const { return vector; }
    Point Spread(const Point& vector) const { return vector; }
    S LengthSq(const Point&, const Point&) const { return 1; }  // Of the ray's axis.
    S Turn(S) const { return 1; }
  };

  /// Whether a core is large and much longer than wide. Of the eigenvalues, the squares' mean over the mean's square: 1
  /// for a ball, 1.6 for half widths as 1 to 1.7 to 3, 3 for a needle.
  template <class Core>
  static bool IsLargeAndSkewed(const Core& core) {
    constexpr VertexId kLarge = 64;
    constexpr S kSkewed = S(1.2);
    if (core.VertexCount() <= kLarge) return false;
    if constexpr (SpreadCore<Core>) {
      const Matrix3<S>& spread = core.Spread();
      return 3 * spread.squaredNorm() > kSkewed * spread.trace() * spread.trace();
    } else {
      return false;
    }
  }

  /// Of large skewed hulls, by the measure of the sets' spread: with 241 and 2000 vertices, ten times as long as thick,
  /// they take 0.74 of the directions. It takes as long as one of these, or two of small hulls, which would save one.
  /// Not inlined: with its registers, round hulls take a tenth longer.
  [[gnu::noinline, gnu::flatten]] bool SurroundRayStretched(const Point& axis) {
    Matrix3<S> spread = pose_1_.rotation * SpreadOf(set_1_.core) * pose_1_.rotation.transpose();
    spread += pose_2_.rotation * SpreadOf(set_2_.core) * pose_2_.rotation.transpose();
    spread /= spread.trace();
    // Rounding leaves no inverse of what is flat.
    const bool is_sound = spread.determinant() > kEpsilon<S> * kEpsilon<S>;
    return is_sound ? SurroundRay(axis, Stretch(spread)) : SurroundRay(axis, NoStretch());
  }

  /// Along the ray, and then twice tilted to the far side of the ray from what was found: by more where that was far
  /// away. With three corners near the ray, hulls of 14, 32, 241 and 2000 vertices take 3, 9, 19 and 20 % fewer
  /// directions than with normals from the ball on; with a spread of 1.2 or 2 up to 6 % more than with this one.
  /// @param metric  All of this is in its lengths; a direction there is T times that here.
  /// @return false where rounding leaves no triangle about the ray.
  template <class Metric>
  bool SurroundRay(const Point& axis, const Metric& metric) {
    constexpr S kSpread = S(1.5);
    // With twice and four times as much, hulls of 241 vertices, ten times as long as thick, take 1 and 3 % more.
    constexpr S kNearSq = S(0.5);
    const Point along = metric.Inverse(axis);
    const S length_sq = metric.LengthSq(axis, along);
    if (!(length_sq > 0)) return false;
    const Corner first = CornerAlong(along);
    const S height = along.dot(first.point) / length_sq;
    const Point beside = first.point - height * axis;
    const Point aside = metric.Inverse(beside);
    // Of skewed sets, what is farthest along the ray is far from it, and so is what is found like that.
    if (beside.dot(aside) > kNearSq * height * height * length_sq) return Exchange(first);
    const Corner second = CornerAlong(height * along - kSpread * aside);
    const S turn = metric.Turn(length_sq);
    const Point across = turn * axis.cross(second.point - first.point);
    const S width_sq = across.dot(metric.Spread(across)), side = across.dot(first.point);
    if (!Exchange(first) || !Exchange(second)) return false;
    if (!(width_sq > kEpsilon<S> * height * height * length_sq)) return true;
    // Half the line's length at least, where that nearly meets the ray.
    const S tilt = kSpread * std::max(std::abs(side) / width_sq, S(0.5));
    return Exchange(CornerAlong(height * along - std::copysign(tilt, side) * across));
  }

  /// From corners that the ray passes between, and their normal.
  bool Walk(const Settings<S>& settings, int most_iterations, Result<S>& result) {
    for (;;) {
      S height = normal_.dot(corners_[0].point);
      if (radius_ > 0) height += radius_ * normal_.norm();
      if (!(height > 0)) return false;  // The same corner twice: there is no normal.
      const Corner farthest = CornerAlong(normal_);
      const S rise = normal_.dot(farthest.point - corners_[0].point);
      if (rise <= settings.relative_tolerance * height) return Report(settings, rise, result);
      if (iterations_ >= most_iterations || !Exchange(farthest)) return false;
      normal_ = NormalOfCorners();
    }
  }

  /// Of the triangles that the new corner makes with two of the old ones, takes the one that the ray passes through.
  /// @return false, and the corners as they were, where rounding leaves none.
  bool Exchange(const Corner& added) {
    const Point across = ray_.cross(added.point);
    const S turn_0 = across.dot(corners_[0].point), turn_1 = across.dot(corners_[1].point),
            turn_2 = across.dot(corners_[2].point);
    if (turn_0 >= 0 && turn_1 <= 0) {
      corners_[2] = added;
    } else if (turn_1 >= 0 && turn_2 <= 0) {
      corners_[0] = added;
    } else if (turn_2 >= 0 && turn_0 <= 0) {
      corners_[1] = added;
    } else {
      return false;
    }
    is_weighed_ = false;
    return true;
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
  bool StepOver(std::size_t corner) {
    const Point &a = corners_[(corner + 1) % 3].point, &b = corners_[(corner + 2) % 3].point;
    const Point outwards = b.cross(a);
    const Point side = b - a;
    const S width = length_ / side.norm();
    const S tilt = kTilt * width / std::sqrt(std::min(a.squaredNorm(), b.squaredNorm()));
    const Corner added = CornerAlong(normal_ / length_ + tilt / outwards.norm() * outwards);
    if (!(outwards.dot(added.point) > 0)) return false;
    corners_[corner] = added;
    return true;
  }

  /// Whether the ray is certain to leave between the corners, which are vertices.
  bool LeavesByFacet() {
    if (is_weighed_) return true;
    for (const Corner& corner : corners_) {
      if (corner.feature_1 == kNoFeature) return false;
    }
    FindPlane();
    return IsSound() && CornerAcross() < 0;
  }

  bool HasInterior() const {
    return HasCertainInterior(set_1_, set_2_, set_1_.core.Vertex(corners_[0].feature_1),
                              set_2_.core.Vertex(corners_[0].feature_2));
  }

  /// Not inlined: with its registers, a walk takes a tenth longer.
  /// @param rise  Of the sets' support value over the plane of the corners, times the normal's length.
  [[gnu::noinline]] bool Report(const Settings<S>& settings, S rise, Result<S>& result) {
    if (!LeavesByFacet() || !HasInterior()) return false;
    if (along_ - height_ - rise > settings.separation_limit * length_) return false;
    const Point normal = normal_ / length_;
    const auto middle = [&](const auto& core, FeatureId Corner::*feature) {
      Point sum = weights_[0] * core.Vertex(corners_[0].*feature);
      for (std::size_t i = 1; i < 3; ++i) sum += weights_[i] * core.Vertex(corners_[i].*feature);
      return sum;
    };
    const Point on_1 = pose_1_.rotation * middle(set_1_.core, &Corner::feature_1) + set_1_.radius * normal;
    const Point on_2 = pose_2_.rotation * middle(set_2_.core, &Corner::feature_2) - set_2_.radius * normal;
    const S support = height_ + rise;
    result.normal = normal;
    result.separation = (along_ - support) / length_;
    result.upper_bound = along_ / height_;
    result.lower_bound = along_ / std::max(support, height_);
    result.witness_1 = pose_1_.translation + on_1;
    result.witness_2 = pose_2_.translation + on_2;
    result.iterations = iterations_;
    result.status = Status::kOptimal;
    return IsFinite(result);
  }

  void RememberCorners(WarmStart<S>& state) const {
    for (std::size_t i = 0; i < 3; ++i) {
      state.features_1[i] = corners_[i].feature_1;
      state.features_2[i] = corners_[i].feature_2;
    }
  }

  Point Normal1(const Result<S>& result) const { return (pose_1_.rotation.transpose() * result.normal).normalized(); }

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
  const Point ray_;  // From centre 1 to centre 2, world.
  const S radius_;
  std::array<Corner, 3> corners_;
  FeatureId hint_1_ = kNoFeature, hint_2_ = kNoFeature;
  Point normal_;             // Of the corners, as long as twice the triangle's area.
  bool is_weighed_ = false;  // The ray leaves between the corners, with these weights. What follows is of them, too:
  std::array<S, 3> weights_;
  Point side_1_, side_2_;
  S along_, height_;  // Products of the normal with the ray, and with a point of the plane; with the radius.
  S length_sq_, length_;
  int iterations_ = 0;
};

}  // namespace dgd
