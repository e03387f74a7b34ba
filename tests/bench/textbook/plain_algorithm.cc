#include "bench/textbook/plain_algorithm.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "dgd/ray/minkowski_difference.h"

namespace dgd_bench {
namespace {

constexpr double kTolerance = dgd::kSqrtEpsilon<double>;
constexpr int kMaxIterations = 100;

/// The ray from 0 along p against C = (C1 - p1) - (C2 - p2).
template <int L>
class PlainQuery {
 public:
  using Vector = dgd::Vector<double, L>;
  using Matrix = dgd::SquareMatrix<double, L>;
  using Pose = dgd::Pose<double, L>;

  PlainQuery(const SupportFunction<L>& set_1, const Pose& pose_1, const SupportFunction<L>& set_2, const Pose& pose_2)
      : set_1_(set_1),
        set_2_(set_2),
        pose_1_(pose_1),
        pose_2_(pose_2),
        center_1_(pose_1 * set_1.Center()),
        center_2_(pose_2 * set_2.Center()),
        p_(center_2_ - center_1_) {}

  /// Alg. 1: a facet across the ray with its corners on the ball of the inradius.
  void Initialize() {
    const double inradius_1 = set_1_.Inradius(), inradius = inradius_1 + set_2_.Inradius();
    const Matrix frame = dgd::FrameAlong<double>(Vector(p_.normalized()));
    const double sine = std::sqrt(3.0) / 2;
    for (int i = 0; i < L; ++i) {
      Vector corner = Vector::Constant(0.5);
      const double turn = 2 * std::numbers::pi * i / L;
      corner[0] = sine * std::cos(turn);
      if constexpr (L == 3) corner[1] = sine * std::sin(turn);
      basis_.col(i) = inradius * (frame * corner);
      on_1_.col(i) = inradius_1 / inradius * basis_.col(i);
    }
    SolveBasis();
    normal_ = p_ / p_.template lpNorm<Eigen::Infinity>();
  }

  void WarmStart(const PlainState<L>& state) {
    for (int i = 0; i < L; ++i) {
      const Vector on_1 = pose_1_ * Vector(state.points_1.col(i)) - center_1_;
      Insert(on_1 - (pose_2_ * Vector(state.points_2.col(i)) - center_2_), on_1);
    }
    TakeNormalOfBasis();
  }

  /// Alg. 2.
  void Update() {
    const Vector on_1 = pose_1_ * set_1_.Support(pose_1_.rotation.transpose() * normal_) - center_1_;
    const Vector on_2 = pose_2_ * set_2_.Support(pose_2_.rotation.transpose() * -normal_) - center_2_;
    const Vector z = on_1 - on_2;
    const double upper = normal_.dot(z) / normal_.dot(p_);
    if (upper < upper_) {
      upper_ = upper;
      best_normal_ = normal_;
    }
    Insert(z, on_1);
    TakeNormalOfBasis();
  }

  double Lower() const { return lower_; }
  double Upper() const { return upper_; }
  bool HasConverged() const { return upper_ / lower_ - 1 < kTolerance; }

  dgd::Result<double, L> MakeResult(int iterations) const {
    dgd::Result<double, L> result;
    result.status = HasConverged() ? dgd::Status::kOptimal : dgd::Status::kIterationLimit;
    result.iterations = iterations;
    result.lower_bound = 1 / upper_;
    result.upper_bound = 1 / lower_;
    result.normal = best_normal_.normalized();
    result.separation = (1 - upper_) * result.normal.dot(p_);
    result.witness_1 = center_1_ + lower_ * (on_1_ * weights_);
    result.witness_2 = center_2_ + lower_ * ((on_1_ - basis_) * weights_);
    return result;
  }

  void Remember(PlainState<L>& state) const {
    state.is_empty = false;
    for (int i = 0; i < L; ++i) {
      state.points_1.col(i) = pose_1_.rotation.transpose() * (center_1_ + on_1_.col(i) - pose_1_.translation);
      state.points_2.col(i) =
          pose_2_.rotation.transpose() * (center_2_ + on_1_.col(i) - basis_.col(i) - pose_2_.translation);
    }
  }

 private:
  /// One step of the simplex method: the point comes in, the first that the ratio test names goes out. With all but the
  /// basis pruned, the second step finds nothing to do.
  void Insert(const Vector& z, const Vector& on_1) {
    // Its cost is 1: it enters where the basis would pay more for it.
    const Vector of_z = inverse_ * z;
    if (of_z.sum() <= 1) return;
    int outgoing = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < L; ++i) {
      if (of_z[i] > 0 && weights_[i] / of_z[i] < least) {
        least = weights_[i] / of_z[i];
        outgoing = i;
      }
    }
    if (outgoing < 0) return;
    basis_.col(outgoing) = z;
    on_1_.col(outgoing) = on_1;
    SolveBasis();
  }

  void SolveBasis() {
    inverse_ = basis_.inverse();
    weights_ = inverse_ * p_;
    lower_ = 1 / weights_.sum();
  }

  /// Eq. (normal-vector), to unit length in the maximum norm.
  void TakeNormalOfBasis() {
    normal_ = inverse_.transpose() * Vector::Ones();
    normal_ /= normal_.template lpNorm<Eigen::Infinity>();
  }

  const SupportFunction<L>& set_1_;
  const SupportFunction<L>& set_2_;
  const Pose& pose_1_;
  const Pose& pose_2_;
  const Vector center_1_, center_2_, p_;
  Matrix basis_, on_1_;  // Columns: points of C, and of set 1, about the centres.
  Matrix inverse_;       // Of the basis.
  Vector weights_;       // Conic, of p.
  Vector normal_, best_normal_ = Vector::UnitX();
  double lower_ = 0, upper_ = std::numeric_limits<double>::infinity();  // Of the ray's length in C over |p|.
};

}  // namespace

template <int L>
dgd::Result<double, L> PlainGrowthDistance(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2,
                                           PlainState<L>* state) {
  PlainQuery<L> query(set_1, pose_1, set_2, pose_2);
  query.Initialize();
  if (state != nullptr && !state->is_empty) query.WarmStart(*state);
  int iterations = 0;
  do {
    query.Update();
    ++iterations;
  } while (!query.HasConverged() && iterations < kMaxIterations);
  if (state != nullptr) query.Remember(*state);
  return query.MakeResult(iterations);
}

template <int L>
dgd::Status PlainCollision(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2) {
  PlainQuery<L> query(set_1, pose_1, set_2, pose_2);
  query.Initialize();
  for (int iterations = 0; iterations < kMaxIterations; ++iterations) {
    query.Update();
    if (query.Lower() >= 1) return dgd::Status::kColliding;
    if (query.Upper() < 1) return dgd::Status::kSeparated;
    if (query.HasConverged()) return dgd::Status::kTouching;
  }
  return dgd::Status::kIterationLimit;
}

#define DGD_BENCH_INSTANTIATE(L)                                                                                 \
  template dgd::Result<double, L> PlainGrowthDistance<L>(const SupportFunction<L>&, const dgd::Pose<double, L>&, \
                                                         const SupportFunction<L>&, const dgd::Pose<double, L>&, \
                                                         PlainState<L>*);                                        \
  template dgd::Status PlainCollision<L>(const SupportFunction<L>&, const dgd::Pose<double, L>&,                 \
                                         const SupportFunction<L>&, const dgd::Pose<double, L>&);
DGD_BENCH_INSTANTIATE(2)
DGD_BENCH_INSTANTIATE(3)
#undef DGD_BENCH_INSTANTIATE

}  // namespace dgd_bench
