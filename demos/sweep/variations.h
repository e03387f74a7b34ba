// The values of scenes that a study varies, and where the study has them.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/json_reader.h"
#include "scene/scene_file.h"

namespace dgd_demos {

/// One combination of values. A view of the study: it must not outlive its document.
struct Variation {
  SceneChanges changes;
  std::vector<JsonReader> places;  ///< Place of each change.
  JsonReader place;                ///< Place of the combination: an entry of a list, or the whole grid.
};

/// Reads an object of lists, which is a grid of all combinations of their entries, or an array of objects, which is a
/// list of combinations.
/// @param most  the greatest number of combinations.
/// @throws SceneError that names the study, the place and the value.
std::vector<Variation> ReadVariations(const JsonReader& vary, std::size_t most);

/// Reads a scene with the changes.
/// @throws SceneError about the scene itself; about a change, it names the study and the change's place before the
/// scene's complaint.
Scene LoadVariedScene(const std::filesystem::path& file, const Variation& variation);

}  // namespace dgd_demos
