// The pictures of a comparison: each run at the scene's times, and the end states.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scene/bodies.h"
#include "scene/scene.h"
#include "simulation/drop_run.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {

struct NamedRun {
  Narrowphase narrowphase;
  DropRun run;
};

/// Writes <narrowphase>_t<time>s.png for each snapshot of each run, and end_state.png: both runs side by side, if there
/// are two. At the same moment, all runs are seen from the same place. Moments with a body that is nowhere (not finite)
/// are left out.
/// @throws std::runtime_error if a file cannot be written.
void WritePictures(const Scene& scene, const std::vector<Body>& bodies, std::uint64_t seed,
                   const std::vector<NamedRun>& runs, const std::filesystem::path& folder);

}  // namespace dgd_demos
