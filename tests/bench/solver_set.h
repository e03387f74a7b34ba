// A set as the solver takes it, of either dimension; and the solver's queries on two of them.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include "bench/growth_pair.h"
#include "bench/textbook/support_function.h"
#include "dgd/any_set.h"
#include "dgd/shapes.h"
#include "support/extent.h"
#include "support/pairs/any_pair.h"
#include "support/pairs/with_core.h"
#include "support/sets/dsf.h"

namespace dgd_bench {

/// How a set holds a core: those with memory of their own are referred to, as an app's shapes are; others are copied.
template <class Core>
using Stored = std::conditional_t<std::is_trivially_destructible_v<Core>, Core, dgd::CoreReference<Core>>;

/// Calls use(shared_ptr to the core, rounded set of the core), whose types depend on the numbers'.
template <int L, class Use>
auto WithStoredSet(dgd_test::SetNumbers numbers, const Use& use) {
  // AnySet has no other polytope; large ones climb along their edges all the same.
  if (numbers.type == dgd_test::SetType::kMesh) numbers.type = dgd_test::SetType::kPolytope;
  return dgd_test::WithCore<double, L>(numbers, [&]<class Core>(Core made) {
    const auto core = std::make_shared<const Core>(std::move(made));
    return use(core, dgd::RoundedSet<Stored<Core>>{Stored<Core>(*core), numbers.radius});
  });
}

using PlanePolygon = dgd::OneOf<dgd::Point<double, 2>, dgd::Segment<double, 2>, dgd::Box<double, 2>,
                                dgd::CoreReference<dgd::Polygon<double>>>;
/// A set of the plane: polygons are one type, so that four pairs of types are compiled and not twenty-five.
using PlaneSet = std::variant<dgd::RoundedSet<PlanePolygon>, dgd::RoundedSet<dgd::Ellipse<double>>>;

template <int L>
struct SolverSet {
  std::shared_ptr<const void> core;  ///< That `set` may refer to.
  std::conditional_t<L == 3, dgd::AnySet, PlaneSet> set;
  const dgd_test::Dsf<double>* dsf = nullptr;  ///< The core, if it is one.
  std::unique_ptr<SupportFunction<L>> plain;   ///< The same core, as the paper's algorithm takes it.
  double extent = 0;                           ///< Metres.
};

/// Throws std::invalid_argument for a type of another dimension.
template <int L>
SolverSet<L> MakeSolverSet(const dgd_test::SetNumbers& numbers);

template <int L>
dgd::Result<double, L> SolveGrowth(const SolverSet<L>& set_1, const dgd::Pose<double, L>& pose_1,
                                   const SolverSet<L>& set_2, const dgd::Pose<double, L>& pose_2,
                                   const dgd::Settings<double>& settings, dgd::WarmStart<double, L>* warm_start);
template <int L>
dgd::Status CheckCollision(const SolverSet<L>& set_1, const dgd::Pose<double, L>& pose_1, const SolverSet<L>& set_2,
                           const dgd::Pose<double, L>& pose_2);

/// What an answer of any algorithm is worth, by dgd/certificate.h.
/// @param judge  The pair in the query's poses.
template <int L>
GrowthAnswer CertifiedAnswer(const dgd_test::AnyPair<double, L>& judge, const dgd::Result<double, L>& result) {
  const dgd::Certificate certificate = judge.Certify(result);
  return {.sample = {.iterations = double(result.iterations),
                     .relative_gap = certificate.relative_gap,
                     .primal_infeasibility = certificate.primal_infeasibility,
                     .dual_infeasibility = certificate.dual_infeasibility,
                     .is_failure = result.status != dgd::Status::kOptimal},
          .lower_bound = result.lower_bound,
          .upper_bound = result.upper_bound};
}

}  // namespace dgd_bench
