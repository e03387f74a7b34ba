// `headless_sim render`: pictures of a trajectory that a run has left.
#pragma once

#include "exit_status.h"
#include "run/render_options.h"

namespace dgd_demos {

/// @throws SceneError about the world or the trajectory; std::runtime_error if a picture cannot be written.
ExitStatus Render(const RenderOptions& options);

}  // namespace dgd_demos
