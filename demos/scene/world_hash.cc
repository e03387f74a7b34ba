#include "scene/world_hash.h"

#include <nlohmann/json.hpp>

#include "report/whole_file.h"
#include "scene/json_reader.h"

namespace dgd_demos {
namespace {

using nlohmann::json;

// @param folder  of the scene, where the paths of its meshes begin.
void AppendMeshes(const json& value, const std::filesystem::path& folder, std::string& content) {
  if (value.is_object() && value.value("type", json()) == "mesh" && value.value("file", json()).is_string()) {
    content += ReadWholeFile(folder / value["file"].get<std::string>());
  }
  if (!value.is_structured()) return;
  for (const json& inner : value) AppendMeshes(inner, folder, content);
}

}  // namespace

std::string HashOfWorld(const std::filesystem::path& file) {
  std::string content = ReadWholeFile(file);
  if (file.extension() == ".json") AppendMeshes(ParseJsonFile(file), file.parent_path(), content);
  return HashOf(content);
}

}  // namespace dgd_demos
