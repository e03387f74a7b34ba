// What the programs that simulate scenes have in common on their command lines: where the scenes are, how long they
// run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "command_line.h"
#include "scene/scene_file.h"

namespace dgd_demos {

/// Path of a file of this project, such as "scenes/arch.json": in the working directory, among an installed program's
/// data, or in the source tree that the program was built from; `name` itself if there is none, so that its absence is
/// reported like any other file's.
std::filesystem::path FindData(const std::filesystem::path& name);

/// Whether a world is given by the name of a scene of this project ("tower_20") and not by a file's.
bool IsSceneName(const std::filesystem::path& world);

/// What is wrong with a scene's name that no scene has.
inline constexpr const char* kNoSuchScene =
    "there is no such scene; `headless_sim list` names those that come with this program, and files of your own are "
    "given with folder or ending";

/// Adds --duration.
void AddDurationOption(CommandLine& line, std::optional<double>& duration);

/// Adds --out and --overwrite.
void AddOutOption(CommandLine& line, std::filesystem::path& out, bool& overwrite, const std::string& default_folder);
/// After parsing. The default folder has what was made last: what others have left there is replaced.
void CompleteOut(std::filesystem::path& out, bool& overwrite, const std::string& default_folder);

inline constexpr int kMaxOracleEvery = 1'000'000;  ///< Steps.

/// Adds --oracle-every.
void AddOracleEveryOption(CommandLine& line, int& oracle_every);

/// @throws SceneError unless the duration is from one time step up to kMaxDuration and to kMaxSteps of them.
void CheckDuration(double duration, double time_step);

/// Gives a scene the requested duration, if any, in place of its own.
/// @throws SceneError about a duration that it cannot have.
void SetDuration(Scene& scene, const std::optional<double>& duration);

/// The scene of the file, with the requested duration, if any.
/// @throws SceneError about the file, or about a duration that it cannot have.
Scene LoadSceneFor(const std::filesystem::path& file, const std::optional<double>& duration);

}  // namespace dgd_demos
