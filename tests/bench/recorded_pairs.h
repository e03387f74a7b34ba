// A record's pairs as the benchmarks take them.
#pragma once

#include "dgd_bullet/record_file.h"
#include "support/pairs/set_numbers.h"

namespace dgd_bench {

dgd_test::SetNumbers SetFrom(const dgd_bullet::RecordedShape& shape);
/// The nearest pose whose axes are orthonormal: those of float are off by 1e-7, which no solver answers for.
dgd_test::PoseNumbers PoseFrom(const dgd_bullet::RecordedPose& pose);

}  // namespace dgd_bench
