// What an answer of any algorithm is worth, by dgd/certificate.h.
#pragma once

#include "bench/growth_pair.h"
#include "support/pairs/any_pair.h"

namespace dgd_bench {

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
