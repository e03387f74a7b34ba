#include "scene_options.h"

#include <sstream>
#include <system_error>
#include <vector>

#include "scene/scene_error.h"

namespace dgd_demos {

std::filesystem::path FindData(const std::filesystem::path& name) {
  std::error_code ignored;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  for (const std::filesystem::path& folder :
       {std::filesystem::path(), program.parent_path() / ".." / DGD_DEMOS_INSTALLED_DATA,
        std::filesystem::path(DGD_DEMOS_SOURCE_DIR)}) {
    if (std::filesystem::exists(folder / name, ignored)) return (folder / name).lexically_normal();
  }
  return name;
}

bool IsSceneName(const std::filesystem::path& world) { return !world.has_extension() && !world.has_parent_path(); }

void AddDurationOption(CommandLine& line, std::optional<double>& duration) {
  line.AddNumber("--duration", "S", duration, kAnyNumber, "Simulated time in s, in place of the scene's");
}

void AddOutOption(CommandLine& line, std::filesystem::path& out, bool& overwrite, const std::string& default_folder) {
  line.AddPath("--out", "DIR", out, "Folder for the results; made if missing. Default: " + default_folder);
  line.AddFlag("--overwrite", overwrite, "Replace the results of another run in DIR");
}

void CompleteOut(std::filesystem::path& out, bool& overwrite, const std::string& default_folder) {
  if (!out.empty()) return;
  out = default_folder;
  overwrite = true;
}

void AddOracleEveryOption(CommandLine& line, int& oracle_every) {
  line.AddNumber("--oracle-every", "N", oracle_every, {1, kMaxOracleEvery},
                 "Steps from one computation of the true penetration to the next");
}

void CheckDuration(double duration, double time_step) {
  const bool in_range = duration >= time_step && duration <= kMaxDuration;  // False for NaN.
  std::ostringstream complaint;
  if (in_range) {
    const double steps = duration / time_step;
    if (steps <= kMaxSteps) return;
    complaint << "--duration: " << duration << " s are " << steps << " time steps of " << time_step
              << " s, and a run has at most " << kMaxSteps;
    throw SceneError(complaint.str());
  }
  complaint << "--duration: must be from one time step (" << time_step << ") up to " << kMaxDuration << " s, not "
            << duration;
  throw SceneError(complaint.str());
}

void SetDuration(Scene& scene, const std::optional<double>& duration) {
  if (duration) scene.duration = *duration;
  CheckDuration(scene.duration, scene.time_step);
  std::erase_if(scene.snapshots, [&](double time) { return time > scene.duration; });
}

Scene LoadSceneFor(const std::filesystem::path& file, const std::optional<double>& duration) {
  Scene scene = LoadScene(file);
  SetDuration(scene, duration);
  return scene;
}

}  // namespace dgd_demos
