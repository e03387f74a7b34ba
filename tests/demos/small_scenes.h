// Scenes and files for the tests of the demos, each made by one function.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace dgd_demos {

/// Eight polytopes fall onto the ground and come to rest.
Scene SmallDropScene();

/// A box that slides off a ground too small for it.
Scene LeavingTheWorldScene();

/// The text of a valid scene file with one box, a ground and a short duration. The tests break it in one place each.
std::string ValidSceneText();

/// A folder of its own for the current test, gone when the guard is.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file into the folder.
  std::filesystem::path Write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

std::string ReadFile(const std::filesystem::path& file);

/// The scene files of a folder whose bodies are simulated, in alphabetical order; those of motion planning have none.
std::vector<std::filesystem::path> SimulatedScenes(const std::filesystem::path& folder);

}  // namespace dgd_demos
