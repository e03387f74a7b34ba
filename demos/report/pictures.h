// The pictures of a comparison: each run at the times of its snapshots, and the end states.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/world_view.h"
#include "simulation/drop_run.h"
#include "simulation/narrowphase.h"

namespace dgd_demos {

inline constexpr int kPictureWidth = 1280, kPictureHeight = 720;  ///< Pixels.

struct NamedRun {
  Narrowphase narrowphase;
  DropRun run;
};

/// Writes <narrowphase>_t<time>s.png for each snapshot of each run, and end_state.png: both runs side by side, if there
/// are two. At the same moment, all runs are seen from the same place. Moments with a body that is nowhere (not finite)
/// are left out.
/// A stop that is requested (StopSignals) leaves out those that are left.
/// @param seed  of a scene's random bodies, for the subtitles; none for world files.
/// @throws std::runtime_error if a file cannot be written.
void WritePictures(const WorldView& view, std::optional<std::uint64_t> seed, const std::vector<NamedRun>& runs,
                   const std::filesystem::path& folder);

/// Names for pictures at these times, s: "t00.50s.png", with as many decimals as it takes to tell them apart.
std::vector<std::string> PictureNames(const std::vector<double>& times);
bool IsPictureName(std::string_view name);

/// "t = 0.50 s", for subtitles.
std::string TimeText(double time);

}  // namespace dgd_demos
