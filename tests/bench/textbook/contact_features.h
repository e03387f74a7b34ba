// A comparator of the paper's: the growth distance of sets whose support functions are twice differentiable, by
// Newton's method. After Lee, Lee and Lee 2023, "Uncertain Pose Estimation during Contact Tasks using Differentiable
// Contact Features" (DCF), as the paper describes it: the hybrid of Newton's method with an expanding inner
// approximation.
#pragma once

#include <concepts>

#include "bench/textbook/support_function.h"
#include "dgd/query_types.h"

namespace dgd_bench {

/// A core with a support function that is twice differentiable in all directions, or in almost all: one smooth piece.
/// Those of several pieces have flat faces between them.
template <class Core>
concept DifferentiableCore =
    dgd::SmoothCore<Core> && !dgd::FacedCore<Core> && std::same_as<typename Core::Scalar, double>;

class DifferentiableSupportFunction : public SupportFunction<3> {
 public:
  /// The support point, and its derivative by the direction; of any length but 0.
  virtual dgd::CurvedPoint<double> CurvedSupport(const Vector& direction) const = 0;
};

/// Of a set of the solver's.
template <DifferentiableCore Core>
class DifferentiableSupportFunctionOf final : public DifferentiableSupportFunction {
 public:
  explicit DifferentiableSupportFunctionOf(const dgd::RoundedSet<Core>& set) : set_(set), points_(set) {}

  Vector Support(const Vector& direction) const override { return points_.Support(direction); }
  dgd::CurvedPoint<double> CurvedSupport(const Vector& direction) const override {
    dgd::CurvedPoint<double> curved = set_.core.PieceSupport(0, direction);
    const double length = direction.norm();
    const Vector unit = direction / length;
    curved.point += set_.radius * unit;
    curved.derivative += set_.radius / length * (dgd::Matrix3<double>::Identity() - unit * unit.transpose());
    return curved;
  }
  Vector Center() const override { return points_.Center(); }
  double Inradius() const override { return points_.Inradius(); }

 private:
  dgd::RoundedSet<Core> set_;
  SupportFunctionOf<Core> points_;
};

/// Growth distance of two sets, at least one with an inradius above 0 and with centres apart. Statuses: kOptimal,
/// kIterationLimit. An iteration is an evaluation of both support functions, with or without derivatives.
/// @param tolerance  Largest relative gap of an optimal result, > 0. The original ends at a small gradient; here the
///                   gradient is turned into a bound, so that all methods are held to the same.
dgd::Result<double> ContactFeatureGrowthDistance(const DifferentiableSupportFunction& set_1,
                                                 const dgd::Pose<double>& pose_1,
                                                 const DifferentiableSupportFunction& set_2,
                                                 const dgd::Pose<double>& pose_2,
                                                 double tolerance = dgd::kSqrtEpsilon<double>);

}  // namespace dgd_bench
