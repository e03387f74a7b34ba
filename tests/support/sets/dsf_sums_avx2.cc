// Compiled for AVX2, without FMA: one roundoff per operation, so that all processors find the same points.
#include "support/sets/dsf_sums.h"

namespace dgd_test::dsf_internal {

void SumAvx2(const double* offsets, std::size_t blocks, const double* direction, const Powers& powers, bool with_spread,
             Sums& sums) {
  Sum(offsets, blocks, direction, powers, with_spread, sums);
}

}  // namespace dgd_test::dsf_internal
