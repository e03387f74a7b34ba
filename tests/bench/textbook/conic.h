// A comparator of the paper's: the growth distance of small primitives as a second-order cone program, solved by an
// interior-point method. After Tracy, Howell and Manchester 2023, "Differentiable Collision Detection for a Set of
// Convex Primitives" (DCol), without the derivatives that are its purpose.
//
// Primal-dual, with the scaling of Nesterov and Todd and the predictor and corrector of Mehrotra, as theirs. Theirs
// starts from a general solver's form (Vandenberghe 2010, "The CVXOPT linear and quadratic cone program solvers"). To
// be fair to the method, this one is made for its problem alone:
//  * A set's constraints stay in its own frame, and what only one set knows, the place of its core's point, is
//  eliminated
//    there: a step factors a matrix of 4 by 4 whatever the sets.
//  * It starts between two balls inside the sets, which is feasible, rather than from two more linear systems; so the
//    primal side is feasible throughout, and its residual need not be computed.
#pragma once

#include "bench/textbook/conic_set.h"
#include "dgd/query_types.h"

namespace dgd_bench {

/// Growth distance of two sets whose centres are apart.
/// @param tolerance  Largest relative gap between primal and dual value, > 0.
/// Statuses: kOptimal; else kIterationLimit or kStalled, where rounding allows no further step, and the rest of the
/// result is where the iteration stopped, which proves nothing. Iterations are the interior-point method's. The bounds
/// are its primal and dual values, so they hold but for rounding.
dgd::Result<double> ConicGrowthDistance(const ConicSet& set_1, const dgd::Pose<double>& pose_1, const ConicSet& set_2,
                                        const dgd::Pose<double>& pose_2, double tolerance = dgd::kSqrtEpsilon<double>);

}  // namespace dgd_bench
