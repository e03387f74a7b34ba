// A study: one world or several, simulated with all combinations of seeds, narrowphases, precisions and values. JSON
// in, a list of runs out. demos/README.md describes the format.
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
  int number;            ///< In the study, from 0.
  std::string world;     ///< As the study names it: for people, and the same on every machine.
  std::string file;      ///< Where that is here.
  SceneChanges changes;  ///< Of the scene; empty for world files.
  std::uint64_t seed;
  std::string narrowphase;                    ///< As NarrowphaseChoice::Name().
  std::string precision;                      ///< "float" or "double".
  std::optional<double> duration, time_step;  ///< s, in place of the world's.
  int oracle_every;                           ///< Steps.

  nlohmann::json ToJson() const;
  /// @throws nlohmann::json::exception on what ToJson() has not written.
  static RunSpec FromJson(const nlohmann::json& json);
};

struct Study {
  std::string file;                       ///< As given by the user.
  nlohmann::json document;                ///< As read.
  std::vector<std::string> narrowphases;  ///< In the order of its tables' columns.
  std::vector<std::string> varied;  ///< JSON paths that its runs change, in alphabetical order: columns of its CSV.
  std::vector<RunSpec> runs;        ///< Worlds first, then changes, seeds, narrowphases and precisions.
};

/// Reads a study, and every scene of it with all changes, so that a slip shows before the first run.
/// @param own_precision  of this program: that of a study without precisions.
/// @throws SceneError that names file, JSON path and value, of the study or of a scene.
Study LoadStudy(const std::filesystem::path& file, const std::string& own_precision);

}  // namespace dgd_demos
