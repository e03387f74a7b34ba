#include "bench/textbook/plain_algorithm.h"

#include "bench/textbook/ray_basis.h"
#include "bench/textbook/ray_query.h"

namespace dgd_bench {
namespace {

template <int L>
class PlainQuery {
 public:
  using Vector = dgd::Vector<double, L>;
  using Pose = dgd::Pose<double, L>;

  PlainQuery(const SupportFunction<L>& set_1, const Pose& pose_1, const SupportFunction<L>& set_2, const Pose& pose_2,
             double tolerance)
      : ray_(set_1, pose_1, set_2, pose_2, tolerance),
        basis_(ray_.P(), ray_.InitialFacet()),
        normal_(ray_.P() / ray_.P().template lpNorm<Eigen::Infinity>()) {
    ray_.SetLower(basis_.Lower());
  }

  void WarmStart(const PlainState<L>& state) {
    for (int i = 0; i < L; ++i) basis_.Insert(ray_.FromPoints(state.points_1.col(i), state.points_2.col(i)));
    TakeBasis();
  }

  /// Alg. 2.
  void Update() {
    basis_.Insert(ray_.Support(normal_));
    TakeBasis();
  }

  const RayQuery<L>& Ray() const { return ray_; }

  dgd::Result<double, L> MakeResult(int iterations) const {
    return ray_.MakeResult(basis_.Facet(), basis_.Weights(), iterations);
  }

  void Remember(PlainState<L>& state) const {
    state.is_empty = false;
    for (int i = 0; i < L; ++i) {
      const RayPoint<L> point{basis_.Facet().of_c.col(i), basis_.Facet().of_1.col(i)};
      state.points_1.col(i) = ray_.Point1(point);
      state.points_2.col(i) = ray_.Point2(point);
    }
  }

 private:
  /// The bound, and the normal to unit length in the maximum norm.
  void TakeBasis() {
    ray_.SetLower(basis_.Lower());
    normal_ = basis_.Normal();
    normal_ /= normal_.template lpNorm<Eigen::Infinity>();
  }

  RayQuery<L> ray_;
  RayBasis<L> basis_;
  Vector normal_;
};

}  // namespace

template <int L>
dgd::Result<double, L> PlainGrowthDistance(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2,
                                           PlainState<L>* state, const dgd::Settings<double>& settings) {
  PlainQuery<L> query(set_1, pose_1, set_2, pose_2, settings.relative_tolerance);
  if (state != nullptr && !state->is_empty) query.WarmStart(*state);
  int iterations = 0;
  do {
    query.Update();
    ++iterations;
  } while (!query.Ray().HasConverged() && iterations < settings.max_iterations);
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
                                                         PlainState<L>*, const dgd::Settings<double>&);          \
  template dgd::Status PlainCollision<L>(const SupportFunction<L>&, const dgd::Pose<double, L>&,                 \
                                         const SupportFunction<L>&, const dgd::Pose<double, L>&);
DGD_BENCH_INSTANTIATE(2)
DGD_BENCH_INSTANTIATE(3)
#undef DGD_BENCH_INSTANTIATE

}  // namespace dgd_bench
