// IE, the internal expanding procedure (paper, Sec. I, [zheng2010fast] and [zheng2013ray]): from a simplex
// in C = (C1 - p1) - (C2 - p2) that contains the origin, outwards.
//
// The ray leaves the simplex through a facet. The support point along that facet's normal and the facet span the next
// simplex, whose other three facets are made; the ray leaves it through the one of them whose plane it meets first.
// That plane is the primal bound, the supporting plane the dual one. Where the paper's algorithm makes a step of the
// simplex method, this makes facets: three normals an iteration and no inverse, and the weights of the facet's corners
// once, at the end. By callgrind that is as many instructions as the plain algorithm's (515 an iteration against 523 on
// curved primitives, their support functions included), but less time: the three normals do not wait for each other, as
// inverse, weights and ratio test do.
//
// As for the IE that the paper compares with, the start (Alg. 1) and the criterion of convergence are those of its own
// algorithm (Sec. IV-A). IE has no warm start (Tab. I).
#pragma once

#include "bench/textbook/support_function.h"
#include "dgd/query_types.h"
#include "dgd/solver/tolerances.h"

namespace dgd_bench {

/// Growth distance of two sets, at least one with an inradius above 0 and with centres apart. Statuses: kOptimal,
/// kIterationLimit (also where rounding lets the simplex expand no further).
/// @param tolerance  Relative gap of the bounds below which they are optimal; > 0.
dgd::Result<double> InternalExpanding(const SupportFunction<3>& set_1, const dgd::Pose<double>& pose_1,
                                      const SupportFunction<3>& set_2, const dgd::Pose<double>& pose_2,
                                      double tolerance = dgd::kSqrtEpsilon<double>);

}  // namespace dgd_bench
