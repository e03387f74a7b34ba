#include "bench/textbook/plain_algorithm.h"

#include <Eigen/LU>
#include <limits>

#include "bench/textbook/ray_query.h"

namespace dgd_bench {
namespace {

template <int L>
class PlainQuery {
 public:
  using Vector = dgd::Vector<double, L>;
  using Matrix = dgd::SquareMatrix<double, L>;
  using Pose = dgd::Pose<double, L>;
  using Point = typename RayQuery<L>::Point;

  PlainQuery(const SupportFunction<L>& set_1, const Pose& pose_1, const SupportFunction<L>& set_2, const Pose& pose_2,
             double tolerance)
      : ray_(set_1, pose_1, set_2, pose_2, tolerance), basis_(ray_.InitialFacet()) {
    SolveBasis();
    normal_ = ray_.P() / ray_.P().template lpNorm<Eigen::Infinity>();
  }

  void WarmStart(const PlainState<L>& state) {
    for (int i = 0; i < L; ++i) Insert(ray_.FromPoints(state.points_1.col(i), state.points_2.col(i)));
    TakeNormalOfBasis();
  }

  /// Alg. 2.
  void Update() {
    Insert(ray_.Support(normal_));
    TakeNormalOfBasis();
  }

  const RayQuery<L>& Ray() const { return ray_; }

  dgd::Result<double, L> MakeResult(int iterations) const { return ray_.MakeResult(basis_, weights_, iterations); }

  void Remember(PlainState<L>& state) const {
    state.is_empty = false;
    for (int i = 0; i < L; ++i) {
      const Point point{basis_.of_c.col(i), basis_.of_1.col(i)};
      state.points_1.col(i) = ray_.Point1(point);
      state.points_2.col(i) = ray_.Point2(point);
    }
  }

 private:
  /// One step of the simplex method: the point comes in, the first that the ratio test names goes out. With all but the
  /// basis pruned, the second step finds nothing to do.
  void Insert(const Point& point) {
    // Its cost is 1: it enters where the basis would pay more for it.
    const Vector of_point = inverse_ * point.of_c;
    if (of_point.sum() <= 1) return;
    int outgoing = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < L; ++i) {
      if (of_point[i] > 0 && weights_[i] / of_point[i] < least) {
        least = weights_[i] / of_point[i];
        outgoing = i;
      }
    }
    if (outgoing < 0) return;
    basis_.SetCorner(outgoing, point);
    SolveBasis();
  }

  void SolveBasis() {
    inverse_ = basis_.of_c.inverse();
    weights_ = inverse_ * ray_.P();
    ray_.SetLower(1 / weights_.sum());
  }

  /// Eq. (normal-vector), to unit length in the maximum norm.
  void TakeNormalOfBasis() {
    normal_ = inverse_.transpose() * Vector::Ones();
    normal_ /= normal_.template lpNorm<Eigen::Infinity>();
  }

  RayQuery<L> ray_;
  typename RayQuery<L>::Facet basis_;
  Matrix inverse_;  // Of the basis.
  Vector weights_;  // Conic, of p.
  Vector normal_;
};

}  // namespace

template <int L>
dgd::Result<double, L> PlainGrowthDistance(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2,
                                           PlainState<L>* state, double tolerance) {
  PlainQuery<L> query(set_1, pose_1, set_2, pose_2, tolerance);
  if (state != nullptr && !state->is_empty) query.WarmStart(*state);
  int iterations = 0;
  do {
    query.Update();
    ++iterations;
  } while (!query.Ray().HasConverged() && iterations < kMaxIterations);
  if (state != nullptr) query.Remember(*state);
  return query.MakeResult(iterations);
}

template <int L>
dgd::Status PlainCollision(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2) {
  PlainQuery<L> query(set_1, pose_1, set_2, pose_2, dgd::kSqrtEpsilon<double>);
  for (int iterations = 0; iterations < kMaxIterations; ++iterations) {
    query.Update();
    if (query.Ray().Lower() >= 1) return dgd::Status::kColliding;
    if (query.Ray().Upper() < 1) return dgd::Status::kSeparated;
    if (query.Ray().HasConverged()) return dgd::Status::kTouching;
  }
  return dgd::Status::kIterationLimit;
}

#define DGD_BENCH_INSTANTIATE(L)                                                                                 \
  template dgd::Result<double, L> PlainGrowthDistance<L>(const SupportFunction<L>&, const dgd::Pose<double, L>&, \
                                                         const SupportFunction<L>&, const dgd::Pose<double, L>&, \
                                                         PlainState<L>*, double);                                \
  template dgd::Status PlainCollision<L>(const SupportFunction<L>&, const dgd::Pose<double, L>&,                 \
                                         const SupportFunction<L>&, const dgd::Pose<double, L>&);
DGD_BENCH_INSTANTIATE(2)
DGD_BENCH_INSTANTIATE(3)
#undef DGD_BENCH_INSTANTIATE

}  // namespace dgd_bench
