#include "bench/textbook/conic.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "bench/textbook/conic_block.h"

namespace dgd_bench {
namespace {

using Eigen::Vector3d;

constexpr int kMaxIterations = 100;
/// The start's scale, where 1 makes the balls inside the sets touch. 1.3 and 4 take as many iterations.
constexpr double kStartScale = 2;
/// Of the way to the border. With 0.9 there are two more iterations, with 0.995 more that stall.
constexpr double kStepShare = 0.99;
/// Of the matrix' trace, added to its diagonal. Where two faces meet, all common points are optimal, and rounding may
/// make the matrix indefinite: without this, 80 of 1e5 pairs in all placements of random_pair.h stall; with it 6, and
/// with ten times as much, which keeps the dual side from getting feasible, 40.
constexpr double kRegularization = 1e-16;
/// A step of less is rounding.
constexpr double kSmallestStep = 1e-9;

/// Minimises a over x and a, with x in both sets scaled by a. Lengths as parts of |p|, the way between the centres, on
/// which set 1's centre is the origin; a as a part of the scale at which the balls inside the sets touch.
class ConicQuery {
 public:
  ConicQuery(const ConicSet& set_1, const dgd::Pose<double>& pose_1, const ConicSet& set_2,
             const dgd::Pose<double>& pose_2, double tolerance)
      : block_1_(set_1),
        block_2_(set_2),
        center_1_(pose_1 * set_1.center),
        center_2_(pose_2 * set_2.center),
        length_((center_2_ - center_1_).norm()),
        p_((center_2_ - center_1_) / length_),
        inradii_(set_1.Inradius() + set_2.Inradius()),
        tolerance_(tolerance) {
    to_set_1_ = ToSet(pose_1);
    to_set_2_ = ToSet(pose_2);
    point_ << set_1.Inradius() / inradii_ * p_, kStartScale;
    Start();
  }

  dgd::Result<double> Solve() {
    int iterations = 0;
    dgd::Status status = dgd::Status::kIterationLimit;
    for (;; ++iterations) {
      Measure();
      if (HasConverged()) {
        status = dgd::Status::kOptimal;
        break;
      }
      if (iterations == kMaxIterations) break;
      if (!Step()) {
        status = dgd::Status::kStalled;
        break;
      }
    }
    return MakeResult(status, iterations);
  }

 private:
  /// From (x, a) to a set's (y, scale).
  Matrix4 ToSet(const dgd::Pose<double>& pose) const {
    Matrix4 map = Matrix4::Zero();
    map.topLeftCorner<3, 3>() = pose.rotation.transpose();
    map(3, 3) = 1 / inradii_;
    return map;
  }

  void Start() {
    block_1_.Start(to_set_1_.topLeftCorner<3, 3>() * point_.head<3>(), point_[3] / inradii_);
    block_2_.Start(to_set_2_.topLeftCorner<3, 3>() * (point_.head<3>() - p_), point_[3] / inradii_);
    const double pull = (block_1_.Pull().of_point[3] + block_2_.Pull().of_point[3]) / inradii_;
    block_1_.ScaleMultipliers(1 / pull);
    block_2_.ScaleMultipliers(1 / pull);
  }

  /// Where the iteration stands, by the multipliers. By the Lagrangian, they bound the scale from below as far as their
  /// pulls on the point cancel; what is left of them costs at most as much as they pull at the way to a centre.
  void Measure() {
    const ConicPull own_1 = block_1_.Pull(), own_2 = block_2_.Pull();
    const Vector4 pull_1 = to_set_1_.transpose() * own_1.of_point, pull_2 = to_set_2_.transpose() * own_2.of_point;
    normal_ = (pull_2 - pull_1).head<3>() / 2;
    lower_ = normal_.dot(p_) / (pull_1[3] + pull_2[3]);
    const double left_over =
        std::max({(pull_1 + pull_2).head<3>().lpNorm<Eigen::Infinity>(), own_1.of_core.lpNorm<Eigen::Infinity>(),
                  own_2.of_core.lpNorm<Eigen::Infinity>()});
    const double reach = std::max(point_.head<3>().norm(), (point_.head<3>() - p_).norm());
    residual_ = reach * left_over / normal_.dot(p_);
    complementarity_ = block_1_.Complementarity() + block_2_.Complementarity();
  }

  /// False for NaN.
  bool HasConverged() const {
    return residual_ <= tolerance_ && point_[3] - lower_ <= (tolerance_ - residual_) * lower_;
  }

  /// Mehrotra's predictor and corrector. @return whether there was a step of any length.
  bool Step() {
    // Nor for NaN: a slack or a multiplier has been rounded out of its cone.
    if (!(complementarity_ > 0)) return false;
    const Matrix4 of_1 = block_1_.Linearize() * to_set_1_, of_2 = block_2_.Linearize() * to_set_2_;
    Matrix4 sum = to_set_1_.transpose() * of_1 + to_set_2_.transpose() * of_2;
    sum.diagonal().array() += kRegularization * sum.trace();
    const Eigen::LLT<Matrix4> matrix(sum);
    if (matrix.info() != Eigen::Success) return false;

    // The predictor's part of first order takes the products of slacks and multipliers down in proportion.
    StepReach reach = FindStep(matrix.solve(-Vector4::UnitW()));
    const double predicted = std::min(reach.steps, 1.0);
    const double left = 1 - predicted + predicted * predicted * reach.curvature / complementarity_;
    const double target = left * left * left * complementarity_ / (block_1_.Degree() + block_2_.Degree());

    const Vector4 right = to_set_1_.transpose() * block_1_.Correct(target) +
                          to_set_2_.transpose() * block_2_.Correct(target) - Vector4::UnitW();
    const Vector4 step = matrix.solve(right);
    const double length = std::min(kStepShare * FindStep(step).steps, 1.0);
    if (!(length > kSmallestStep)) return false;
    block_1_.Take(length);
    block_2_.Take(length);
    point_ += length * step;
    return true;
  }

  StepReach FindStep(const Vector4& step) {
    const StepReach of_1 = block_1_.FindStep(to_set_1_ * step), of_2 = block_2_.FindStep(to_set_2_ * step);
    return {std::min(of_1.steps, of_2.steps), of_1.curvature + of_2.curvature};
  }

  dgd::Result<double> MakeResult(dgd::Status status, int iterations) const {
    const double unit = length_ / inradii_;
    dgd::Result<double> result;
    result.status = status;
    result.iterations = iterations;
    result.upper_bound = unit * point_[3];
    result.lower_bound = std::min(unit * lower_, result.upper_bound);
    result.normal = normal_.normalized();
    result.separation = (1 - 1 / result.lower_bound) * length_ * result.normal.dot(p_);
    // Not as points of the world scaled back, which would lose the digits of centres that nearly coincide.
    const double back = inradii_ / point_[3];
    result.witness_1 = center_1_ + back * point_.head<3>();
    result.witness_2 = center_2_ + back * (point_.head<3>() - p_);
    return result;
  }

  ConicBlock block_1_, block_2_;
  const Vector3d center_1_, center_2_;
  const double length_;  // Metres.
  const Vector3d p_;     // Unit length.
  const double inradii_;
  const double tolerance_;
  Matrix4 to_set_1_, to_set_2_;
  Vector4 point_;  // x, a.

  Vector3d normal_;
  double lower_ = 0, residual_ = 0, complementarity_ = 0;
};

}  // namespace

dgd::Result<double> ConicGrowthDistance(const ConicSet& set_1, const dgd::Pose<double>& pose_1, const ConicSet& set_2,
                                        const dgd::Pose<double>& pose_2, double tolerance) {
  return ConicQuery(set_1, pose_1, set_2, pose_2, tolerance).Solve();
}

}  // namespace dgd_bench
