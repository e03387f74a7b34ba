// Flat discs on curved cores: the caps of cylinders, the base of cones.
//
// A rim's support function r |d_xy| has a kink along the axis, and where the ray leaves C through the cap, that kink is
// the optimum: Newton's step never gets there, and cutting planes creep along the rim. But both the normal and the
// points are known at once. Close to the normal n0 the features' points run around the disc, so three of them give its
// centre and radius; if the ray passes within, n0 is the normal, and the triangle of rim points that has one corner
// where the way from the centre to the ray ends holds the ray: every ray through the disc passes the triangle that
// points at it.
#pragma once

#include <array>

#include "dgd/ray/inner_approximation.h"
#include "dgd/ray/minkowski_difference.h"

namespace dgd {

/// The disc of two features about a face normal.
template <class Difference>
class FlatFace {
 public:
  using S = typename Difference::S;
  static constexpr int L = Difference::L;
  using Point = Vector<S, L>;
  using Feature = DifferencePoint<S, L>;

  /// @param normal  Of the face, ray frame, unit length or zero.
  FlatFace(const Difference& difference, const Feature& features, const Point& normal)
      : difference_(difference), features_(features), normal_(normal) {}

  /// If the ray leaves C through the disc, gives three points of it around the ray.
  bool HoldsRay(std::array<Feature, L>& corners) const {
    if (!(normal_[L - 1] > kSteep<S>)) return false;
    const SquareMatrix<S, L> frame = FrameAlong<S>(normal_);
    corners = PointsAround(frame.col(0));
    const Point center = (corners[0].point + corners[1].point + corners[2].point) / S(3);
    const S rounding = difference_.Rounding();
    const Point on_ray = (normal_.dot(center) + rounding) / normal_[L - 1] * Point::Unit(L - 1);
    Point to_ray = on_ray - rounding * normal_ - center;
    to_ray -= to_ray.dot(normal_) * normal_;
    const S distance = to_ray.norm();
    if (!(distance <= (corners[0].point - center).norm())) return false;
    if (distance > 0) corners = PointsAround(to_ray / distance);
    return true;
  }

 private:
  /// How far from the face's normal the features are asked: little enough that other curves do not show, and enough
  /// for the direction around the rim to keep half its digits.
  static constexpr S kTilt = kSqrtEpsilon<S>;

  std::array<Feature, L> PointsAround(const Point& first) const {
    const Point second = normal_.cross(first);
    std::array<Feature, L> points;
    constexpr S kSine = S(0.86602540378443865);
    points[0] = At(first);
    points[1] = At(S(-0.5) * first + kSine * second);
    points[2] = At(S(-0.5) * first - kSine * second);
    return points;
  }
  Feature At(const Point& tilt) const {
    return difference_.FromFeatures(features_.feature_1, features_.feature_2, normal_ + kTilt * tilt).support;
  }

  const Difference& difference_;
  const Feature& features_;
  Point normal_;
};

/// Tries the faces of both features. If the ray leaves C through one, the inner approximation gets its points.
/// @return whether there is such a face, with its normal.
template <class Difference>
[[gnu::cold, gnu::noinline]] bool FindFlatFace(const Difference& difference,
                                               const DifferencePoint<typename Difference::S, Difference::L>& features,
                                               InnerApproximation<typename Difference::S, Difference::L>& inner,
                                               Vector<typename Difference::S, Difference::L>& normal) {
  std::array<DifferencePoint<typename Difference::S, Difference::L>, Difference::L> corners;
  for (const bool of_first : {true, false}) {
    normal = of_first ? difference.FaceNormal1(features.feature_1) : difference.FaceNormal2(features.feature_2);
    if (FlatFace<Difference>(difference, features, normal).HoldsRay(corners)) {
      inner.AdoptBasis(corners, Difference::L);
      return true;
    }
  }
  return false;
}

}  // namespace dgd
