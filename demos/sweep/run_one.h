// One run of a study, in this process and its precision.
#pragma once

#include "sweep/run_record.h"
#include "sweep/study.h"

namespace dgd_demos {

/// Does not throw: a failure is in the record.
RunRecord RunOne(const RunSpec& spec);

}  // namespace dgd_demos
