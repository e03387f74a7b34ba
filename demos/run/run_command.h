// A world in Bullet, on one narrowphase or the other or both, measured and drawn.
#pragma once

#include "exit_status.h"
#include "run/run_options.h"

namespace dgd_demos {

/// @throws SceneError, std::runtime_error, std::invalid_argument
ExitStatus Run(const RunOptions& options);

}  // namespace dgd_demos
