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
  using Point = typename Difference::Point;
  using Feature = typename Difference::Feature;
  static_assert(Difference::L == 3, "in the plane no face is a disc");

  /// @param normal  Of the face, ray frame, unit length or zero.
  FlatFace(const Difference& difference, const Feature& features, const Point& normal)
      : difference_(difference), features_(features), normal_(normal) {}

  /// If the ray leaves C through the disc, gives three points of it around the ray.
  bool HoldsRay(std::array<Feature, 3>& corners) const {
    if (!(normal_.z() > kSteep<S>)) return false;
    const Matrix3<S> frame = FrameAlong<S>(normal_);
    corners = PointsAround(frame.col(0));
    const Point center = (corners[0].point + corners[1].point + corners[2].point) / S(3);
    const S rounding = difference_.Rounding();
    const Point on_ray = (normal_.dot(center) + rounding) / normal_.z() * Point::UnitZ();
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

  std::array<Feature, 3> PointsAround(const Point& first) const {
    const Point second = normal_.cross(first);
    std::array<Feature, 3> points;
    constexpr S kSine = ray_internal::kSineOfThirdTurn<S>;
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
                                               const typename Difference::Feature& features,
                                               InnerApproximation<typename Difference::S>& inner,
                                               typename Difference::Point& normal) {
  std::array<typename Difference::Feature, 3> corners;
  for (const bool of_first : {true, false}) {
    // The pose may have been rounded to float: its rotation does not quite keep lengths.
    normal = (of_first ? difference.FaceNormal1(features.feature_1) : difference.FaceNormal2(features.feature_2))
                 .normalized();
    if (FlatFace<Difference>(difference, features, normal).HoldsRay(corners)) {
      inner.AdoptBasis(corners, 3);
      return true;
    }
  }
  return false;
}

}  // namespace dgd
