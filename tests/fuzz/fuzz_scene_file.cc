// A scene file of any bytes: a scene, or a SceneError that says what is wrong. A scene that is read makes its bodies.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include "fuzz/fuzz_target.h"
#include "scene/bodies.h"
#include "scene/scene_file.h"

namespace dgd_fuzz {
namespace {

/// A folder of this process, with a mesh that scenes may name.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("dgd-fuzz-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
    std::ofstream(path_ / "tetrahedron.obj")
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
    std::ofstream(path_ / "flat.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path Write(const std::uint8_t* data, std::size_t size) const {
    std::filesystem::path file = path_ / "scene.json";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return file;
  }

 private:
  std::filesystem::path path_;
};

int BodyCount(const dgd_demos::Scene& scene) {
  int count = 1;  // The ground.
  for (const dgd_demos::BodyGroup& group : scene.bodies) {
    const auto* polytopes = std::get_if<dgd_demos::RandomPolytopes>(&group);
    count += polytopes != nullptr ? polytopes->count : 1;
  }
  return count;
}

}  // namespace
}  // namespace dgd_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dgd_fuzz;
  static const Folder folder;
  try {
    const dgd_demos::Scene scene = dgd_demos::LoadScene(folder.Write(data, size));
    const int expected = BodyCount(scene);
    constexpr int kMost = 30;  // Ten thousand polytopes are a scene, but take seconds.
    if (expected > kMost) return 0;
    const auto bodies = dgd_demos::MakeBodies(scene, 1);
    if (static_cast<int>(bodies.size()) != expected) Fail("a scene with other bodies than its file says");
    for (const dgd_demos::Body& body : bodies) {
      const bool is_finite = body.pose.position.allFinite() && body.pose.rotation.allFinite() && body.mass >= 0 &&
                             body.motion.velocity.allFinite() && body.margin >= 0;
      if (!is_finite) Fail("a body that is none: " + body.name);
    }
  } catch (const dgd_demos::SceneError& error) {
    if (std::string(error.what()).empty()) Fail("an error that says nothing");
  }
  return 0;
}
