// A study: one world or several, simulated with all combinations of seeds, narrowphases, precisions and values. It is
// read from JSON and becomes a list of runs. `headless_sim sweep --help` describes the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene_file.h"

namespace dgd_demos {

/// One run of a study: all that a process needs to carry it out.
struct RunSpec {
  int number;            ///< Index in the study, from 0.
  std::string world;     ///< Name of the world in the study, the same on every machine.
  std::string file;      ///< Path of the world on this machine.
  SceneChanges changes;  ///< Values in place of the scene's; empty for world files.
  std::uint64_t seed;
  std::string narrowphase;                    ///< Name and options, see NarrowphaseChoice::Name().
  std::string precision;                      ///< "float" or "double".
  std::optional<double> duration, time_step;  ///< s, in place of the world's own.
  int oracle_every;                           ///< Steps from one oracle query to the next.

  nlohmann::json ToJson() const;
  /// @throws nlohmann::json::exception if ToJson() has not written the object.
  static RunSpec FromJson(const nlohmann::json& json);
};

struct Study {
  std::string file;                       ///< Path given by the user.
  nlohmann::json document;                ///< The study as it was read.
  std::vector<std::string> narrowphases;  ///< Columns of its tables, in their order.
  std::vector<std::string> varied;  ///< JSON paths that its runs change, in alphabetical order: columns of its CSV.
  std::vector<RunSpec> runs;        ///< Ordered by world, then change, seed, narrowphase and precision.
};

/// Reads a study, and every world of it with all changes, so that a slip shows before the first run.
/// @param own_precision  Precision of this program, used for a study without precisions.
/// @throws SceneError that names file, JSON path and value in the study, or in a world that cannot be read unchanged.
Study LoadStudy(const std::filesystem::path& file, const std::string& own_precision);

}  // namespace dgd_demos
