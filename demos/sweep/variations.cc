#include "sweep/variations.h"

#include <cstddef>
#include <string>

#include "scene/scene_error.h"

namespace dgd_demos {
namespace {

std::vector<Variation> ReadList(const JsonReader& vary) {
  std::vector<Variation> list;
  for (std::size_t i = 0; i < vary.Size(); ++i) {
    const JsonReader entry = vary.At(i);
    Variation& variation = list.emplace_back(Variation{{}, {}, entry});
    for (const std::string& path : entry.Keys()) {
      variation.changes.emplace_back(path, entry.At(path).value());
      variation.places.push_back(entry.At(path));
    }
  }
  if (list.empty()) vary.Fail("must hold at least one entry");
  vary.ExpectDistinct();
  return list;
}

// The variations with each of the values at the path.
std::vector<Variation> Combine(const std::vector<Variation>& variations, const std::string& path,
                               const JsonReader& values) {
  std::vector<Variation> finer;
  for (const Variation& coarse : variations) {
    for (std::size_t i = 0; i < values.Size(); ++i) {
      Variation& variation = finer.emplace_back(coarse);
      variation.changes.emplace_back(path, values.At(i).value());
      variation.places.push_back(values.At(i));
    }
  }
  return finer;
}

std::vector<Variation> ReadGrid(const JsonReader& vary, std::size_t most) {
  std::vector<Variation> grid = {{{}, {}, vary}};
  for (const std::string& path : vary.Keys()) {
    const JsonReader values = vary.At(path);
    if (values.Size() == 0) values.Fail("must hold at least one value");
    values.ExpectDistinct();
    if (grid.size() * values.Size() > most) vary.Fail("has more than " + std::to_string(most) + " combinations");
    grid = Combine(grid, path, values);
  }
  return grid;
}

bool CanBeRead(const std::filesystem::path& scene, const SceneChanges& changes) try {
  LoadScene(scene, changes);
  return true;
} catch (const SceneError&) {
  return false;
}

// The change without which the scene can be read; the combination if there is no such change.
const JsonReader& PlaceOfSlip(const std::filesystem::path& scene, const Variation& variation) {
  for (std::size_t i = 0; i < variation.changes.size(); ++i) {
    SceneChanges others = variation.changes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (CanBeRead(scene, others)) return variation.places[i];
  }
  return variation.place;
}

}  // namespace

std::vector<Variation> ReadVariations(const JsonReader& vary, std::size_t most) {
  return vary.IsArray() ? ReadList(vary) : ReadGrid(vary, most);
}

Scene LoadVariedScene(const std::filesystem::path& file, const Variation& variation) try {
  return LoadScene(file, variation.changes);
} catch (const SceneError& error) {
  LoadScene(file);  // Throws if the scene itself cannot be read.
  PlaceOfSlip(file, variation).Fail(error.what());
}

}  // namespace dgd_demos
