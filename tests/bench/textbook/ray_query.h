// What the paper's algorithm as printed and the internal expanding procedure have in common: the ray from 0 along
// p = p2 - p1 against C = (C1 - p1) - (C2 - p2) (paper, Prop. 1), in coordinates of the world about the centres, and
// the two bounds on its length in C.
#pragma once

#include <limits>

#include "bench/textbook/ray_facet.h"
#include "bench/textbook/support_function.h"
#include "dgd/query_types.h"

namespace dgd_bench {

/// Most evaluations of the support functions by an algorithm of this folder that asks them.
inline constexpr int kMaxIterations = 100;

template <int L>
class RayQuery {
 public:
  using Vector = dgd::Vector<double, L>;
  using Matrix = dgd::SquareMatrix<double, L>;
  using Pose = dgd::Pose<double, L>;

  using Point = RayPoint<L>;
  using Facet = RayFacet<L>;

  /// The sets and poses must outlive this.
  RayQuery(const SupportFunction<L>& set_1, const Pose& pose_1, const SupportFunction<L>& set_2, const Pose& pose_2,
           double tolerance)
      : set_1_(set_1),
        set_2_(set_2),
        pose_1_(pose_1),
        pose_2_(pose_2),
        center_1_(pose_1 * set_1.Center()),
        center_2_(pose_2 * set_2.Center()),
        p_(center_2_ - center_1_),
        tolerance_(tolerance) {}

  const Vector& P() const { return p_; }

  /// Alg. 1.
  Facet InitialFacet() const { return dgd_bench::InitialFacet<L>(p_, set_1_.Inradius(), set_2_.Inradius()); }

  /// The support point of C, and what its plane says of the ray's length (eq. ray-intersection-upper-bound).
  /// @param normal  Of any length but 0.
  Point Support(const Vector& normal) {
    const Point support = FromPoints(set_1_.Support(pose_1_.rotation.transpose() * normal),
                                     set_2_.Support(pose_2_.rotation.transpose() * -normal));
    const double upper = normal.dot(support.of_c) / normal.dot(p_);
    if (upper < upper_) {
      upper_ = upper;
      best_normal_ = normal;
    }
    return support;
  }

  /// From points in the sets' own frames, and back.
  Point FromPoints(const Vector& point_1, const Vector& point_2) const {
    const Vector of_1 = pose_1_ * point_1 - center_1_;
    return {of_1 - (pose_2_ * point_2 - center_2_), of_1};
  }
  Vector Point1(const Point& point) const {
    return pose_1_.rotation.transpose() * (center_1_ + point.of_1 - pose_1_.translation);
  }
  Vector Point2(const Point& point) const {
    return pose_2_.rotation.transpose() * (center_2_ + point.of_1 - point.of_c - pose_2_.translation);
  }

  /// Of the ray's length in C over |p|.
  double Lower() const { return lower_; }
  double Upper() const { return upper_; }
  void SetLower(double lower) { lower_ = lower; }
  bool HasConverged() const { return upper_ / lower_ - 1 < tolerance_; }

  /// @param facet    The ray meets it at Lower().
  /// @param weights  Conic, of p in the facet's corners.
  dgd::Result<double, L> MakeResult(const Facet& facet, const Vector& weights, int iterations) const {
    dgd::Result<double, L> result;
    result.status = HasConverged() ? dgd::Status::kOptimal : dgd::Status::kIterationLimit;
    result.iterations = iterations;
    result.lower_bound = 1 / upper_;
    result.upper_bound = 1 / lower_;
    result.normal = best_normal_.normalized();
    result.separation = (1 - upper_) * result.normal.dot(p_);
    result.witness_1 = center_1_ + lower_ * (facet.of_1 * weights);
    result.witness_2 = center_2_ + lower_ * ((facet.of_1 - facet.of_c) * weights);
    return result;
  }

 private:
  const SupportFunction<L>& set_1_;
  const SupportFunction<L>& set_2_;
  const Pose& pose_1_;
  const Pose& pose_2_;
  const Vector center_1_, center_2_, p_;
  const double tolerance_;
  Vector best_normal_ = Vector::UnitX();
  double lower_ = 0, upper_ = std::numeric_limits<double>::infinity();
};

}  // namespace dgd_bench
