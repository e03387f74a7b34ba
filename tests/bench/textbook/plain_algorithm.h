// The paper's algorithms 1 to 3 as they are printed, in two and three dimensions and in double, with nothing of what
// dgd_core does besides. Virtual support functions with the margin inside, coordinates of the world,
// one step of the simplex method an iteration, the basis as a matrix that Eigen inverts.
#pragma once

#include "bench/textbook/support_function.h"
#include "dgd/query_types.h"

namespace dgd_bench {

/// The last basis, in the sets' own frames, for a primal warm start (paper, Sec. III-D3).
template <int L>
struct PlainState {
  dgd::SquareMatrix<double, L> points_1 = dgd::SquareMatrix<double, L>::Zero();  ///< Columns, metres.
  dgd::SquareMatrix<double, L> points_2 = points_1;
  bool is_empty = true;
};

/// Growth distance of two sets, at least one with an inradius above 0 and with centres apart. Statuses: kOptimal,
/// kIterationLimit.
/// @param state     In and out; nullptr for a cold start that remembers nothing.
/// @param settings  Its tolerance and limit of iterations.
template <int L>
dgd::Result<double, L> PlainGrowthDistance(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2,
                                           PlainState<L>* state = nullptr, const dgd::Settings<double>& settings = {});

/// Whether the sets have a point in common (paper, Sec. III-D4): kSeparated, kColliding or kTouching, else
/// kIterationLimit.
template <int L>
dgd::Status PlainCollision(const SupportFunction<L>& set_1, const dgd::Pose<double, L>& pose_1,
                           const SupportFunction<L>& set_2, const dgd::Pose<double, L>& pose_2);

}  // namespace dgd_bench
